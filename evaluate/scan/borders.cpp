// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/scan/borders.h"

#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/faces/roof_edge.h"
#include "reconstruct/geometry/transformed.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace ridgeline::evaluate {
namespace {

constexpr double kMinBorder_m = 1.0;
constexpr double kMaxJoinedAngle_deg = 20.0;
constexpr double kSeamReachSpacings = 1.6;
constexpr double kChordSpacings = 1.6;  ///< jags of the border of random points
constexpr double kStripSpacings = 5.0;  ///< width of the strip whose points show the density

using Chain = std::vector<Eigen::Vector2d>;

struct ChainPiece {
  std::size_t first, last;  ///< vertices of the chain
};

/// Distance of x to the right of the line from a to b.
double right_of(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& x) {
  const Eigen::Vector2d d = (b - a).normalized();
  return d.y() * (x.x() - a.x()) - d.x() * (x.y() - a.y());
}

double largest_deviation(const Chain& chain, ChainPiece piece, std::size_t& at) {
  double largest = 0.0;
  const Segment2 chord{chain[piece.first], chain[piece.last]};
  for (std::size_t i = piece.first + 1; i < piece.last; ++i) {
    const double d = distance(chord, chain[i]);
    if (d <= largest) continue;
    largest = d;
    at = i;
  }
  return largest;
}

/// Douglas and Peucker 1973.
void split(const Chain& chain,
           ChainPiece piece,
           double tolerance_m,
           std::vector<ChainPiece>& pieces) {
  std::size_t at = piece.first;
  if (piece.last - piece.first < 2 || largest_deviation(chain, piece, at) <= tolerance_m) {
    pieces.push_back(piece);
    return;
  }
  split(chain, {piece.first, at}, tolerance_m, pieces);
  split(chain, {at, piece.last}, tolerance_m, pieces);
}

/// The regression line of the vertices of a piece, in the direction of the chain.
Segment2 regression(const Chain& chain, ChainPiece piece) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (std::size_t i = piece.first; i <= piece.last; ++i) mean += chain[i];
  mean /= static_cast<double>(piece.last - piece.first + 1);
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (std::size_t i = piece.first; i <= piece.last; ++i)
    scatter += (chain[i] - mean) * (chain[i] - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(scatter);
  Eigen::Vector2d d = solver.eigenvectors().col(1);
  if (d.dot(chain[piece.last] - chain[piece.first]) < 0.0) d = -d;
  return {mean + d * d.dot(chain[piece.first] - mean), mean + d * d.dot(chain[piece.last] - mean)};
}

/// The largest distance of a vertex of a piece from its regression line.
double crookedness_m(const Chain& chain, ChainPiece piece) {
  const Segment2 line = regression(chain, piece);
  double largest = 0.0;
  for (std::size_t i = piece.first; i <= piece.last; ++i)
    largest = std::max(largest, std::abs(right_of(line.start, line.end, chain[i])));
  return largest;
}

bool turns(const Chain& chain, ChainPiece a, ChainPiece b) {
  const Segment2 x = regression(chain, a), y = regression(chain, b);
  return length(x) > kMinBorder_m && length(y) > kMinBorder_m &&
         along(x).dot(along(y)) < std::cos(kMaxJoinedAngle_deg * kRadPerDeg);
}

/// Unites neighbouring pieces that are straight together, the straightest first.
void unite(const Chain& chain, double tolerance_m, std::vector<ChainPiece>& pieces) {
  while (true) {
    std::size_t best = pieces.size();
    double least_m = tolerance_m;
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
      const double crooked_m = crookedness_m(chain, {pieces[i].first, pieces[i + 1].last});
      if (crooked_m > least_m || turns(chain, pieces[i], pieces[i + 1])) continue;
      least_m = crooked_m;
      best = i;
    }
    if (best == pieces.size()) return;
    pieces[best].last = pieces[best + 1].last;
    pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(best) + 1);
  }
}

/// The directions that borders of a region usually have: along the first axis or across it.
struct UsualAxes {
  Eigen::Vector2d axis = Eigen::Vector2d::UnitX();
  double sigma_rad = std::numeric_limits<double>::infinity();  ///< infinite if there are none
};

