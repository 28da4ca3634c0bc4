// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/judge_batches.h"

#include "evaluate/files/point_budget.h"
#include "evaluate/judge/batch_judge.h"
#include "evaluate/judge/image_evidence.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

namespace ridgeline::results {
namespace {

using evaluate::JudgedLine;

struct LineRef {
  std::size_t set, line;
};
using Batch = std::vector<LineRef>;
using LineEvaluations = std::vector<std::vector<evaluate::LineEvaluation>>;

/// The surroundings of lines: only these points of the cloud are kept.
class Surroundings {
 public:
  explicit Surroundings(const evaluate::JudgeOptions& options)
      // the radius reaches the corners of the zone in which a line's planes are fitted
      : radius_m_(std::numbers::sqrt2 *
                  std::max(options.fit_half_width_m,
                           options.corridor_half_width_m + options.corridor_end_m)) {}

  /// A line that cannot be judged needs no points and thus no memory for points.
  void add(const JudgedLine& line) {
    constexpr double kSweep_m = 1.0;
    if (evaluate::refusal_of(line)) return;
    if (line.images) {
      for (const Segment2& seen : evaluate::plan_sweep(*line.images, kSweep_m)) {
        footprints_.push_back(seen);
      }
      reach_m_ = 0.5 * kSweep_m;
    }
    footprints_.push_back(plan(line.segment));
  }

  [[nodiscard]] io::PlanMask mask() const { return {footprints_, radius_m_ + reach_m_}; }
  [[nodiscard]] Eigen::AlignedBox2d box() const {
    const Eigen::Vector2d margin_m = Eigen::Vector2d::Constant(radius_m_ + reach_m_);
    Eigen::AlignedBox2d box;
    for (const Segment2& footprint : footprints_) {
      for (const Eigen::Vector2d& end : {footprint.start, footprint.end}) {
        box.extend(end - margin_m).extend(end + margin_m);
      }
    }
    return box;
  }

 private:
  double radius_m_;
  double reach_m_ = 0.0;  ///< an edge seen in an image may lie between two segments of its sweep
  std::vector<Segment2> footprints_;
};

/// All lines, divided into those near the frame's origin, which is amid the points of the cloud,
/// and those far from it. A few lines with wrong coordinates would otherwise make the raster around
/// all lines coarse.
std::pair<Batch, Batch> near_and_far(const LineSets& lines) {
  constexpr double kFar_m = 3e5;
  const auto is_near = [](const Segment3& s) {
    return s.start.head<2>().cwiseAbs().cwiseMax(s.end.head<2>().cwiseAbs()).maxCoeff() <= kFar_m;
  };
  Batch near, far;
  for (std::size_t set = 0; set < lines.size(); ++set) {
    for (std::size_t line = 0; line < lines[set].size(); ++line) {
      (is_near(lines[set][line].segment) ? near : far).push_back({set, line});
    }
  }
  return {std::move(near), std::move(far)};
}

evaluate::JudgeOptions without_points(evaluate::JudgeOptions options) {
  options.keep_points = false;
  return options;
}

class BatchedJudge {
 public:
  /// The sets of lines from `first_decoys` on are decoys.
  BatchedJudge(io::CloudFiles& cloud,
               const LineSets& lines,
               std::size_t first_decoys,
               const evaluate::JudgeOptions& options,
               std::uint64_t max_points)
      : cloud_(cloud),
        lines_(lines),
        first_decoys_(first_decoys),
        options_(options),
        max_points_(max_points) {
    judges_.reserve(lines.size());
    for (std::size_t set = 0; set < lines.size(); ++set) {
      judges_.emplace_back(lines[set], set < first_decoys ? options : without_points(options));
    }
  }

  /// Judges the lines of the batch, or of its halves one after the other.
  void judge(Batch batch) {
    Surroundings surroundings(options_);
    for (const LineRef& ref : batch) surroundings.add(lines_[ref.set][ref.line]);
    std::optional<io::PointCloud> near = cloud_.read_at_most(surroundings.mask(), max_points_);
    if (!near && batch.size() > 1) {
      const auto [first, second] = halves(std::move(batch));
      judge(first);
      judge(second);
      return;
    }
    if (!near) near = read_beyond_limit(batch, surroundings);
    const std::size_t n_kept = near->points.size();
    const evaluate::PointGrid grid = grid_of(*near);
    add_reading(std::move(*near), n_kept, readings_);
    for (std::size_t set = 0; set < judges_.size(); ++set) {
      std::vector<std::size_t> numbers;
      for (const LineRef& ref : batch) {
        if (ref.set == set) numbers.push_back(ref.line);
      }
      judges_[set].judge(grid, numbers);
    }
  }

  JudgedBatches take() {
    JudgedBatches judged{.results = {}, .readings = std::move(readings_), .decoys = {}};
    judged.results.reserve(first_decoys_);
    for (std::size_t set = 0; set < first_decoys_; ++set) {
      judged.results.push_back(judges_[set].take_results());
    }
    return judged;
  }
  /// The results of the decoys, whose planes have no ids.
  LineEvaluations take_decoys() {
    LineEvaluations results;
    for (std::size_t set = first_decoys_; set < judges_.size(); ++set) {
      results.push_back(
          transformed(judges_[set].take_without_ids(), &evaluate::JudgedResult::evaluation));
    }
    return results;
  }

