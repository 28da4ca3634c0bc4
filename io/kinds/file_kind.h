// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace ridgeline::io {

/// Kinds of files and folders, grouped by the readers that take them. To a reader, the group that
/// it expects.
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

/// A group of files: what is said of it, and of its reader. Options stand in backticks.
struct GroupInfo {
  FileGroup group = FileGroup::kUnknown;
  const char* advice = "";  ///< how such a file is given to the program; empty where that differs
  const char* takes = "";   ///< what the reader of the group takes: "a point cloud"
  const char* rule = "";    ///< the rule of the reader; empty: "{takes} is expected"
  std::array<FileGroup, 4> also = {};  ///< other groups that the reader takes
};

const GroupInfo& info_of(FileGroup group);

}  // namespace ridgeline::io
