// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace ridgeline::io {

/// Kinds of files and folders, grouped by the readers that accept them. For a reader, it is the
/// group that the reader expects.
enum class FileGroup : std::uint8_t {
  kUnknown,
  kEmpty,
  kCloud,
  kPly,  ///< a cloud, a mesh or lines
  kLines,
  kModel,    ///< building model given by faces
  kNumbers,  ///< rows of numbers: a cloud, or lines written by another tool
  kImage,
  kPatch,
  kBlock,
  kGates,
  kConfig,
  kMatches,
  kReferenceMatches,
  kReferenceTracks,
  kSegments,
  kOrientation,  ///< camera poses from an aerotriangulation
  kEvaluation,   ///< evaluation.METHOD.json
  kResult,       ///< another file of a results folder
  kResultFolder,
  kPatchFolder,
  kBlockFolder,
  kOrientationFolder,  ///< of a project of another program
  kLineFolder,         ///< LIMAP tracks
  kFolder,
  kOther  ///< recognised, but never read
};

struct FileKind {
  FileGroup group = FileGroup::kUnknown;
  std::string what = {};    ///< "a LAS point cloud"
  std::string advice = {};  ///< what the user can do with the file; may be empty
  /// File extension by which the reader of such lines is chosen; may be empty.
  std::string ending = {};
  bool by_name = false;  ///< inferred from the name only; the content was not recognised

  [[nodiscard]] bool is_known() const {
    return group != FileGroup::kUnknown && group != FileGroup::kEmpty;
  }
};

/// The texts that describe a group of files and its reader in messages. Options are in backticks.
struct GroupInfo {
  FileGroup group = FileGroup::kUnknown;
  const char* advice = "";  ///< how such a file is given to the program; empty if that varies
  const char* takes = "";   ///< what the reader of the group accepts: "a point cloud"
  const char* rule = "";    ///< the reader's requirement; empty: "{takes} is expected"
  std::array<FileGroup, 4> also = {};  ///< other groups that the reader accepts
};

const GroupInfo& info_of(FileGroup group);

}  // namespace ridgeline::io
