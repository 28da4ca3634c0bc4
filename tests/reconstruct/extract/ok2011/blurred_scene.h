// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/edge_segment.h"
#include "tests/support/random.h"

#include <opencv2/core.hpp>

#include <array>
#include <vector>

namespace ridgeline::test {

/// Rotated rectangles on a plain ground as a camera of Gaussian point spread sees them: their edges
/// are known to any fraction of a pixel.
struct BlurredScene {
  cv::Mat raw;                  ///< CV_8UC3
  std::vector<Segment2> edges;  ///< the sides; the rectangle lies on the side of (-u_y, u_x)
};

struct BlurredSceneOptions {
  double blur_px = 0.8;
  double noise = 0.01;    ///< noise of a grey value in 0..1
  double contrast = 0.2;  ///< mean difference of the rectangles to the ground
  int size_px = 600;
};

/// Share of a Gaussian of unit sigma below x.
inline double normal_below(double x) { return 0.5 * std::erfc(-x * M_SQRT1_2); }

/// A rectangle around `centre`: half sides along `u` and across it.
struct Rectangle {
  Eigen::Vector2d centre, u;
  double half_length_px, half_width_px;
  std::array<double, 3> colour;  ///< difference to the ground
};

inline Rectangle random_rectangle(const Eigen::Vector2d& middle, double contrast, Random& random) {
  const double angle_rad = random.uniform(0.0, 2.0 * M_PI);
  const double sign = random.uniform(0.0, 1.0) < 0.5 ? -1.0 : 1.0;
  Rectangle r{.centre = middle + Eigen::Vector2d(random.uniform(-3, 3), random.uniform(-3, 3)),
              .u = {std::cos(angle_rad), std::sin(angle_rad)},
              .half_length_px = random.uniform(10, 36),
              .half_width_px = random.uniform(8, 25),
              .colour = {}};
  const double k = sign * contrast * random.uniform(0.7, 1.3);
  for (double& band : r.colour) band = k * random.uniform(0.8, 1.2);
  return r;
}

inline void draw(const Rectangle& r, double blur_px, cv::Mat& image) {
  const Eigen::Vector2d v(-r.u.y(), r.u.x());
  const double reach_px = std::hypot(r.half_length_px, r.half_width_px) + 5.0 * blur_px;
  for (int y = int(r.centre.y() - reach_px); y <= int(r.centre.y() + reach_px); ++y) {
    for (int x = int(r.centre.x() - reach_px); x <= int(r.centre.x() + reach_px); ++x) {
      if (x < 0 || y < 0 || x >= image.cols || y >= image.rows) continue;
      const Eigen::Vector2d d = Eigen::Vector2d(x, y) - r.centre;
      const auto covered = [&](double t, double half) {
        return normal_below((half - t) / blur_px) - normal_below((-half - t) / blur_px);
      };
      const double share =
          covered(d.dot(r.u), r.half_length_px) * covered(d.dot(v), r.half_width_px);
      for (int band = 0; band < 3; ++band) {
        image.at<cv::Vec3d>(y, x)[band] += share * r.colour[band];
      }
    }
  }
}

inline void add_edges(const Rectangle& r, std::vector<Segment2>& edges) {
  const Eigen::Vector2d a = r.half_length_px * r.u;
  const Eigen::Vector2d b = r.half_width_px * Eigen::Vector2d(-r.u.y(), r.u.x());
  const std::array<Eigen::Vector2d, 4> corners{r.centre - a - b, r.centre + a - b, r.centre + a + b,
                                               r.centre - a + b};
  for (std::size_t i = 0; i < 4; ++i) edges.push_back({corners[i], corners[(i + 1) % 4]});
}

/// The image as the camera records it, with noise and 8 bits for each band.
inline cv::Mat raw_image(const cv::Mat& image, double noise, Random& random) {
  cv::Mat raw(image.size(), CV_8UC3);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      for (int band = 0; band < 3; ++band) {
        const double value = image.at<cv::Vec3d>(y, x)[band] + random.normal(noise);
        raw.at<cv::Vec3b>(y, x)[band] = cv::saturate_cast<std::uint8_t>(255.0 * value);
      }
    }
  }
  return raw;
}

inline const cv::Scalar kGround(0.5, 0.45, 0.48);

