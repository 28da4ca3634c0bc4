// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/run/patch_run.h"
#include "evaluate/files/judge_files.h"

#include <optional>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// The output files of the judgement, relative to the patch's folder.
std::vector<std::string> judged_files(const RunOptions& options);

/// The options for judging the lines of a patch, for all methods together, that a run wrote to the
/// `subfolder` of `out` ("" or ending in a slash).
results::JudgeFilesOptions judge_options(const io::Patch& patch,
                                         const RunOptions& options,
                                         const results::OutputFolder& out,
                                         const std::string& subfolder);

/// The lines of a patch by all methods. They are judged together, so that the cloud is read only
/// once.
class JudgedPatch {
 public:
  /// Throws IoError for reference lines that cannot be read or whose CRS differs from the patch's.
  JudgedPatch(const io::Patch& patch,
              const RunOptions& options,
              const results::OutputFolder& out,
              results::RunRecord& record);

  /// The key of the judgement. `parts`: the keys of the lines.
  [[nodiscard]] std::string key(std::vector<std::string> parts) const;

  /// Reads and judges the lines and writes judged_files(). Without LIDAR, the lines of the patch
  /// get the status `no_lidar`.
  void judge() const;
  /// Reads the evaluations from the files and adds them, and the comparison with true lines, to
  /// `result`.
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
