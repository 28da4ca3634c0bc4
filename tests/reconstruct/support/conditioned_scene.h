// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/estimate/conditioned_view.h"
#include "reconstruct/geometry/uncertain/pluecker.h"
#include "tests/reconstruct/support/stereo_scene.h"

#include <Eigen/Cholesky>

#include <vector>

namespace ridgeline::test {

/// The stereo scene in the conditioned frames of a patch of about 40 m about the origin.
struct ConditionedScene {
  StereoScene scene;
  reconstruct::ConditionedViews frames;

  ConditionedScene() {
    std::vector<std::vector<Segment2>> patch(2);
    for (const double y : {-20.0, 20.0}) {
      const auto images = scene.images({{-20, y, 0}, {20, y, 5}});
      for (std::size_t j = 0; j < 2; ++j) patch[j].push_back(images[j]);
    }
    frames = reconstruct::condition(scene.cameras, patch);
  }

  [[nodiscard]] Eigen::Vector3d conditioned(const Eigen::Vector3d& x) const {
    return frames.object.conditioned_from_local(x);
  }

  /// The unit line of a segment, from start to end.
  [[nodiscard]] Vector6d line(const Segment3& s) const {
    return Vector6d(pi_matrix(conditioned(s.start).homogeneous()) *
                    conditioned(s.end).homogeneous())
        .normalized();
  }

  [[nodiscard]] reconstruct::ObservedTrack observe(
      const std::array<UncertainSegment2, 2>& segments,
      LineCovariance form = LineCovariance::kCentroid) const {
    return {{reconstruct::observe(frames, 0, segments[0], form),
             reconstruct::observe(frames, 1, segments[1], form)}};
  }
};

inline std::array<UncertainSegment2, 2> exact_pair(const StereoScene& scene,
                                                   const Segment3& s,
                                                   const Noise& noise = {}) {
  const auto images = scene.images(s);
  return {exact(images[0], noise), exact(images[1], noise)};
}

inline std::array<UncertainSegment2, 2> noisy_pair(const StereoScene& scene,
                                                   const Segment3& s,
                                                   const Noise& noise,
                                                   Random& random) {
  const auto images = scene.images(s);
  const UncertainSegment2 left = noisy(images[0], noise, random);
  return {left, noisy(images[1], noise, random)};
}

/// Normalised squared error of a homogeneous estimate in the coordinates of `basis`, the tangent
/// space at its true unit vector: chi-square with as many degrees of freedom as columns.
template <int N, int K>
double nees(const Uncertain<N>& estimate,
            const Eigen::Matrix<double, N, 1>& truth,
            const Eigen::Matrix<double, N, K>& basis) {
  const double sign = estimate.mean.dot(truth) < 0.0 ? -1.0 : 1.0;
  const Eigen::Matrix<double, K, 1> error = basis.transpose() * (sign * estimate.mean - truth);
  const Eigen::Matrix<double, K, K> cov = basis.transpose() * estimate.cov * basis;
  return error.dot(cov.ldlt().solve(error));
}

}  // namespace ridgeline::test
