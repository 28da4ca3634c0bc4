// SPDX-License-Identifier: BSD-3-Clause
#include "apps/pipeline/check_pair.h"

#include "io/error.h"
#include "reconstruct/scene/pair_check/pair_fit.h"
#include "reconstruct/tracks/view_pairs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace ridgeline::apps {
namespace {

using reconstruct::PairFit;
using reconstruct::PairReading;

/// A pair of images with their cameras and tie points.
struct CheckedPair {
  const io::Patch& patch;
  std::array<std::string, 2> paths;  ///< of the images
  reconstruct::PairGeometry geometry;
  std::vector<reconstruct::PointMatch> points;
  std::array<Eigen::Vector2i, 2> sizes_px;
  double limit_px;
  double common_share;  ///< of the images that both show, by the cameras
};

reconstruct::PairGeometry geometry_of(const reconstruct::Scene& scene, const ViewPair& views) {
  const reconstruct::View& left = scene.views[views.base];
  const reconstruct::View& right = scene.views[views.search];
  return {{left.image_from_local, right.image_from_local},
          scene.height_range_in_local_m,
          {left.ideal_from_image, right.ideal_from_image}};
}

/// The images that do not fit: "both images", or the path of one.
std::string files_text(const CheckedPair& pair, bool left, bool right) {
  if (left && right) return "both images";
  return pair.paths[left ? 0 : 1];
}

std::string reading_text(const CheckedPair& pair, const PairReading& reading) {
  if (reading.swapped) return "the images swapped";
  const auto& turned = reading.turned_deg;
  if (turned[0] != 0 || turned[1] != 0) {
    return fmt::format("{} rotated by {} degrees clockwise",
                       files_text(pair, turned[0] != 0, turned[1] != 0),
                       360 - std::max(turned[0], turned[1]));
  }
  const auto& scale = reading.scale;
  return fmt::format("{} {}", files_text(pair, scale[0] != 1.0, scale[1] != 1.0),
                     std::min(scale[0], scale[1]) < 1.0 ? "doubled in size" : "halved in size");
}

PairFit fit_under(const CheckedPair& pair, const PairReading& reading) {
  std::vector<reconstruct::PointMatch> seen;
  seen.reserve(pair.points.size());
  for (const auto& match : pair.points) {
    seen.push_back(reconstruct::as_seen(match, pair.sizes_px, reading));
  }
  return reconstruct::fit_of_pair(seen, pair.geometry, pair.limit_px);
}

/// If epipolar lines are nearly parallel, points of swapped or turned images also lie near them,
/// but at other heights or slightly farther away. Readings at another scale are excluded: half a
/// disparity is also a plausible height.
bool fits_far_better(const PairFit& other, const PairFit& given, const PairReading& reading) {
  constexpr double kMoreFit = 1.5;
  constexpr double kNearer = 3.0;
  constexpr double kExact_px = 1.0;  // below this, chance decides which reading is nearer
  if (reading.scale != std::array{1.0, 1.0}) return false;
  if (other.share_that_fits > kMoreFit * given.share_that_fits) return true;
  return given.median_y_parallax_px > kExact_px &&
         other.median_y_parallax_px * kNearer < given.median_y_parallax_px &&
         other.share_that_fits > given.share_that_fits;
}

[[noreturn]] void refuse(const CheckedPair& pair,
                         const PairFit& fit,
                         const std::vector<PairReading>& fitting) {
  std::vector<std::string> texts;
  texts.reserve(fitting.size());
  std::string better;
  for (const PairReading& reading : fitting) texts.push_back(reading_text(pair, reading));
  if (!fitting.empty()) {
    const PairFit best = fit_under(pair, fitting.front());
    better = fmt::format("; they fit ({:.2g} px, {:.0f} %) with {}", best.median_y_parallax_px,
                         100.0 * best.share_that_fits, fmt::join(texts, ", or with "));
  } else {
    better = "; correct the cameras or the images";
  }
  const std::string rule = fit.median_y_parallax_px > pair.limit_px
                               ? fmt::format("; must be at most {:g}", pair.limit_px)
                               : "";
  throw io::IoError(
      pair.patch.path,
      fmt::format("images {} and {} do not fit their cameras: {} points that both show lie {:.3g} "
                  "px from the epipolar "
                  "lines of each other (median{}), {:.0f} % of them within height_range{}. "
                  "`max_y_parallax_px` 0 leaves this "
                  "check out",
                  pair.paths[0], pair.paths[1], fit.n_points, fit.median_y_parallax_px, rule,
                  100.0 * fit.share_that_fits, better));
}

/// The minimum number of points for deciding whether a pair fits. Some points are matched by
/// chance, and the smaller the overlap of the images, the more: below this number they could
/// outvote the others.
std::size_t fewest_points(const CheckedPair& pair) {
  constexpr double kOfEqualImages = 30.0;
  constexpr double kMinShare = 0.1;
  return static_cast<std::size_t>(kOfEqualImages / std::max(pair.common_share, kMinShare));
}

/// Checks one pair; see check_pairs().
std::optional<std::string> check_pair(const CheckedPair& pair) {
  constexpr double kUsualShare = 0.5;
  const PairFit fit = reconstruct::fit_of_pair(pair.points, pair.geometry, pair.limit_px);
  if (fit.n_points < fewest_points(pair)) {
    return fmt::format(
        "{}: {} and {} have only {} tie points; the camera check of this pair is skipped",
        pair.patch.path, pair.paths[0], pair.paths[1], fit.n_points);
  }
  const std::vector<PairReading> fitting =
      reconstruct::fitting_readings(pair.points, pair.sizes_px, pair.geometry, pair.limit_px);
  const bool another_fits = std::ranges::any_of(fitting, [&](const PairReading& reading) {
    return fits_far_better(fit_under(pair, reading), fit, reading);
  });
  if (another_fits || fit.median_y_parallax_px > pair.limit_px) refuse(pair, fit, fitting);
  if (fit.share_that_fits < kUsualShare) {
    return fmt::format(
        "{}: only {:.0f} % of {} tie points of {} and {} lie within height_range [{}, {}]; check "
        "it",
        pair.patch.path, 100.0 * fit.share_that_fits, fit.n_points, pair.paths[0], pair.paths[1],
        pair.patch.height_range_m[0], pair.patch.height_range_m[1]);
  }
  return std::nullopt;
}

/// The size of a pixel on the object, in the centre of a view and at the middle of the height
/// range.
double pixel_on_object_m(const reconstruct::View& view, const std::array<double, 2>& heights_m) {
  const Plane3 level(Eigen::Vector3d::UnitZ(), -0.5 * (heights_m[0] + heights_m[1]));
  const Eigen::Vector2d middle_px(0.5 * view.image.cols, 0.5 * view.image.rows);
  const auto on_object = [&](const Eigen::Vector2d& x_px) {
    return point_on_plane(view.image_from_local, x_px, level);
  };
  return (on_object(middle_px + Eigen::Vector2d::UnitX()) - on_object(middle_px)).norm();
}

/// A warning if the images are so close or so far that the units of the patch are probably not
/// metres, as many limits of the program assume.
std::optional<std::string> doubt_of_units(const io::Patch& patch, const reconstruct::Scene& scene) {
  constexpr double kMinPixel_m = 0.002;
  constexpr double kMaxPixel_m = 5.0;
  const reconstruct::View& view = scene.views[0];
  const double pixel_m = pixel_on_object_m(view, scene.height_range_in_local_m);
  if (pixel_m >= kMinPixel_m && pixel_m <= kMaxPixel_m) return std::nullopt;
  return fmt::format(
      "{}: a pixel of image {} covers {:.2g} m on the ground; check that cameras and heights are "
      "in metres",
      patch.path, view.id, pixel_m);
}

/// A warning if the base of a pair is so short that heights are uncertain, or so long that surfaces
/// look different.
std::optional<std::string> doubt_of_base(const io::Patch& patch,
                                         const reconstruct::Scene& scene,
                                         const ViewPair& pair) {
  constexpr double kMinBaseRatio = 0.05;
  constexpr double kMaxBaseRatio = 1.0;
  const double ratio = reconstruct::common_place(scene, pair).base_to_height;
  if (ratio >= kMinBaseRatio && ratio <= kMaxBaseRatio) return std::nullopt;
  return fmt::format("{}: the base-to-height ratio of {} and {} is {:.2g}; {}", patch.path,
                     patch.images[pair.base].path, patch.images[pair.search].path, ratio,
                     ratio < kMinBaseRatio ? "heights are uncertain below 0.05"
                                           : "above 1 surfaces look too different");
}

}  // namespace

