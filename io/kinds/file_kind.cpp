// SPDX-License-Identifier: BSD-3-Clause
#include "io/kinds/file_kind.h"

#include <algorithm>

namespace ridgeline::io {
namespace {

using enum FileGroup;

// Numbers without names of columns are left to the readers of tables, which name the missing
// column.
constexpr std::array kGroups{
    GroupInfo{},
    GroupInfo{kCloud,
              "give it as `cloud`, or as lidar in a patch file",
              "a point cloud",
              "point clouds are read from LAS, LAZ, COPC, PCD, PLY and x y z text",
              {kPly, kNumbers}},
    GroupInfo{kLines,
              "give it as `lines`",
              "a file of 3D lines",
              "lines are read from GeoJSON, GeoPackage, Shapefile, DXF, CSV, WKT, OBJ, PLY, "
              "CityJSON and CityGML",
              {kPly, kNumbers, kLineFolder, kModel}},
    GroupInfo{kModel, "give it as `lines`"},
    GroupInfo{kLineFolder, "give it as `lines`"},
    GroupInfo{kPly, "give it as `cloud` or `lines`"},
    GroupInfo{kNumbers, "give it as `cloud` or `lines`"},
    GroupInfo{kImage, "name it under images in a patch file", "an image",
              "images are read from TIFF, PNG, JPEG and JPEG 2000"},
    GroupInfo{kPatch, "give it to run, or as `patch`", "a patch file (patch.yaml)"},
    GroupInfo{kBlock, "give it to block", "a block file (block.yaml)"},
    GroupInfo{kGates, "give it as `gates`", "a gates file",
              "a gates file is expected, as gate `init` prints it"},
    GroupInfo{kConfig, "give it as `config`", "a config file",
              "a config file is expected, as ridgeline config prints it"},
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
              "leave it beside its matches.csv, where reconstruct finds it",
              "a table of segments (segments.IMAGE.csv)",
              "",
              {kNumbers}},
    GroupInfo{kOrientation,
              "ridgeline info shows it, and a patch file names it as orientation",
              "an orientation of images",
              "an orientation is read from a table of omega, phi and kappa, OpenSfM, Pix4D, Inpho, "
              "PAT-B, BlocksExchange, Metashape's XML and COLMAP",
              {kNumbers}},
    GroupInfo{kEvaluation, "give the folder that it lies in, to gate, compare or report"},
    GroupInfo{kResult, "give the folder that it lies in, to gate, compare or report"},
    GroupInfo{kResultFolder, "give it to gate, compare or report", "a folder of results",
              "the `out` of run, demo or evaluate is expected"}};

}  // namespace

const GroupInfo& info_of(FileGroup group) {
  const auto* const found = std::ranges::find(kGroups, group, &GroupInfo::group);
  return found == kGroups.end() ? kGroups.front() : *found;
}

}  // namespace ridgeline::io
