// SPDX-License-Identifier: BSD-3-Clause
#include "io/kinds/file_kind.h"

namespace ridgeline::io {

std::string advice_on(FileGroup group) {
  using enum FileGroup;
  switch (group) {
    case kCloud:
      return "give it as --cloud, or as lidar in a patch file";
    case kLines:
    case kModel:
    case kLineFolder:
      return "give it as --lines";
    case kPly:
    case kNumbers:
      return "give it as --cloud or --lines";
    case kImage:
      return "name it under images in a patch file";
    case kPatch:
      return "give it to run, or as --patch";
    case kBlock:
      return "give it to block";
    case kGates:
      return "give it as --gates";
    case kConfig:
      return "give it as --config";
    case kMatches:
      return "give it as --matches to reconstruct";
    case kReferenceMatches:
      return "name it as reference_matches in a patch file";
    case kReferenceTracks:
      return "name it as reference_tracks in a patch file";
    case kSegments:
      return "leave it beside its matches.csv, where reconstruct finds it";
    case kOrientation:
      return "ridgeline info shows it, and a patch file names it as orientation";
    case kEvaluation:
    case kResult:
      return "give the folder that it lies in, to gate, compare or report";
    case kResultFolder:
      return "give it to gate, compare or report";
    default:
      return "";
  }
}

}  // namespace ridgeline::io
