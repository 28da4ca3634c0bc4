// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/surface/surface.h"

#include "reconstruct/appearance/edge_appearance.h"
#include "reconstruct/appearance/strip_appearance.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/interruption.h"
#include "reconstruct/surface/hierarchical_matching.h"

#include <opencv2/imgproc.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ridgeline::reconstruct {
namespace {

/// Maximum number of disparities of a tile. The disparities of a tile stay unknown if the height
/// range spans more, or if its rays do not reach the height range.
constexpr double kMaxDisparities = 4096.0;

/// Margin around a tile that is matched as well, because the matching paths need some pixels to
/// settle.
constexpr int kTileMargin_px = 32;

/// Disparities of a tile, [least, least + n).
struct SearchRange {
  int least = 0, n = 0;
};

SearchRange range_of(const Rectification& r,
                     const cv::Rect& tile,
                     const std::array<double, 2>& heights_m) {
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  for (const int x : {tile.x, tile.x + tile.width}) {
    for (const int y : {tile.y, tile.y + tile.height}) {
      for (const double z : heights_m) {
        const double d = r.disparity_at_height_px(Eigen::Vector2d(x, y), z);
        low = std::min(low, d);
        high = std::max(high, d);
      }
    }
  }
  SearchRange range;
  if (!(high - low < kMaxDisparities)) return range;
  range.least = static_cast<int>(std::floor(low)) - 1;
  constexpr int kStep = kHierarchicalStep;
  range.n = (static_cast<int>(std::ceil(high)) + 1 - range.least + kStep - 1) / kStep * kStep;
  return range;
}

/// A view in 8 bits with one or three bands, the only numbers that the matching accepts.
cv::Mat in_8_bits(const cv::Mat& image, const Radiometry& left_from_image) {
  const int n_bands = image.channels() < 3 ? 1 : 3;
  cv::Mat bytes(image.size(), CV_8UC(n_bands));
  for (int y = 0; y < image.rows; ++y) {
    const float* from = image.ptr<float>(y);
    unsigned char* to = bytes.ptr(y);
    for (int x = 0; x < image.cols; ++x, from += image.channels(), to += n_bands) {
      for (int band = 0; band < n_bands; ++band) {
        to[band] = cv::saturate_cast<unsigned char>(
            255.0F * (left_from_image.gain[band] * from[band] + left_from_image.offset[band]));
      }
    }
  }
  return bytes;
}

class Matching {
 public:
  Matching(const StereoPair& pair, const Rectification& r) : pair_(pair), rectification_(r) {
    const Radiometry radiometry =
        relative_radiometry(extracted(pair.views[0]->segments), extracted(pair.views[1]->segments));
    bytes_ = {in_8_bits(pair.views[0]->image, {}), in_8_bits(pair.views[1]->image, radiometry)};
  }

  /// Writes the disparities of a tile.
  void match(const cv::Rect& tile, cv::Mat& disparity_px) const {
    const cv::Rect whole(cv::Point(), rectification_.size);
    const int m = kTileMargin_px;
    const cv::Rect around = (tile + cv::Size(2 * m, 2 * m) - cv::Point(m, m)) & whole;
    const SearchRange range = range_of(rectification_, around, pair_.height_range_in_local_m);
    if (range.n == 0) return;
    const RectifiedPart left = rectified(0, around);
    const RectifiedPart right = rectified(
        1, {around.x - range.least - range.n, around.y, around.width + range.n, around.height});
    const cv::Mat found = hierarchical_disparities(left.image, right.image, range.n);
    for (int y = tile.y; y < tile.y + tile.height; ++y) {
      const int row = y - around.y;
      for (int x = tile.x; x < tile.x + tile.width; ++x) {
        const int column = x - around.x;
        const float d = found.at<float>(row, column);
        if (d < 0.0F || !left.shows(row, column) ||
            !right.shows(row, column + range.n - static_cast<int>(d)))
          continue;
        disparity_px.at<float>(y, x) = static_cast<float>(range.least) + d;
      }
    }
  }

 private:
  /// A part of a rectified view.
  struct RectifiedPart {
    cv::Mat image;
    cv::Mat from;  ///< the file pixel that corresponds to each rectified pixel
    cv::Size size_of_file;

    [[nodiscard]] bool shows(int row, int column) const {
      const auto& x = from.at<cv::Vec2f>(row, column);
      return x[0] >= 0.0F && x[1] >= 0.0F && x[0] <= static_cast<float>(size_of_file.width - 1) &&
             x[1] <= static_cast<float>(size_of_file.height - 1);
    }
  };

  [[nodiscard]] RectifiedPart rectified(std::size_t view, const cv::Rect& part) const {
    RectifiedPart result{{},
                         image_from_rectified(rectification_.rectified_from_ideal[view],
                                              pair_.views[view]->ideal_from_image, part),
                         bytes_[view].size()};
    cv::remap(bytes_[view], result.image, result.from, cv::noArray(), cv::INTER_CUBIC,
              cv::BORDER_CONSTANT);
    return result;
  }

  const StereoPair& pair_;
  const Rectification& rectification_;
  std::array<cv::Mat, 2> bytes_;
};

/// The smallest step in rows and columns that leaves at most `most_pixels` of a view.
int step_that_leaves(std::size_t most_pixels, const cv::Size& size) {
  check(most_pixels > 0, "points_in_local: most = 0, must be positive");
  const auto n_left = [&](int step) {
    const auto n = [step](int all) { return static_cast<std::size_t>((all + step - 1) / step); };
    return n(size.height) * n(size.width);
  };
  int step = 1;
  while (n_left(step) > most_pixels) ++step;
  return step;
}

}  // namespace

std::optional<double> Surface::at(const Eigen::Vector2d& x_px) const {
  const auto column = static_cast<int>(std::lround(x_px.x()));
  const auto row = static_cast<int>(std::lround(x_px.y()));
  if (!cv::Rect(cv::Point(), disparity_px.size()).contains({column, row})) return std::nullopt;
  const float d = disparity_px.at<float>(row, column);
  return std::isnan(d) ? std::nullopt : std::optional<double>(d);
}

std::vector<Eigen::Vector3d> points_in_local(const Surface& surface, std::size_t most) {
  const int step_px = step_that_leaves(most, surface.disparity_px.size());
  std::vector<Eigen::Vector3d> points;
  for (int row = 0; row < surface.disparity_px.rows; row += step_px) {
    for (int column = 0; column < surface.disparity_px.cols; column += step_px) {
      const Eigen::Vector2d x(column, row);
      if (const auto d = surface.at(x))
        points.push_back(surface.rectification.point_in_local(x, *d));
    }
  }
  return points;
}

std::optional<Surface> dense_surface(const StereoPair& pair, int tile_px) {
  const auto r = rectification(pair.cameras(), pair.views[0]->image.size());
  if (!r) return std::nullopt;
  Surface surface{*r,
                  cv::Mat(r->size, CV_32F, cv::Scalar(std::numeric_limits<float>::quiet_NaN()))};
  const Matching matching(pair, *r);
  std::vector<cv::Rect> tiles;
  for (int y = 0; y < r->size.height; y += tile_px) {
    for (int x = 0; x < r->size.width; x += tile_px) {
      tiles.push_back(cv::Rect(x, y, tile_px, tile_px) & cv::Rect({}, r->size));
    }
  }
  tbb::parallel_for(std::size_t{0}, tiles.size(), [&](std::size_t t) {
    Interruption::check();
    matching.match(tiles[t], surface.disparity_px);
  });
  return surface;
}

}  // namespace ridgeline::reconstruct
