// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/judge_batches.h"

#include "evaluate/judge/batch_judge.h"
#include "evaluate/judge/image_evidence.h"

#include <fmt/core.h>

#include <algorithm>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

namespace ridgeline::results {
namespace {

using evaluate::JudgedLine;

/// A point as it is read, in the grid, and its share of the grid's cells while that is built.
constexpr std::uint64_t kBytesPerPoint =
    sizeof(io::CloudPoint) + sizeof(evaluate::PointGrid::Point) + 32;

struct LineRef {
  std::size_t set, line;
};
using Batch = std::vector<LineRef>;

/// The surroundings of lines: nothing else of the cloud is kept.
class Surroundings {
 public:
  explicit Surroundings(const evaluate::JudgeOptions& options)
      // the radius reaches the corners of the zone that a line's planes are fitted in
      : options_(options),
        radius_m_(std::numbers::sqrt2 *
                  std::max(options.fit_half_width_m,
                           options.corridor_half_width_m + options.corridor_end_m)) {}

  /// A line that cannot be judged needs no points, and memory for none.
  void add(const JudgedLine& line) {
    constexpr double kSweep_m = 1.0;
    if (evaluate::refusal_of(line, options_)) return;
    if (line.images) {
      for (const Segment2& seen : evaluate::plan_sweep(*line.images, kSweep_m)) {
        footprints_.push_back(seen);
      }
      reach_m_ = 0.5 * kSweep_m;
    }
    footprints_.push_back(plan(line.segment));
  }

  [[nodiscard]] io::PlanMask mask() const { return {footprints_, radius_m_ + reach_m_}; }

 private:
  const evaluate::JudgeOptions& options_;
  double radius_m_;
  double reach_m_ = 0.0;  ///< an edge seen in an image may lie between two segments of its sweep
  std::vector<Segment2> footprints_;
};

evaluate::PointGrid grid_of(io::PointCloud& cloud) {
  const auto position = [&](std::size_t i) {
    const io::CloudPoint& p = cloud.points[i];
    return Eigen::Vector3d(p.x, p.y, p.z);
  };
  evaluate::PointGrid grid = evaluate::PointGrid::build(cloud.points.size(), position);
  cloud.points = {};  // the grid holds them now
  return grid;
}

/// All lines: those about the frame's origin, which is amid the points of the cloud, and those far from it.
/// A few lines that a wrong coordinate has put elsewhere would make the raster around all of them coarse.
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

class BatchedJudge {
 public:
  BatchedJudge(io::CloudFiles& cloud,
               const LineSets& lines,
               const evaluate::JudgeOptions& options,
               std::uint64_t max_points)
      : cloud_(cloud), lines_(lines), options_(options), max_points_(max_points) {
    judges_.reserve(lines.size());
    for (const auto& set : lines) judges_.emplace_back(set, options);
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
    note(*near);
    const evaluate::PointGrid grid = grid_of(*near);
    for (std::size_t set = 0; set < judges_.size(); ++set) {
      std::vector<std::size_t> numbers;
      for (const LineRef& ref : batch) {
        if (ref.set == set) numbers.push_back(ref.line);
      }
      judges_[set].judge(grid, numbers);
    }
  }

  JudgedBatches take() {
    JudgedBatches judged{.results = {}, .readings = std::move(readings_)};
    judged.results.reserve(judges_.size());
    for (evaluate::BatchJudge& judge : judges_) judged.results.push_back(judge.take_results());
    return judged;
  }

 private:
  [[nodiscard]] Eigen::Vector2d middle(const LineRef& ref) const {
    const Segment3& segment = lines_[ref.set][ref.line].segment;
    return evaluate::in_range(segment) ? midpoint(plan(segment)) : Eigen::Vector2d::Zero().eval();
  }

  /// The halves of a batch, split at the median across the longer side of the box around the lines' midpoints.
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
        fmt::format("line {}: the {} points near it take {} MiB, more than --cloud-memory-mib",
                    lines_[batch.front().set][batch.front().line].id, near.points.size(),
                    near.points.size() * kBytesPerPoint >> 20U));
    return near;
  }

  void note(const io::PointCloud& near) {
    io::PointCloud& sum = readings_.cloud;
    ++readings_.n_batches;
    readings_.n_kept += near.points.size();
    sum.frame = near.frame;
    sum.crs = near.crs;
    sum.horizontal_unit_m = near.horizontal_unit_m;
    sum.vertical_unit_m = near.vertical_unit_m;
    for (const auto count :
         {&io::PointCloud::n_read, &io::PointCloud::n_dropped_class,
          &io::PointCloud::n_dropped_withheld, &io::PointCloud::n_dropped_return,
          &io::PointCloud::n_dropped_bounds, &io::PointCloud::n_dropped_non_finite}) {
      sum.*count += near.*count;
    }
    for (const std::string& warning : near.warnings) {
      if (std::ranges::find(sum.warnings, warning) == sum.warnings.end()) {
        sum.warnings.push_back(warning);
      }
    }
  }

  io::CloudFiles& cloud_;
  const LineSets& lines_;
  const evaluate::JudgeOptions& options_;
  std::uint64_t max_points_;
  std::vector<evaluate::BatchJudge> judges_;
  CloudReadings readings_;
};

}  // namespace

JudgedBatches judge_in_batches(io::CloudFiles& cloud,
                               const LineSets& lines,
                               const evaluate::JudgeOptions& options,
                               std::uint64_t max_memory_bytes) {
  const auto [near, far] = near_and_far(lines);
  const auto judge_all = [&, &near = near, &far = far] {
    BatchedJudge judge(cloud, lines, options, max_memory_bytes / kBytesPerPoint);
    judge.judge(near);
    if (!far.empty()) judge.judge(far);
    return judge.take();
  };
  JudgedBatches judged = judge_all();
  const bool needs_points = std::ranges::any_of(near, [&](const LineRef& ref) {
    return !evaluate::refusal_of(lines[ref.set][ref.line], options);
  });
  if (judged.readings.n_kept > 0 || !needs_points || cloud.unread_paths().empty()) return judged;
  cloud.distrust_headers();  // before the lines are said to lie elsewhere
  return judge_all();
}

}  // namespace ridgeline::results