std::vector<std::string> check_pairs(const io::Patch& patch,
                                     const reconstruct::Scene& scene,
                                     std::span<const ViewPair> pairs,
                                     double max_y_parallax_px) {
  if (max_y_parallax_px == 0.0) return {};
  std::vector<std::string> doubts;
  for (const ViewPair& views : pairs) {
    const std::array numbers{views.base, views.search};
    CheckedPair pair{patch,
                     {},
                     geometry_of(scene, views),
                     {},
                     {},
                     max_y_parallax_px,
                     reconstruct::common_place(scene, views).share};
    std::array<cv::Mat, 2> images;
    for (std::size_t i = 0; i < 2; ++i) {
      images[i] = scene.views[numbers[i]].image;
      pair.paths[i] = patch.images[numbers[i]].path;
      pair.sizes_px[i] = {images[i].cols, images[i].rows};
    }
    pair.points = reconstruct::match_points(images);
    if (auto doubt = check_pair(pair)) doubts.push_back(std::move(*doubt));
  }
  return doubts;
}

std::vector<std::string> check_matched_pairs(const io::Patch& patch,
                                             const reconstruct::Scene& scene,
                                             const reconstruct::Options& options,
                                             double max_y_parallax_px) {
  const std::vector<ViewPair> pairs = pairs_of(scene, options);
  std::vector<std::string> doubts = check_pairs(patch, scene, pairs, max_y_parallax_px);
  if (auto doubt = doubt_of_units(patch, scene)) doubts.push_back(std::move(*doubt));
  for (const ViewPair& pair : pairs)
    if (auto doubt = doubt_of_base(patch, scene, pair)) doubts.push_back(std::move(*doubt));
  if (!options.matching.tracks.all_views) return doubts;
  for (std::size_t i = 0; i < patch.images.size(); ++i) {
    if (std::ranges::any_of(pairs, [&](const ViewPair& p) { return p.base == i || p.search == i; }))
      continue;
    doubts.push_back(
        fmt::format("{}: {} overlaps every other image by less than a tenth at the middle of "
                    "height_range and is not matched",
                    patch.path, patch.images[i].path));
  }
  return doubts;
}

}  // namespace ridgeline::apps
