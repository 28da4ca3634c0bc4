// SPDX-License-Identifier: BSD-3-Clause
#include "apps/report/line_views.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ridgeline::apps {
namespace {

using Vector6d = Eigen::Matrix<double, 6, 1>;

/// Signed distances of the ends of a segment from the projected line.
Eigen::Vector2d distances_px(const ProjectionMatrix& camera,
                             const Vector6d& ends,
                             const Segment2& px) {
  const Segment2 seen = project(camera, Segment3{ends.head<3>(), ends.tail<3>()});
  const Eigen::Vector2d n = normal(seen);
  return {n.dot(px.start - seen.start), n.dot(px.end - seen.start)};
}

/// Variances across a regression line at the ends of the segment.
Eigen::Vector2d variances_px2(const UncertainSegment2& line, const Segment2& px) {
  const Eigen::Vector2d u = along(px);
  const auto variance = [&](const Eigen::Vector2d& end) {
    return std::pow(line.sigma_q_px, 2) +
           std::pow(u.dot(end - line.centroid_px) * line.sigma_phi_rad, 2);
  };
  return {variance(px.start), variance(px.end)};
}

}  // namespace

std::optional<Offset> offset_of(const ProjectionMatrix& camera,
                                const Segment3& line,
                                const Eigen::Matrix<double, 6, 6>& covariance_m2,
                                const Segment2& px,
                                const UncertainSegment2* uncertain) {
  constexpr double kMinLength_px = 1.0;  // shorter projections have no direction
  if (!(length(project(camera, line)) > kMinLength_px)) return std::nullopt;
  Vector6d ends;
  ends << line.start, line.end;
  const Eigen::Vector2d d = distances_px(camera, ends, px);
  constexpr double kStep_m = 1e-3;  // the projection is practically linear over this distance
  Eigen::Matrix<double, 2, 6> jacobian;
  for (Eigen::Index i = 0; i < 6; ++i) {
    const Vector6d step = kStep_m * Vector6d::Unit(i);
    jacobian.col(i) =
        (distances_px(camera, ends + step, px) - distances_px(camera, ends - step, px)) /
        (2.0 * kStep_m);
  }
  Eigen::Vector2d variance = (jacobian * covariance_m2 * jacobian.transpose()).diagonal();
  if (uncertain != nullptr) variance += variances_px2(*uncertain, px);
  if (!d.allFinite() || !variance.allFinite() || !(variance.minCoeff() > 0.0)) return std::nullopt;
  const Eigen::Vector2d sigma = variance.cwiseSqrt();
  const Eigen::Index worse = std::abs(d[0]) / sigma[0] >= std::abs(d[1]) / sigma[1] ? 0 : 1;
  return Offset{std::abs(d[worse]), sigma[worse]};
}

std::string_view name(ViewOfLine state) {
  constexpr std::array<std::string_view, 8> kNames{"agrees", "differs", "sighted", "missing",
                                                   "hidden", "border",  "outside", "not_used"};
  return kNames.at(static_cast<std::size_t>(state));
}

ImageField::ImageField(const ProjectionMatrix& image_from_local,
                       const Eigen::Vector2d& size_px,
                       std::span<const Eigen::Vector3d> surface_in_local)
    : image_from_local_(image_from_local),
      centre_in_local_(projection_centre(image_from_local).hnormalized()),
      size_px_(size_px) {
  if (surface_in_local.empty()) return;
  // each cell holds about four points, so that few cells covered by a surface have none of its
  // points
  constexpr double kPointsPerCell = 4.0;
  cell_px_ = std::max(1.0, std::sqrt(kPointsPerCell * size_px.prod() /
                                     static_cast<double>(surface_in_local.size())));
  columns_ = static_cast<std::size_t>(size_px.x() / cell_px_) + 1;
  const auto rows = static_cast<std::size_t>(size_px.y() / cell_px_) + 1;
  nearest_m_.assign(columns_ * rows, std::numeric_limits<double>::infinity());
  for (const Eigen::Vector3d& x : surface_in_local) {
    const Eigen::Vector2d x_px = project(image_from_local_, x);
    if (!is_inside(x_px, 0.0)) continue;
    double& nearest = nearest_m_[cell_of(x_px)];
    nearest = std::min(nearest, (x - centre_in_local_).norm());
  }
}

bool ImageField::is_inside(const Eigen::Vector2d& x_px, double border_px) const {
  return x_px.x() >= border_px && x_px.y() >= border_px && x_px.x() < size_px_.x() - border_px &&
         x_px.y() < size_px_.y() - border_px;
}

std::size_t ImageField::cell_of(const Eigen::Vector2d& x_px) const {
  return static_cast<std::size_t>(x_px.y() / cell_px_) * columns_ +
         static_cast<std::size_t>(x_px.x() / cell_px_);
}

bool ImageField::is_hidden(const Eigen::Vector3d& x_in_local) const {
  constexpr double kMargin_m = 1.0;  // for errors of the surface and the range of depths in a cell
  if (nearest_m_.empty()) return false;
  const double nearest_m = nearest_m_[cell_of(project(image_from_local_, x_in_local))];
  return nearest_m < (x_in_local - centre_in_local_).norm() - kMargin_m;
}

ViewOfLine ImageField::unobserved(const Segment3& line) const {
  constexpr double kBorder_px = 5.0;  // edges are not found closer to the border
  constexpr int kPlaces = 9;
  int n_inside = 0;
  int n_hidden = 0;
  for (int i = 0; i < kPlaces; ++i) {
    const Eigen::Vector3d x = point_at(line, (i + 0.5) / kPlaces);
    if (!is_inside(project(image_from_local_, x), 0.0)) continue;
    ++n_inside;
    n_hidden += is_hidden(x);
  }
  if (n_inside == 0) return ViewOfLine::kOutside;
  if (2 * n_hidden > n_inside) return ViewOfLine::kHidden;
  const bool is_whole = is_inside(project(image_from_local_, line.start), kBorder_px) &&
                        is_inside(project(image_from_local_, line.end), kBorder_px);
  return is_whole ? ViewOfLine::kMissing : ViewOfLine::kBorder;
}

}  // namespace ridgeline::apps
