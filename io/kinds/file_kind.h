// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace ridgeline::io {

/// Kinds of files and folders, grouped by the readers that take them.
enum class FileGroup : std::uint8_t {
  kUnknown,
  kEmpty,
  kCloud,
  kPly,  ///< a cloud, a mesh or lines
  kLines,
  kModel,    ///< of buildings, by their faces
  kNumbers,  ///< rows of numbers: a cloud, or the lines of some tool
  kImage,
  kPatch,
  kBlock,
  kGates,
  kConfig,
  kMatches,
  kReferenceMatches,
  kReferenceTracks,
  kSegments,
  kOrientation,  ///< where images were taken, by an aerotriangulation
  kEvaluation,   ///< evaluation.METHOD.json
  kResult,       ///< another file of a folder of results
  kResultFolder,
  kPatchFolder,
  kLineFolder,  ///< LIMAP's tracks
  kFolder,
  kOther  ///< known, but never read
};

struct FileKind {
  FileGroup group = FileGroup::kUnknown;
  std::string what = {};    ///< "a LAS point cloud"
  std::string advice = {};  ///< what the user may do with the file; may be empty
  /// Ending of the name by which the reader of such lines is chosen; may be empty.
  std::string ending = {};
  bool by_name = false;  ///< the name alone tells; the content is not known

  [[nodiscard]] bool is_known() const {
    return group != FileGroup::kUnknown && group != FileGroup::kEmpty;
  }
};

/// How files of a group are given to the program; empty where that differs from file to file.
std::string advice_on(FileGroup group);

}  // namespace ridgeline::io