constexpr double kBuilt_rad = 0.3 * kRadPerDeg;  ///< how well borders follow them

/// The level direction of an inclined plane, known to the error of its tilt, divided by its slope.
UsualAxes axes_of_slope(const ScanRegion& region) {
  if (slope_rad(region.fit.plane) < kLevelRoof_rad) return {};
  const double tilt = region.fit.sigma0_m / std::sqrt(region.fit.spread_m2.minCoeff());
  return {Eigen::Vector2d::UnitX(),
          std::hypot(kBuilt_rad, tilt / std::sin(slope_rad(region.fit.plane)))};
}

/// The usual slope in the frame of a chord; t runs to its right.
void set_usual_slope(const UsualAxes& axes, const Eigen::Vector2d& along, BorderPoints& points) {
  points.usual_slope = std::numeric_limits<double>::infinity();
  points.usual_slope_sigma = axes.sigma_rad;
  if (!std::isfinite(axes.sigma_rad)) return;
  const Eigen::Vector2d across(-axes.axis.y(), axes.axis.x());
  Eigen::Vector2d axis =
      std::abs(axes.axis.dot(along)) > std::abs(across.dot(along)) ? axes.axis : across;
  if (axis.dot(along) < 0.0) axis = -axis;
  points.usual_slope = Eigen::Vector2d(along.y(), -along.x()).dot(axis) / along.dot(axis);
}

/// Whether points cover the area behind a border: a line across a corner or a gap leaves it empty.
/// @param t_m  of the points next to it, relative to the border
bool is_covered(std::span<const double> t_m, double length_m, double spacing_m) {
  constexpr double kStrip = 1.5, kMinShare = 0.7;
  const double width_m = kStrip * spacing_m;
  const auto n = std::ranges::count_if(t_m, [&](double t) { return t > -width_m; });
  return static_cast<double>(n) >= kMinShare * width_m * length_m / (spacing_m * spacing_m);
}

std::optional<Border> fit_border(const ScanRegion& region,
                                 const UsualAxes& axes,
                                 const Segment2& chord) {
  const double length_m = length(chord), spacing_m = region.spacing_m;
  const Eigen::Vector2d u = along(chord), right(u.y(), -u.x());
  std::vector<Eigen::Vector2d> st;
  for (const Eigen::Vector2d& uv : region.uv) {
    const Eigen::Vector2d d = uv - chord.start;
    const Eigen::Vector2d x(u.dot(d), right.dot(d));
    if (x.x() < 0.0 || x.x() > length_m || x.y() > 2.0 * spacing_m ||
        x.y() < -kStripSpacings * spacing_m)
      continue;
    st.push_back(x);
  }
  constexpr std::size_t kMinPoints = 4;
  if (st.size() < kMinPoints) return std::nullopt;
  BorderPoints points{.st_m = st,
                      .length_m = length_m,
                      .sigma_m = region.fit.sigma0_m,
                      .usual_slope = 0.0,
                      .usual_slope_sigma = 0.0};
  set_usual_slope(axes, u, points);
  Border border;
  border.line = border_line(points);
  if (std::isfinite(points.usual_slope))
    border.off_axis_rad = std::abs(std::atan(border.line.slope) - std::atan(points.usual_slope));
  const auto at = [&](double s) -> Eigen::Vector2d {
    return chord.start + s * u +
           (border.line.offset_m + border.line.slope * (s - 0.5 * length_m)) * right;
  };
  border.uv_m = {at(0.0), at(length_m)};
  const std::vector<double> t = transformed(st, [&](const Eigen::Vector2d& x) {
    return x.y() - border.line.offset_m - border.line.slope * (x.x() - 0.5 * length_m);
  });
  if (!is_covered(t, length_m, spacing_m)) return std::nullopt;
  std::erase_if(st, [&](const Eigen::Vector2d& x) {
    return x.y() < border.line.offset_m - kSeamReachSpacings * spacing_m;
  });
  border.support = supported_share(st, length_m, kSeamReachSpacings * spacing_m);
  return border;
}

