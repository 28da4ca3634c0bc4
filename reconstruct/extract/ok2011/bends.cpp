// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/ok2011/bends.h"

#include "reconstruct/extract/ok2011/line_sums.h"
#include "reconstruct/extract/ok2011/straight_pieces.h"

#include <optional>

namespace ridgeline::reconstruct {
namespace {

/// Minimum improvement of the fit by two lines for a cut, root mean square (calibration.md).
constexpr double kMinBend_px = 0.2;

std::vector<Eigen::Vector2d> along_and_across(std::span<const Eigen::Vector2d> points) {
  const PrincipalAxes axes = principal_axes(points);
  const Eigen::Vector2d normal(-axes.along.y(), axes.along.x());
  std::vector<Eigen::Vector2d> turned;
  turned.reserve(points.size());
  for (const Eigen::Vector2d& x : points) {
    turned.emplace_back(axes.along.dot(x - axes.centroid), normal.dot(x - axes.centroid));
  }
  return turned;
}

/// The cut at which two lines fit best, if they fit sufficiently better than one line.
std::optional<std::size_t> best_cut(std::span<const Eigen::Vector2d> points,
                                    const ExtractOptions& options) {
  // The smallest significant gain, in variances of the residuals. It allows for the three
  // additional parameters (those of the second line and the position of the cut) and for the
  // correlation of edge pixels.
  constexpr double kSignificant = 60.0;
  const std::vector<Eigen::Vector2d> x = along_and_across(points);
  LineSums all;
  for (const Eigen::Vector2d& p : x) all += p;
  const double one_line = all.residual();
  LineSums first;
  double least = one_line;
  std::optional<std::size_t> cut;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    first += x[i];
    if ((points[i] - points.front()).norm() < options.min_length_px) continue;
    if ((points.back() - points[i + 1]).norm() < options.min_length_px) break;
    const double two_lines = first.residual() + (all - first).residual();
    if (two_lines >= least) continue;
    least = two_lines;
    cut = i + 1;
  }
  const double gain = one_line - least;
  if (gain <= all.n * kMinBend_px * kMinBend_px) return std::nullopt;
  return gain * (all.n - 4.0) > kSignificant * least ? cut : std::nullopt;
}

}  // namespace

std::vector<std::size_t> bends(std::span<const Eigen::Vector2d> points,
                               const ExtractOptions& options) {
  std::vector<std::size_t> borders{0};
  // The last element is the end of the current part; before it are the ends of later parts.
  std::vector<std::size_t> ends{points.size()};
  while (!ends.empty()) {
    const std::size_t begin = borders.back();
    if (const auto cut = best_cut(points.subspan(begin, ends.back() - begin), options)) {
      ends.push_back(begin + *cut);
      continue;
    }
    borders.push_back(ends.back());
    ends.pop_back();
  }
  return borders;
}

}  // namespace ridgeline::reconstruct