inline BlurredScene blurred_scene(std::uint64_t seed, const BlurredSceneOptions& options = {}) {
  constexpr int kCell_px = 100;
  Random random(seed);
  cv::Mat image(options.size_px, options.size_px, CV_64FC3, kGround);
  BlurredScene scene;
  for (int y = kCell_px / 2; y < options.size_px; y += kCell_px) {
    for (int x = kCell_px / 2; x < options.size_px; x += kCell_px) {
      const Rectangle r = random_rectangle({x, y}, options.contrast, random);
      draw(r, options.blur_px, image);
      add_edges(r, scene.edges);
    }
  }
  scene.raw = raw_image(image, options.noise, random);
  return scene;
}

/// A row of rectangles whose sides run at 45 degrees and up to one degree off, in steps of a tenth;
/// their rows and columns are far apart.
inline BlurredScene diagonal_scene(std::uint64_t seed, const BlurredSceneOptions& options = {}) {
  constexpr int kRectangles = 21;
  Random random(seed);
  cv::Mat image(options.size_px, kRectangles * options.size_px, CV_64FC3, kGround);
  BlurredScene scene;
  for (int i = 0; i < kRectangles; ++i) {
    Rectangle r = random_rectangle({(i + 0.5) * options.size_px, 0.5 * options.size_px},
                                   options.contrast, random);
    const double angle_rad = (45.0 + 0.1 * (i - kRectangles / 2)) * M_PI / 180.0;
    r.u = {std::cos(angle_rad), std::sin(angle_rad)};
    r.half_length_px = 0.4 * options.size_px;
    r.half_width_px = 0.2 * options.size_px;
    draw(r, options.blur_px, image);
    add_edges(r, scene.edges);
  }
  scene.raw = raw_image(image, options.noise, random);
  return scene;
}

/// How a found segment deviates from the true edge that it belongs to.
struct EdgeError {
  Eigen::Vector2d normal;  ///< normal of the true edge, towards the inside of the rectangle
  double across_px = 0.0;  ///< error along the normal, at the segment's centroid
  double angle_rad = 0.0;  ///< error of the direction
  double length_px = 0.0;  ///< length of the part of the true edge that the segment covers
  const EdgeSegment* segment = nullptr;
};

/// The errors of the segments that lie within 1.5 px and 10 degrees of a true edge.
inline std::vector<EdgeError> edge_errors(const std::vector<Segment2>& edges,
                                          const std::vector<EdgeSegment>& segments) {
  constexpr double kMaxAcross_px = 1.5;
  constexpr double kMaxAngle_rad = 0.17;
  std::vector<EdgeError> errors;
  for (const Segment2& edge : edges) {
    const double edge_length = length(edge);
    const Eigen::Vector2d u = (edge.end - edge.start) / edge_length;
    const Eigen::Vector2d n(-u.y(), u.x());
    for (const EdgeSegment& segment : segments) {
      const Segment2& s = segment.line.segment;
      const Eigen::Vector2d d = (s.end - s.start).normalized();
      const double middle = u.dot(midpoint(s) - edge.start);
      const double across = n.dot(segment.line.centroid_px - edge.start);
      const double angle = std::atan(d.dot(n) / d.dot(u));
      if (middle < 0.0 || middle > edge_length || std::abs(across) > kMaxAcross_px ||
          std::abs(angle) > kMaxAngle_rad) {
        continue;
      }
      const double from = std::clamp(u.dot(s.start - edge.start), 0.0, edge_length);
      const double to = std::clamp(u.dot(s.end - edge.start), 0.0, edge_length);
      errors.push_back({n, across, angle, std::abs(to - from), &segment});
    }
  }
  return errors;
}

/// What the errors of many edges say together.
struct ErrorSummary {
  double rms_px = 0.0, bias_px = 0.0;
  double across_z2 = 0.0, angle_z2 = 0.0;  ///< mean squares of the errors over their sigmas
  double completeness = 0.0;               ///< share of the edges' length that is found
};

inline ErrorSummary summary(const std::vector<EdgeError>& errors,
                            const std::vector<Segment2>& edges) {
  ErrorSummary s;
  double total_px = 0.0;
  for (const Segment2& edge : edges) total_px += length(edge);
  for (const EdgeError& e : errors) {
    s.bias_px += e.across_px;
    s.rms_px += e.across_px * e.across_px;
    s.across_z2 += std::pow(e.across_px / e.segment->line.sigma_q_px, 2);
    s.angle_z2 += std::pow(e.angle_rad / e.segment->line.sigma_phi_rad, 2);
    s.completeness += e.length_px / total_px;
  }
  const auto n = static_cast<double>(errors.size());
  s.bias_px /= n;
  s.rms_px = std::sqrt(s.rms_px / n);
  s.across_z2 /= n;
  s.angle_z2 /= n;
  return s;
}

}  // namespace ridgeline::test
