// SPDX-License-Identifier: BSD-3-Clause
#include "io/kinds/file_kind.h"

#include <algorithm>

namespace ridgeline::io {
namespace {

using enum FileGroup;

// Numbers without column names are left to the table readers, which name the missing column.
constexpr std::array kGroups{
    GroupInfo{},
    GroupInfo{kCloud,
              "give it as `cloud`, or as lidar in a patch file",
              "a point cloud",
              "supported formats are LAS, LAZ, COPC, PCD, PLY and x y z text",
              {kPly, kNumbers}},
    GroupInfo{kLines,
              "give it as `lines`",
              "a file of 3D lines",
              "supported formats are GeoJSON, GeoPackage, Shapefile, DXF, CSV, WKT, OBJ, PLY, "
              "CityJSON and CityGML",
              {kPly, kNumbers, kLineFolder, kModel}},
    GroupInfo{kModel, "give it as `lines`"},
    GroupInfo{kLineFolder, "give it as `lines`"},
    GroupInfo{kPly, "give it as `cloud` or `lines`"},
    GroupInfo{kNumbers, "give it as `cloud` or `lines`"},
    GroupInfo{kImage, "name it under images in a patch file", "an image",
              "supported formats are TIFF, PNG, JPEG and JPEG 2000"},
    GroupInfo{kPatch, "give it to run, or as `patch`", "a patch file (patch.yaml)"},
    GroupInfo{kBlock, "give it to block", "a block file (block.yaml)"},
    GroupInfo{kGates, "give it as `gates`", "a gates file",
              "a gates file is expected, as gate `init` prints it"},
    GroupInfo{kConfig, "give it as `config`", "a config file",
              "a config file is expected (ridgeline config prints one)"},
    GroupInfo{kMatches,
              "give it as `matches` to reconstruct",
              "a table of matches (matches.csv)",
              "",
              {kNumbers}},
    GroupInfo{kReferenceMatches,
              "name it as reference_matches in a patch file",
              "a table of reference matches",
              "",
              {kMatches, kNumbers}},
    GroupInfo{kReferenceTracks,
              "name it as reference_tracks in a patch file",
              "a table of reference tracks",
              "",
              {kNumbers}},
    GroupInfo{kSegments,
              "keep it next to its matches.csv, where reconstruct finds it",
              "a table of segments (segments.IMAGE.csv)",
              "",
              {kNumbers}},
    GroupInfo{kOrientation,
              "show it with ridgeline info, or name it as orientation in a patch file",
              "an orientation of images",
              "supported orientations are tables of omega, phi and kappa, OpenSfM, Pix4D, Inpho, "
              "PAT-B, BlocksExchange, Metashape XML and COLMAP",
              {kNumbers}},
    GroupInfo{kEvaluation, "give its folder to gate, compare or report"},
    GroupInfo{kResult, "give its folder to gate, compare or report"},
    GroupInfo{kResultFolder, "give it to gate, compare or report", "a results folder",
              "the `out` of run, block, demo, evaluate or pool is expected"}};

}  // namespace

const GroupInfo& info_of(FileGroup group) {
  const auto* const found = std::ranges::find(kGroups, group, &GroupInfo::group);
  return found == kGroups.end() ? kGroups.front() : *found;
}

}  // namespace ridgeline::io
