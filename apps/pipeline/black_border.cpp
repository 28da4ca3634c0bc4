// SPDX-License-Identifier: BSD-3-Clause
#include "apps/pipeline/black_border.h"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include <set>

namespace ridgeline::apps {
namespace {

/// The pixels with data that are 0 in all bands.
cv::Mat is_black(const cv::Mat& image, const cv::Mat& is_valid) {
  cv::Mat highest = image.reshape(1, static_cast<int>(image.total()));
  cv::reduce(highest, highest, 1, cv::REDUCE_MAX);
  cv::Mat black = highest.reshape(1, image.rows) == 0.0F;
  if (!is_valid.empty()) black &= is_valid != 0;
  return black;
}

/// The number of pixels of the regions that touch the border of a mask.
int n_connected_to_border(const cv::Mat& mask) {
  cv::Mat region;
  cv::Mat facts;
  cv::Mat centres;
  cv::connectedComponentsWithStats(mask, region, facts, centres, 4);
  std::set<int> at_border;
  for (const cv::Mat& side :
       {region.row(0), region.row(region.rows - 1), region.col(0), region.col(region.cols - 1)})
    at_border.insert(side.begin<int>(), side.end<int>());
  at_border.erase(0);  // the rest of the image
  int n = 0;
  for (const int i : at_border) n += facts.at<int>(i, cv::CC_STAT_AREA);
  return n;
}

}  // namespace

std::optional<std::string> black_border(const std::string& path,
                                        const cv::Mat& image,
                                        const cv::Mat& is_valid) {
  constexpr double kMuch = 0.02;
  const double share =
      n_connected_to_border(is_black(image, is_valid)) / static_cast<double>(image.total());
  if (share <= kMuch) return std::nullopt;
  return fmt::format(
      "{}: {:.0f} % is black and connected to the border of the image, whose edge may give "
      "segments; if there is no data, state it in the file (gdal_translate -a_nodata 0 {} OUT.tif)",
      path, 100.0 * share, path);
}

}  // namespace ridgeline::apps
