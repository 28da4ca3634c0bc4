// SPDX-License-Identifier: BSD-3-Clause
#include "apps/report/figure_colours.h"
#include "apps/report/figure_frame.h"
#include "apps/report/figures.h"
#include "reconstruct/geometry/degrees.h"

#include <fmt/core.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ridgeline::apps {
namespace {

constexpr int kWidth_px = 1600;
constexpr int kMargin_px = 40;
constexpr int kFractionBits = 4;

/// Parallel projection from the south-west, 40 degrees above the horizon: (right, down, depth), m.
Eigen::Vector3d in_view(const Eigen::Vector3d& x) {
  constexpr double kAzimuth_rad = 30.0 * kRadPerDeg;
  constexpr double kElevation_rad = 40.0 * kRadPerDeg;
  const double right = std::cos(kAzimuth_rad) * x.x() - std::sin(kAzimuth_rad) * x.y();
  const double away = std::sin(kAzimuth_rad) * x.x() + std::cos(kAzimuth_rad) * x.y();
  return {right, -std::cos(kElevation_rad) * x.z() - std::sin(kElevation_rad) * away,
          std::cos(kElevation_rad) * away - std::sin(kElevation_rad) * x.z()};
}

/// The range of a coordinate without the share `share_cut` at either end: 0 for points, 0.01 for
/// lines, because some lines lie far off.
std::array<double, 2> range_of(std::vector<double> values, double share_cut) {
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
  };
  return {at(share_cut), at(1.0 - share_cut)};
}

std::vector<Segment3> segments_of(const ReportMethod& method) {
  std::vector<Segment3> segments;
  for (std::size_t i = 0; i < method.segments.size(); ++i) {
    if (const auto segment = method.judged_segment(i)) segments.push_back(*segment);
  }
  return segments;
}

/// A canvas, and the mapping of the scene to its pixels.
class SceneCanvas {
 public:
  SceneCanvas(const ShownCloud& points, const std::vector<Segment3>& segments) {
    std::vector<double> right;
    std::vector<double> down;
    const auto add = [&](const Eigen::Vector3d& x) {
      const Eigen::Vector3d v = in_view(x);
      right.push_back(v.x());
      down.push_back(v.y());
    };
    const bool has_points = !points.x_in_local.empty();
    for (const Eigen::Vector3d& x : points.x_in_local) add(x);
    if (!has_points) {
      for (const Segment3& s : segments) add(midpoint(s));
    }
    if (right.empty()) add(Eigen::Vector3d::Zero());
    const auto [left_m, right_m] = range_of(std::move(right), has_points ? 0.0 : 0.01);
    const auto [top_m, bottom_m] = range_of(std::move(down), has_points ? 0.0 : 0.01);
    px_per_m_ = (kWidth_px - 2 * kMargin_px) / std::max(right_m - left_m, 1.0);
    corner_m_ = {left_m, top_m};
    const double height_px = std::min(4.0 * kWidth_px, px_per_m_ * (bottom_m - top_m));
    canvas_ = cv::Mat(2 * kMargin_px + static_cast<int>(std::ceil(height_px)), kWidth_px, CV_8UC3,
                      cv::Scalar::all(255.0));
  }

  [[nodiscard]] Eigen::Vector2d at(const Eigen::Vector3d& x) const {
    const Eigen::Vector2d v = in_view(x).head<2>();
    return px_per_m_ * (v - corner_m_).array() + kMargin_px;
  }
  [[nodiscard]] double px_per_m() const { return px_per_m_; }
  cv::Mat& canvas() { return canvas_; }

 private:
  cv::Mat canvas_;
  double px_per_m_ = 1.0;
  Eigen::Vector2d corner_m_ = Eigen::Vector2d::Zero();
};

const cv::Scalar kNoPlane = cv::Scalar::all(225.0);

