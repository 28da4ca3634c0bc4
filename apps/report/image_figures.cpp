// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/overlay_canvas.h"
#include "apps/report/figure_colours.h"
#include "apps/report/figure_frame.h"
#include "apps/report/figures.h"
#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/epipolar.h"

#include <fmt/core.h>
#include <opencv2/imgproc.hpp>

#include <cmath>

namespace ridgeline::apps {
namespace {

/// An image with segments drawn on it.
class SegmentPicture {
 public:
  explicit SegmentPicture(const cv::Mat& image) {
    constexpr double kMaxPixels = 4e6;  // pixels of the image; the canvas has four times as many
    cv::Mat shown = image;
    scale_ = std::min(1.0, std::sqrt(kMaxPixels / static_cast<double>(image.total())));
    if (scale_ < 1.0) cv::resize(image, shown, {}, scale_, scale_, cv::INTER_AREA);
    canvas_ = overlay_canvas(shown);
    canvas_scale_ = static_cast<double>(canvas_.cols) / shown.cols;
    // faded, so that both dark and bright lines stand out
    canvas_.convertTo(canvas_, -1, 0.7, 40.0);
  }

  void draw(const Segment2& segment_px, const cv::Scalar& colour, int width) {
    cv::line(canvas_, at(segment_px.start), at(segment_px.end), colour, width, cv::LINE_AA,
             kCanvasFractionBits);
  }

  void draw_dashed(const Segment2& segment_px, const cv::Scalar& colour, int width) {
    constexpr double kDash_px = 6.0;
    const auto n = std::max(1, static_cast<int>(length(segment_px) / kDash_px));
    for (int i = 0; i < n; i += 2) {
      const auto point = [&](double t) -> Eigen::Vector2d {
        return (1.0 - t) * segment_px.start + t * segment_px.end;
      };
      draw({point(static_cast<double>(i) / n), point(static_cast<double>(i + 1) / n)}, colour,
           width);
    }
  }

  [[nodiscard]] const cv::Mat& canvas() const { return canvas_; }
  /// Canvas pixels per image pixel.
  [[nodiscard]] double scale() const { return scale_ * canvas_scale_; }

 private:
  [[nodiscard]] cv::Point at(const Eigen::Vector2d& x_px) const {
    return on_canvas(scale_ * (x_px.array() + 0.5) - 0.5);
  }

  cv::Mat canvas_;
  double scale_ = 1.0;
  double canvas_scale_ = 1.0;
};

constexpr int kThin = 1;
constexpr int kThick = 2;

/// Image pixels per metre along a row in the middle of the image, at the mean height of the patch.
double px_per_m(const ReportPatch& patch, std::size_t image) {
  constexpr double kHalf_px = 50.0;
  const auto [low_m, high_m] = io::heights_in_local_m(*patch.patch, patch.frame);
  const ProjectionMatrix camera = patch.image_from_local(image);
  const Plane3 ground(Eigen::Vector3d::UnitZ(), -(low_m + high_m) / 2.0);
  const cv::Mat& pixels = patch.images->base_pair[image];
  const Eigen::Vector2d middle_px(0.5 * pixels.cols, 0.5 * pixels.rows);
  const Eigen::Vector2d beside_px(kHalf_px, 0.0);
  const double distance_m = (point_on_plane(camera, middle_px + beside_px, ground) -
                             point_on_plane(camera, middle_px - beside_px, ground))
                                .norm();
  return 2.0 * kHalf_px / distance_m;
}

cv::Mat framed_image(const SegmentPicture& picture,
                     const ReportPatch& patch,
                     std::size_t image,
                     const std::string& title,
                     std::vector<LegendEntry> legend) {
  const std::string& id = patch.patch->images[image].id;
  return framed(picture.canvas(),
                {.title = fmt::format("{}, patch {}, image {}", title, patch.id, id),
                 .legend = std::move(legend),
                 .px_per_m = picture.scale() * px_per_m(patch, image),
                 .scale_note = "at mid height, in the middle of the image"});
}

/// The segment of a match in an image.
const Segment2& segment_of(const ReportImages& images,
                           std::size_t image,
                           const Correspondence& match) {
  const int index = image == 0 ? match.base : match.other;
  return images.segments[image].at(static_cast<std::size_t>(index)).in_image;
}

std::vector<LegendEntry> match_legend(bool has_reference) {
  const LegendEntry unmatched{LegendMark::kLine, {colour::kGrey}, "no match"};
  if (!has_reference) return {{LegendMark::kLine, {colour::kSkyBlue}, "matched"}, unmatched};
  return {{LegendMark::kLine, {colour::kCorrect}, "correct"},
          {LegendMark::kDashedLine, {colour::kFalse}, "false"},
          {LegendMark::kLine, {colour::kMissed}, "missed"},
          {LegendMark::kLine, {colour::kSkyBlue}, "not judged"},
          unmatched};
}

}  // namespace

cv::Mat figure1(const ReportPatch& patch) {
  const ProjectionMatrix base = patch.image_from_local(0);
  const ProjectionMatrix other = patch.image_from_local(1);
  SegmentPicture picture(patch.images->base_pair[0]);
  for (const EdgeSegment& segment : patch.images->segments[0]) {
    const double angle_deg = deg_from_rad(epipolar_angle_rad(base, other, segment.line.segment));
    const bool is_aligned = angle_deg <= patch.max_aligned_angle_deg;
    picture.draw(segment.in_image, is_aligned ? colour::kAligned : colour::kNotAligned,
                 is_aligned ? kThick : kThin);
  }
  return framed_image(picture, patch, 0, "Line segments",
                      {{LegendMark::kLine,
                        {colour::kAligned},
                        fmt::format("aligned with the epipolar line (up to {:g} degrees)",
                                    patch.max_aligned_angle_deg)},
                       {LegendMark::kLine, {colour::kNotAligned}, "not aligned"}});
}

cv::Mat figure7(const ReportPatch& patch, std::size_t image) {
  const ReportImages& images = *patch.images;
  SegmentPicture picture(images.base_pair[image]);
  for (const EdgeSegment& segment : images.segments[image]) {
    picture.draw(segment.in_image, colour::kGrey, kThin);
  }
  const std::vector<Correspondence>& matches = images.pairs.front().matches;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const Segment2& segment = segment_of(images, image, matches[i]);
    const auto verdict =
        images.score ? images.score->verdicts[i] : evaluate::MatchVerdict::kUnjudged;
    if (verdict == evaluate::MatchVerdict::kFalse) {
      picture.draw_dashed(segment, colour::kFalse, kThick);
    } else {
      picture.draw(
          segment,
          verdict == evaluate::MatchVerdict::kCorrect ? colour::kCorrect : colour::kSkyBlue,
          verdict == evaluate::MatchVerdict::kCorrect || !images.score ? kThick : kThin);
    }
  }
  if (images.score) {
    for (const Correspondence& missed : images.score->missed) {
      picture.draw(segment_of(images, image, missed), colour::kMissed, kThick);
    }
  }
  return framed_image(picture, patch, image, "Matches", match_legend(images.score.has_value()));
}

}  // namespace ridgeline::apps
