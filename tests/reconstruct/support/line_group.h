// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/estimate/beyond/extensions.h"
#include "tests/reconstruct/support/stereo_scene.h"
#include "tests/support/random.h"

#include <array>
#include <span>
#include <vector>

namespace ridgeline::test {

/// The options of Ok et al. 2011 without what goes beyond it.
inline reconstruct::EstimationOptions published() {
  return {{}, reconstruct::EstimateExtensionOptions::none()};
}

/// The input of reconstruct_lines() with its truth: match i is segment i of both images.
struct LineGroup {
  StereoScene scene;
  std::vector<Segment3> truth;
  std::vector<std::vector<UncertainSegment2>> segments{2};
  std::vector<Correspondence> matches;
  std::vector<PairConnection> connections;
  std::array<double, 2> height_range_in_local_m{-1e5, 1e5};

  [[nodiscard]] std::vector<reconstruct::ReconstructedLine> reconstruct(
      const reconstruct::EstimationOptions& options = published(),
      std::span<const reconstruct::Registrations> registrations = {},
      const reconstruct::Surface* surface = nullptr) const {
    const std::vector<Track> tracks = tracks_of_pair({0, 1}, matches);
    return reconstruct::reconstruct_lines(
        {scene.cameras, segments, tracks, connections, registrations, height_range_in_local_m},
        options.lines,
        reconstruct::estimate_extensions(options, [=](auto, auto) { return surface; }));
  }
};

/// A line that meets the first one at a parameter of it.
struct NeighbourSpec {
  double parameter;   ///< place along the first line, 0 at its start
  double angle_deg;   ///< angle of its left image to the epipolar line
  double rise_m = 3;  ///< height of its far end over the meeting point
  double gap_px = 0;  ///< gap between the meeting point and its near end
};

inline Segment3 make_neighbour(const StereoScene& scene,
                               const Segment3& line,
                               const NeighbourSpec& spec,
                               double length_px = 80.0) {
  const Eigen::Vector3d meeting = point_at(line, spec.parameter);
  const Eigen::Vector2d x = project(scene.cameras[0], meeting);
  const Eigen::Vector2d direction =
      Eigen::Rotation2Dd(spec.angle_deg * kDegree) * scene.epipolar_direction(x);
  const Eigen::Vector3d far =
      scene.at_height(x + (spec.gap_px + length_px) * direction, meeting.z() + spec.rise_m);
  const double near = spec.gap_px / (spec.gap_px + length_px);
  return {point_at(Segment3{meeting, far}, near), far};
}

/// Adds the images of the true lines, with random errors of the precision `stated`, or exactly
/// without `random`.
inline void observe(LineGroup& group, const Noise& stated, Random* random) {
  for (std::size_t i = 0; i < group.truth.size(); ++i) {
    const std::array<Segment2, 2> images = group.scene.images(group.truth[i]);
    for (std::size_t j = 0; j < 2; ++j) {
      group.segments[j].push_back(random != nullptr ? noisy(images[j], stated, *random)
                                                    : exact(images[j], stated));
    }
    group.matches.push_back({static_cast<int>(i), static_cast<int>(i)});
  }
}

/// A line, number 0, with the neighbours that meet it, 1, 2, ..., each connected with it. They are
/// observed with random errors, or exactly without `random`.
inline LineGroup make_group(const SegmentSpec& line,
                            const std::vector<NeighbourSpec>& neighbours,
                            const Noise& noise = {},
                            Random* random = nullptr) {
  LineGroup group;
  group.truth.push_back(make_segment(group.scene, line));
  for (const NeighbourSpec& neighbour : neighbours) {
    group.connections.push_back({0, static_cast<int>(group.truth.size())});
    group.truth.push_back(make_neighbour(group.scene, group.truth[0], neighbour));
  }
  observe(group, noise, random);
  return group;
}

/// The group of make_group() with random errors and with neighbours that miss the line by random
/// distances.
inline LineGroup make_group_with_misses(const SegmentSpec& line,
                                        const std::vector<NeighbourSpec>& neighbours,
                                        double sigma_m,
                                        const Noise& noise,
                                        Random& random) {
  LineGroup group = make_group(line, neighbours);
  for (std::size_t k = 1; k < group.truth.size(); ++k) {
    const Eigen::Vector3d normal = (group.truth[0].end - group.truth[0].start)
                                       .cross(group.truth[k].end - group.truth[k].start)
                                       .normalized();
    const Eigen::Vector3d miss = random.normal(sigma_m) * normal;
    group.truth[k] = {group.truth[k].start + miss, group.truth[k].end + miss};
  }
  for (auto& segments : group.segments) segments.clear();
  group.matches.clear();
  observe(group, noise, &random);
  return group;
}

/// A rising line of 100 px at this angle to the epipolar line, and three that meet it.
inline SegmentSpec line_at(double theta_deg) {
  return {StereoScene().left_centre(), theta_deg * kDegree, 100.0, 3.0, 4.0};
}
inline const std::vector<NeighbourSpec> kThreeNeighbours{{0.05, 80}, {0.5, -60}, {0.95, 110}};

inline reconstruct::EstimationOptions direct_options() {
  reconstruct::EstimationOptions options = published();
  options.lines.method = reconstruct::Method::kDirect;
  return options;
}

/// Where the line of a segment passes over (or under) a point, as seen from the left camera: signed
/// height of the line there minus that of the point.
inline double height_error_m(const StereoScene& scene,
                             const Segment3& estimate,
                             const Eigen::Vector3d& x) {
  const Eigen::Vector2d image = project(scene.cameras[0], x);
  const Segment2 s = project(scene.cameras[0], estimate);
  // the place on the estimate whose image is closest to x; measured along the segment, so that the
  // noise of the endpoints cancels
  const Eigen::Vector2d d = s.end - s.start;
  const double u = d.dot(image - s.start) / d.squaredNorm();
  const Eigen::Vector3d h_start = scene.cameras[0] * estimate.start.homogeneous();
  const Eigen::Vector3d h_end = scene.cameras[0] * estimate.end.homogeneous();
  const double t = u * h_start.z() / (u * h_start.z() + (1.0 - u) * h_end.z());
  return point_at(estimate, t).z() - x.z();
}

}  // namespace ridgeline::test
