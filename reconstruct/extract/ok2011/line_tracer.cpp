// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/ok2011/line_tracer.h"

#include "reconstruct/extract/ok2011/straight_pieces.h"
#include "reconstruct/geometry/median.h"
#include "reconstruct/geometry/transformed.h"

#include <opencv2/core.hpp>

namespace ridgeline::reconstruct {
namespace {

/// Search range on both sides of the line, along the pixel axis across it.
constexpr int kSearch_px = 2;
constexpr double kMinAcrossCosine = 0.9;  ///< 25 degrees between gradient and normal
constexpr double kMinFill = 0.6;          ///< minimum share of the steps that have a sample
constexpr double kMaxClaimed = 0.5;       ///< maximum share of the samples claimed by other traces
constexpr double kRefitGrowth = 1.2;
constexpr int kMaxGap_px = 10;                ///< an edge may continue after such a gap; ours
constexpr double kMinRelativeStrength = 0.3;  ///< relative to the median strength of the trace

double median_strength(const EdgeTrace& trace) {
  return upper_median(transformed(trace, &EdgeSample::strength));
}

}  // namespace

std::vector<Eigen::Vector2d> positions(const EdgeTrace& trace) {
  return transformed(trace, &EdgeSample::position_px);
}

/// A line as a function of the row or the column.
struct LineTracer::TracedLine {
  bool steep = false;  ///< whether steps are rows
  Eigen::Vector2d along, normal;
  double at_zero = 0.0, slope = 0.0;

  explicit TracedLine(const PrincipalAxes& axes)
      : TracedLine(axes, std::abs(axes.along.y()) > std::abs(axes.along.x())) {}
  TracedLine(const PrincipalAxes& axes, bool in_rows) : steep(in_rows), along(axes.along) {
    normal = {-along.y(), along.x()};
    const int major = steep ? 1 : 0;
    slope = along[1 - major] / along[major];
    at_zero = axes.centroid[1 - major] - slope * axes.centroid[major];
  }
  /// Fits the line to samples. Steps remain rows or columns, even if the closer axis changes near
  /// 45 degrees.
  void refit(const EdgeTrace& trace) {
    *this = TracedLine(principal_axes(positions(trace)), steep);
  }