/// Runs of free sides of a loop as chains of vertices.
std::vector<Chain> chains_of(const ScanRegion& region,
                             const std::vector<std::size_t>& loop,
                             std::span<const Segment2> seams) {
  const double reach_m = kSeamReachSpacings * region.spacing_m;
  const std::size_t n = loop.size();
  const auto vertex = [&](std::size_t i) { return region.uv[loop[i % n]]; };
  std::vector<char> is_free(n);
  for (std::size_t i = 0; i < n; ++i)
    is_free[i] = is_next_to_seam(0.5 * (vertex(i) + vertex(i + 1)), seams, reach_m) ? 0 : 1;
  std::size_t start = 0;
  const auto seam = std::ranges::find(is_free, 0);
  if (seam != is_free.end()) {
    start = static_cast<std::size_t>(seam - is_free.begin());
  } else {
    for (std::size_t i = 1; i < n; ++i)
      if (vertex(i).squaredNorm() > vertex(start).squaredNorm()) start = i;
  }
  std::vector<Chain> chains;
  bool open = false;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = (start + k) % n;
    if (is_free[i] == 0) {
      open = false;
      continue;
    }
    if (!open) chains.push_back({vertex(i)});
    open = true;
    chains.back().push_back(vertex(i + 1));
  }
  return chains;
}

}  // namespace

bool is_next_to_seam(const Eigen::Vector2d& x, std::span<const Segment2> seams, double reach_m) {
  return std::ranges::any_of(seams,
                             [&](const Segment2& seam) { return distance(seam, x) <= reach_m; });
}

double supported_share(std::span<const Eigen::Vector2d> st_m, double length_m, double reach_m) {
  std::vector<double> s;
  for (const Eigen::Vector2d& x : st_m) s.push_back(x.x());
  std::ranges::sort(s);
  double covered_m = 0.0, end_m = 0.0;
  for (const double x : s) {
    const double low = std::max(end_m, x - reach_m), high = std::min(length_m, x + reach_m);
    if (high <= low) continue;
    covered_m += high - low;
    end_m = high;
  }
  return covered_m / length_m;
}

namespace {

/// The chords of the straight parts of a region's border.
std::vector<Segment2> chords_of(const ScanRegion& region, std::span<const Segment2> seams) {
  const double tolerance_m = kChordSpacings * region.spacing_m;
  std::vector<Segment2> chords;
  for (const auto& loop : region.shape.loops) {
    for (const Chain& chain : chains_of(region, loop, seams)) {
      std::vector<ChainPiece> pieces;
      split(chain, {0, chain.size() - 1}, tolerance_m, pieces);
      unite(chain, tolerance_m, pieces);
      for (const ChainPiece& piece : pieces) {
        const Segment2 chord = regression(chain, piece);
        if (length(chord) >= kMinBorder_m) chords.push_back(chord);
      }
    }
  }
  return chords;
}

std::vector<Border> fit_borders(const ScanRegion& region,
                                const UsualAxes& axes,
                                std::span<const Segment2> chords) {
  std::vector<Border> borders;
  for (const Segment2& chord : chords)
    if (const auto border = fit_border(region, axes, chord)) borders.push_back(*border);
  return borders;
}

/// The direction of the border of a level plane whose direction is known best.
UsualAxes axes_of_borders(std::span<const Border> borders) {
  if (borders.empty()) return {};
  const auto best = std::ranges::min_element(
      borders, {}, [](const Border& border) { return border.line.covariance(1, 1); });
  return {along(best->uv_m), std::hypot(kBuilt_rad, std::sqrt(best->line.covariance(1, 1)))};
}

}  // namespace

std::vector<Border> find_borders(const ScanRegion& region, std::span<const Segment2> seams) {
  const std::vector<Segment2> chords = chords_of(region, seams);
  const UsualAxes axes = axes_of_slope(region);
  std::vector<Border> borders = fit_borders(region, axes, chords);
  if (std::isfinite(axes.sigma_rad)) return borders;
  return fit_borders(region, axes_of_borders(borders), chords);
}

}  // namespace ridgeline::evaluate