 private:
  [[nodiscard]] Eigen::Vector2d middle(const LineRef& ref) const {
    const Segment3& segment = lines_[ref.set][ref.line].segment;
    return evaluate::in_range(segment) ? midpoint(plan(segment)) : Eigen::Vector2d::Zero().eval();
  }

  /// The halves of a batch, split at the median along the longer side of the bounding box of the
  /// midpoints.
  [[nodiscard]] std::pair<Batch, Batch> halves(Batch batch) const {
    Eigen::AlignedBox2d box;
    for (const LineRef& ref : batch) box.extend(middle(ref));
    const int axis = box.sizes().x() >= box.sizes().y() ? 0 : 1;
    const auto half = batch.begin() + static_cast<std::ptrdiff_t>(batch.size() / 2);
    const auto place = [&](const LineRef& ref) {
      return std::tuple(middle(ref)[axis], ref.set, ref.line);
    };
    std::nth_element(batch.begin(), half, batch.end(),
                     [&](const LineRef& a, const LineRef& b) { return place(a) < place(b); });
    return {Batch(batch.begin(), half), Batch(half, batch.end())};
  }

  io::PointCloud read_beyond_limit(const Batch& batch, const Surroundings& surroundings) {
    io::PointCloud near = cloud_.read(surroundings.mask());
    near.warnings.push_back(
        fmt::format("line {}: the {} points near it take {} MiB, more than `cloud_memory_mib`",
                    lines_[batch.front().set][batch.front().line].id, near.points.size(),
                    near.points.size() * kBytesPerPoint >> 20U));
    return near;
  }

  io::CloudFiles& cloud_;
  const LineSets& lines_;
  std::size_t first_decoys_;
  const evaluate::JudgeOptions& options_;
  std::uint64_t max_points_;
  std::vector<evaluate::BatchJudge> judges_;
  CloudReadings readings_;
};

void judge_all(BatchedJudge& judge, const std::pair<Batch, Batch>& near_and_far) {
  judge.judge(near_and_far.first);
  if (!near_and_far.second.empty()) judge.judge(near_and_far.second);
}

/// The sets of lines, then those of their decoys.
LineSets with_decoys(LineSets lines, const DecoySets& decoys) {
  for (const auto& set : decoys) lines.push_back(transformed(set, &evaluate::Decoy::line));
  return lines;
}

/// Combines the decoys with their results.
std::vector<std::vector<evaluate::JudgedDecoy>> judged_decoys(DecoySets decoys,
                                                              LineEvaluations results) {
  std::vector<std::vector<evaluate::JudgedDecoy>> judged(decoys.size());
  for (std::size_t set = 0; set < decoys.size(); ++set) {
    for (std::size_t i = 0; i < decoys[set].size(); ++i) {
      judged[set].push_back({std::move(decoys[set][i]), std::move(results[set][i])});
    }
  }
  return judged;
}

bool has_points(const evaluate::JudgedResult& result) {
  using evaluate::Status;
  const Status status = result.evaluation.status;
  return status == Status::kEvaluated || status == Status::kNoPlane ||
         status == Status::kLowCoverage || status == Status::kAmbiguous;
}

/// Whether no line has points near it. The points read may only be near decoys.
bool all_lie_elsewhere(const JudgedBatches& judged) {
  if (judged.readings.n_kept == 0) return true;
  if (judged.decoys.empty()) return false;
  return std::ranges::none_of(judged.results,
                              [](const auto& set) { return std::ranges::any_of(set, has_points); });
}

}  // namespace

Eigen::AlignedBox2d surroundings_of(const JudgedLine& line, const evaluate::JudgeOptions& options) {
  Surroundings surroundings(options);
  surroundings.add(line);
  return surroundings.box();
}

JudgedBatches judge_in_batches(io::CloudFiles& cloud,
                               const LineSets& lines,
                               const evaluate::JudgeOptions& options,
                               std::uint64_t max_memory_bytes,
                               DecoySets decoys,
                               bool all_lines) {
  const LineSets all = with_decoys(lines, decoys);
  const std::pair<Batch, Batch> batches = near_and_far(all);
  const auto judge_once = [&](DecoySets of_lines) {
    BatchedJudge judge(cloud, all, lines.size(), options, max_memory_bytes / kBytesPerPoint);
    judge_all(judge, batches);
    JudgedBatches judged = judge.take();
    judged.decoys = judged_decoys(std::move(of_lines), judge.take_decoys());
    return judged;
  };
  JudgedBatches judged = judge_once(decoys);
  const bool needs_points = std::ranges::any_of(batches.first, [&](const LineRef& ref) {
    return !evaluate::refusal_of(all[ref.set][ref.line]);
  });
  if (!all_lines || !all_lie_elsewhere(judged) || !needs_points || cloud.unread_paths().empty())
    return judged;
  cloud.distrust_headers();  // before reporting that the lines lie elsewhere
  return judge_once(std::move(decoys));
}

}  // namespace ridgeline::results
