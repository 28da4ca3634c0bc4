// SPDX-License-Identifier: BSD-3-Clause
#include "apps/pipeline/black_border.h"

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

namespace ridgeline::apps {
namespace {

using testing::HasSubstr;

TEST(BlackBorder, IsNamedWithItsShareOfTheImage) {
  cv::Mat image(100, 100, CV_32FC3, cv::Scalar::all(0.5));
  EXPECT_FALSE(black_border("a.tif", image, {}));
  image.rowRange(0, 10).setTo(0.0);
  image.rowRange(98, 100).setTo(cv::Scalar(0.0, 0.0, 0.1));  // dark, but it has data
  const std::optional<std::string> warning = black_border("a.tif", image, {});
  ASSERT_TRUE(warning);
  EXPECT_THAT(*warning, HasSubstr("a.tif: 10 % is black"));
}

TEST(BlackBorder, IsNotWhatLiesWithinTheImageOrIsStatedAsNoData) {
  cv::Mat image(100, 100, CV_32FC1, cv::Scalar(0.5));
  image(cv::Rect(20, 20, 50, 50)).setTo(0.0);  // a shadow
  image(cv::Rect(0, 0, 10, 10)).setTo(0.0);    // 1 %
  EXPECT_FALSE(black_border("a.tif", image, {}));
  image.rowRange(0, 10).setTo(0.0);
  cv::Mat is_valid(100, 100, CV_8UC1, cv::Scalar(255));
  is_valid.rowRange(0, 10).setTo(0);
  EXPECT_FALSE(black_border("a.tif", image, is_valid));
}

}  // namespace
}  // namespace ridgeline::apps
