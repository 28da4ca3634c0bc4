// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/judge_files.h"

#include "io/error.h"
#include "io/results/finish_judging.h"
#include "io/results/judge_batches.h"
#include "io/results/prepare_lines.h"
#include "io/text/utf8.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/core.h>

#include <filesystem>
#include <utility>

namespace ridgeline::results {

void refuse_mismatch(std::string_view what,
                     const std::string& path,
                     const io::Crs& crs,
                     const io::Crs& other,
                     std::vector<std::string>* warnings) {
  const io::CrsAgreement agreement = io::compare(crs, other);
  if (!agreement.compatible) {
    throw io::IoError(path, fmt::format("{} do not match: {}; transform one of them, or declare "
                                        "the CRS with --assume-crs",
                                        what, agreement.reason));
  }
  if (warnings != nullptr && !agreement.warning.empty()) {
    warnings->push_back(path + ": " + agreement.warning);
  }
}

std::vector<std::string> own_warnings(const io::LineSet& set) {
  return transformed(set.warnings,
                     [&](const std::string& warning) { return set.path + ": " + warning; });
}

std::string stem_of(const std::string& path) {
  return io::as_utf8(std::filesystem::path(path).stem().string());
}

JudgedFiles judge_files(const JudgeFilesOptions& options, RunRecord& record) {
  LinesToJudge lines = read_lines_to_judge(options);
  io::CloudFiles cloud(options.cloud_paths, options.cloud);
  return judge_lines(std::move(lines), cloud, options, record);
}

JudgedFiles judge_lines(LinesToJudge to_judge,
                        io::CloudFiles& cloud,
                        const JudgeFilesOptions& options,
                        RunRecord& record) {
  PreparedLines prepared = prepare_lines(std::move(to_judge), cloud, options);
  record.end_stage("read_lines");
  JudgedBatches batches =
      judge_in_batches(cloud, prepared.lines, options.judge, options.cloud_memory_mib << 20U);
  return finish_judging(std::move(prepared), std::move(batches), cloud, options, record);
}

}  // namespace ridgeline::results
