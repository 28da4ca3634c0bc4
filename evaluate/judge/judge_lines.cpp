// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/judge_lines.h"

#include <pcl/console/print.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <string>
#include <unordered_map>
#include <unordered_set>

namespace ridgeline::evaluate {
namespace {

/// PCL prints every degenerate sample to stderr; silenced while lines are judged.
class QuietPcl {
 public:
  QuietPcl() : level_(pcl::console::getVerbosityLevel()) {
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  }
  ~QuietPcl() { pcl::console::setVerbosityLevel(level_); }
  QuietPcl(const QuietPcl&) = delete;
  QuietPcl& operator=(const QuietPcl&) = delete;

 private:
  pcl::console::VERBOSITY_LEVEL level_;
};

std::vector<char> repeated_ids(std::span<const JudgedLine> lines) {
  std::unordered_set<std::string> seen;
  std::vector<char> repeated(lines.size(), 0);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    repeated[i] = seen.insert(lines[i].id).second ? 0 : 1;
  }
  return repeated;
}

JudgedResult duplicate(const JudgedLine& line) {
  JudgedResult result;
  result.evaluation.id = line.id;
  result.evaluation.line_class = line.line_class;
  result.evaluation.building = line.building;
  result.evaluation.epipolar_angle_deg = line.epipolar_angle_deg;
  result.evaluation.status = Status::kDuplicateId;
  result.evaluation.reason = "an earlier line has the same id";
  if (all_finite(line.segment)) result.evaluation.length_m = length(line.segment);
  return result;
}

/// The label that most of a plane's points carry already, if they are a good part of them.
std::uint64_t common_label(const std::vector<std::uint32_t>& inliers,
                           const std::unordered_map<std::uint32_t, std::uint64_t>& labels) {
  constexpr double kShared = 0.3;  // neighbouring facets share only the points at their edge
  std::unordered_map<std::uint64_t, std::size_t> votes;
  for (const std::uint32_t i : inliers) {
    const auto label = labels.find(i);
    if (label != labels.end()) ++votes[label->second];
  }
  std::uint64_t best = 0;
  std::size_t most = 0;
  for (const auto& [label, count] : votes) {
    if (count > most || (count == most && label < best)) {
      best = label;
      most = count;
    }
  }
  return static_cast<double>(most) >= kShared * static_cast<double>(inliers.size()) ? best : 0;
}

/// One id for planes fitted to the same points, in the order of the lines.
void identify_planes(std::vector<JudgedResult>& results) {
  std::unordered_map<std::uint32_t, std::uint64_t> labels;
  std::uint64_t next = 1;
  for (JudgedResult& result : results) {
    for (std::size_t p = 0; p < result.inliers.size(); ++p) {
      std::uint64_t label = common_label(result.inliers[p], labels);
      if (label == 0) label = next++;
      for (const std::uint32_t i : result.inliers[p]) labels.try_emplace(i, label);
      result.evaluation.planes[p].id = label;
    }
  }
}

}  // namespace

std::vector<JudgedResult> judge_lines(const PointGrid& grid,
                                      std::span<const JudgedLine> lines,
                                      const JudgeOptions& options) {
  validate(options);
  const QuietPcl quiet;
  const std::vector<char> repeated = repeated_ids(lines);
  std::vector<JudgedResult> results(lines.size());
  tbb::parallel_for(std::size_t{0}, lines.size(), [&](std::size_t i) {
    results[i] = repeated[i] != 0 ? duplicate(lines[i]) : judge_line(grid, lines[i], options);
  });
  identify_planes(results);
  return results;
}

}  // namespace ridgeline::evaluate
