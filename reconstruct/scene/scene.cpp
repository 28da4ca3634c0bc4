// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/scene/scene.h"

#include "reconstruct/appearance/image_sampler.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/transformed.h"
#include "reconstruct/scene/normalised_image.h"

namespace ridgeline::reconstruct {

LocalFrame local_frame(const ProjectionMatrix& image_from_world,
                       const Eigen::Vector2d& size_px,
                       const std::array<double, 2>& height_range_m) {
  constexpr double kStep_m = 100.0;
  const double mean_m = 0.5 * (height_range_m[0] + height_range_m[1]);
  const Eigen::Vector3d x =
      point_on_plane(image_from_world, 0.5 * size_px, Plane3(Eigen::Vector3d::UnitZ(), -mean_m));
  return {(x / kStep_m).array().round() * kStep_m};
}

Scene in_local_frame(Scene scene) {
  const View& base = scene.views.front();
  const Eigen::Vector3d shift_m =
      local_frame(base.image_from_local, {base.image.cols, base.image.rows},
                  scene.height_range_in_local_m)
          .origin_m;
  for (View& view : scene.views)
    view.image_from_local = image_from_local(view.image_from_local, shift_m);
  for (double& height_m : scene.height_range_in_local_m) height_m -= shift_m.z();
  scene.frame.origin_m += shift_m;
  return scene;
}

cv::Mat normalised(const View& view) {
  return view.image.depth() == CV_32F ? view.image : normalised_image(view.image);
}

StereoPair stereo_pair(const Scene& scene, const ViewPair& views) {
  return {{&scene.views[views.base], &scene.views[views.search]}, scene.height_range_in_local_m};
}

SearchedPair searched(const StereoPair& pair) {
  const View& left = *pair.views[0];
  const View& right = *pair.views[1];
  for (const View* view : pair.views) {
    check(view->image.depth() == CV_32F && view->image.channels() <= kMaxBands &&
              view->image.rows >= 2 && view->image.cols >= 2,
          "image: must be CV_32F of 1 to 4 bands and at least 2 x 2 pixels");
  }
  check(left.image.channels() == right.image.channels(),
        "bands of the images = ", left.image.channels(), " and ", right.image.channels(),
        ", must be equal");
  return {
      left, right,
      StereoSearch(left.image_from_local, right.image_from_local, pair.height_range_in_local_m)};
}

std::vector<Segment2> ideal_segments(const View& view) {
  return transformed(view.segments, [](const EdgeSegment& edge) { return edge.line.segment; });
}

}  // namespace ridgeline::reconstruct
