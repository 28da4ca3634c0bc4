// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/run/patch_run.h"
#include "evaluate/files/judge_files.h"

#include <optional>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// The files of the judgement, in the patch's folder.
std::vector<std::string> judged_files(const RunOptions& options);

/// How the lines of a patch are judged that a run wrote into the `subfolder` of `out` ("" or ending
/// in a slash), by all methods together.
results::JudgeFilesOptions judge_options(const io::Patch& patch,
                                         const RunOptions& options,
                                         const results::OutputFolder& out,
                                         const std::string& subfolder);

/// The lines of a patch by all methods: they are judged together, so that the cloud is read once.
class JudgedPatch {
 public:
  /// Throws IoError for reference lines that cannot be read or have another CRS than the patch.
  JudgedPatch(const io::Patch& patch,
              const RunOptions& options,
              const results::OutputFolder& out,
              results::RunRecord& record);

  /// What the judgement depends on beside the lines, whose keys these are.
  [[nodiscard]] std::string key(std::vector<std::string> parts) const;

  /// Reads the lines, judges them and writes judged_files(). Lines of a patch without LIDAR get the
  /// status `no_lidar`.
  void judge() const;
  /// Adds the evaluations in the files to the result, and how far the lines are from true ones.
  void read(PatchResult& result) const;

 private:
  [[nodiscard]] results::JudgedFiles against_lidar() const;
  [[nodiscard]] results::JudgedFiles without_lidar() const;
  [[nodiscard]] std::vector<evaluate::JudgedLine> lines_of(reconstruct::Method method) const;
  [[nodiscard]] std::string line_path(reconstruct::Method method) const;

  const io::Patch& patch_;
  const RunOptions& options_;
  const results::OutputFolder& out_;
  results::RunRecord& record_;
  std::optional<std::vector<evaluate::ReferenceLine>> references_;
};

}  // namespace ridgeline::apps