  [[nodiscard]] double minor_at(int step) const { return at_zero + slope * step; }
  [[nodiscard]] cv::Point pixel(int step, int minor) const {
    return steep ? cv::Point(minor, step) : cv::Point(step, minor);
  }
  [[nodiscard]] Eigen::Vector2d point(int step, double minor) const {
    return steep ? Eigen::Vector2d(minor, step) : Eigen::Vector2d(step, minor);
  }
  [[nodiscard]] int step_of(const Eigen::Vector2d& x) const {
    return static_cast<int>(std::lround(x[steep ? 1 : 0]));
  }
};

LineTracer::LineTracer(const GradientImage& image, const ExtractOptions& options)
    : image_(image), options_(options), claimed_(image.gradient.size(), CV_8UC1, cv::Scalar(0)) {}

std::optional<EdgeSample> LineTracer::sample(const TracedLine& line,
                                             int step,
                                             double min_strength) const {
  const cv::Mat& gradient = image_.gradient;
  const double expected = line.minor_at(step);
  const int nearest = static_cast<int>(std::lround(expected));
  const cv::Rect inside({0, 0}, gradient.size());
  if (!inside.contains(line.pixel(step, nearest - kSearch_px - 1)) ||
      !inside.contains(line.pixel(step, nearest + kSearch_px + 1))) {
    return std::nullopt;
  }
  std::array<float, 2 * kSearch_px + 3> across{};
  for (int i = 0; i < static_cast<int>(across.size()); ++i) {
    const auto& g = gradient.at<cv::Vec2f>(line.pixel(step, nearest - kSearch_px - 1 + i));
    across[i] = static_cast<float>(std::abs(g[0] * line.normal.x() + g[1] * line.normal.y()));
  }
  std::optional<EdgeSample> best;
  double smallest = options_.max_deviation_px;
  for (int i = 1; i + 1 < static_cast<int>(across.size()); ++i) {
    if (across[i] < across[i - 1] || across[i] <= across[i + 1]) continue;
    const int minor = nearest - kSearch_px - 1 + i;
    const cv::Point pixel = line.pixel(step, minor);
    const auto& g = gradient.at<cv::Vec2f>(pixel);
    if (across[i] < min_strength || across[i] < kMinAcrossCosine * std::sqrt(g.dot(g))) continue;
    const double at = minor + double{peak_offset_px(across[i - 1], across[i], across[i + 1])};
    const double distance = std::abs(at - expected) * std::abs(line.normal[line.steep ? 0 : 1]);
    if (distance > smallest) continue;
    smallest = distance;
    best = EdgeSample{line.point(step, at), across[i], step};
  }
  return best;
}

EdgeTrace LineTracer::samples_between(const TracedLine& line, int first, int last) const {
  EdgeTrace trace;
  for (int step = first; step <= last; ++step) {
    if (const auto found = sample(line, step, 0.0)) trace.push_back(*found);
  }
  return trace;
}

bool LineTracer::claimed(const EdgeSample& sample) const {
  const cv::Point pixel(static_cast<int>(std::lround(sample.position_px.x())),
                        static_cast<int>(std::lround(sample.position_px.y())));
  return claimed_.at<std::uint8_t>(pixel) != 0;
}

void LineTracer::extend(EdgeTrace& trace, TracedLine& line, int direction) const {
  const double relative = kMinRelativeStrength * median_strength(trace);
  std::size_t refit_at = static_cast<std::size_t>(kRefitGrowth * double(trace.size()));
  EdgeTrace beyond;
  int gap = 0;
  for (int step = trace.back().step + direction; gap <= kMaxGap_px; step += direction) {
    const cv::Point pixel = line.pixel(step, static_cast<int>(std::lround(line.minor_at(step))));
    if (!cv::Rect({0, 0}, claimed_.size()).contains(pixel)) return;
    const double noise = options_.low_noise_factor * image_.noise.at(pixel.x, pixel.y);
    const auto found = sample(line, step, std::max(relative, noise));
    if (!found) {
      ++gap;
      continue;
    }
    if (claimed(*found)) return;
    beyond.push_back(*found);
    if (static_cast<int>(beyond.size()) < 2 * gap) continue;
    trace.insert(trace.end(), beyond.begin(), beyond.end());
    beyond.clear();
    gap = 0;
    if (trace.size() < refit_at) continue;
    line.refit(trace);
    refit_at = static_cast<std::size_t>(kRefitGrowth * double(trace.size()));
  }
}

std::optional<EdgeTrace> LineTracer::trace(std::span<const Eigen::Vector2d> points) const {
  TracedLine line(principal_axes(points));
  const auto [first, last] =
      std::minmax({line.step_of(points.front()), line.step_of(points.back())});
  EdgeTrace found = samples_between(line, first, last);
  const auto n_steps = static_cast<double>(last - first + 1);
  if (found.size() < 3 || static_cast<double>(found.size()) < kMinFill * n_steps) {
    return std::nullopt;
  }
  const auto n_claimed =
      std::count_if(found.begin(), found.end(), [&](const EdgeSample& s) { return claimed(s); });
  if (static_cast<double>(n_claimed) > kMaxClaimed * static_cast<double>(found.size())) {
    return std::nullopt;
  }
  line.refit(found);
  extend(found, line, +1);
  std::reverse(found.begin(), found.end());
  extend(found, line, -1);
  line.refit(found);
  const auto [low, high] = std::minmax({found.front().step, found.back().step});
  found = samples_between(line, low, high);
  if (found.size() < 3) return std::nullopt;
  return found;
}

void LineTracer::claim(const EdgeTrace& trace) {
  const cv::Rect inside({0, 0}, claimed_.size());
  for (const EdgeSample& sample : trace) {
    const cv::Point pixel(static_cast<int>(std::lround(sample.position_px.x())),
                          static_cast<int>(std::lround(sample.position_px.y())));
    for (const cv::Point& step :
         {cv::Point(0, 0), cv::Point(1, 0), cv::Point(-1, 0), cv::Point(0, 1), cv::Point(0, -1)}) {
      if (inside.contains(pixel + step)) claimed_.at<std::uint8_t>(pixel + step) = 1;
    }
  }
}

}  // namespace ridgeline::reconstruct