cv::Scalar plane_colour(std::uint16_t plane) {
  static constexpr std::array<std::array<std::uint8_t, 3>, 8> kPale{{{205, 198, 190},
                                                                     {233, 180, 86},
                                                                     {90, 190, 245},
                                                                     {150, 190, 80},
                                                                     {120, 228, 240},
                                                                     {205, 160, 90},
                                                                     {150, 160, 235},
                                                                     {200, 165, 215}}};
  const auto& c = kPale[static_cast<std::size_t>(plane - 1U) % kPale.size()];
  return {c[0] * 1.0, c[1] * 1.0, c[2] * 1.0};
}

/// Draws far points first, so that near ones cover them.
void draw_points(const ShownCloud& points, const ShownPlanes& planes, SceneCanvas& scene) {
  std::vector<double> depth(points.x_in_local.size());
  std::vector<std::size_t> order(points.x_in_local.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = 0; i < depth.size(); ++i) depth[i] = in_view(points.x_in_local[i]).z();
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return depth[a] > depth[b]; });
  const int radius = points.x_in_local.size() > 60000 ? 1 : 3;
  for (const std::size_t i : order) {
    const Eigen::Vector2d x = scene.at(points.x_in_local[i]);
    const std::uint16_t plane = planes.plane_of_point[i];
    cv::circle(scene.canvas(), {cvRound(x.x()), cvRound(x.y())}, radius,
               plane == 0 ? kNoPlane : plane_colour(plane), cv::FILLED);
  }
}

void draw_line(const Segment3& segment, const cv::Scalar& colour, int width, SceneCanvas& scene) {
  constexpr double kMaxCoordinate_px = 1e5;  // fixed-point coordinates must not overflow
  const Eigen::Vector2d a = scene.at(segment.start);
  const Eigen::Vector2d b = scene.at(segment.end);
  if (a.cwiseAbs().maxCoeff() > kMaxCoordinate_px || b.cwiseAbs().maxCoeff() > kMaxCoordinate_px)
    return;
  const auto fixed = [](const Eigen::Vector2d& x) {
    constexpr double kScale = 1U << static_cast<unsigned>(kFractionBits);
    return cv::Point(cvRound(x.x() * kScale), cvRound(x.y() * kScale));
  };
  cv::line(scene.canvas(), fixed(a), fixed(b), cv::Scalar::all(255.0), width + 3, cv::LINE_AA,
           kFractionBits);
  cv::line(scene.canvas(), fixed(a), fixed(b), colour, width, cv::LINE_AA, kFractionBits);
}

}  // namespace

cv::Mat figure8(const ReportPatch& patch, const ShownScene& shown, std::size_t method) {
  const ReportMethod& lines = patch.methods[method];
  SceneCanvas scene(patch.cloud, segments_of(lines));
  draw_points(patch.cloud, shown.methods[method], scene);
  for (const bool aligned : {false, true}) {
    for (std::size_t i = 0; i < lines.segments.size(); ++i) {
      const bool is_aligned = lines.evaluation.lines[i].line_class == "aligned";
      if (is_aligned != aligned || !lines.segments[i]) continue;
      draw_line(*lines.judged_segment(i), aligned ? colour::kAligned : colour::kBlue,
                aligned ? 4 : 3, scene);
    }
  }
  return framed(
      scene.canvas(),
      {.title = fmt::format("Lines of method {} and LIDAR points, patch {}, from south-west",
                            lines.evaluation.method, patch.id),
       .legend = {{LegendMark::kLine, {colour::kAligned}, "aligned lines"},
                  {LegendMark::kLine, {colour::kBlue}, "lines not aligned"},
                  {LegendMark::kPoints,
                   {plane_colour(2), plane_colour(3), plane_colour(4)},
                   "points, coloured by plane"},
                  {LegendMark::kPoints, {kNoPlane}, "other points"}},
       .px_per_m = scene.px_per_m(),
       .scale_note = "across the view"});
}

}  // namespace ridgeline::apps
