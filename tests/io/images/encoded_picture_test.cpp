// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/encoded_picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include <stdexcept>
#include <vector>

namespace ridgeline::io {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// A smooth picture that differs from band to band.
cv::Mat picture(int type) {
  cv::Mat image(60, 90, type);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      auto* pixel = image.ptr(y, x);
      const std::array values{2 * x, 200 - 3 * y, 40 + x + y};
      for (int band = 0; band < image.channels(); ++band)
        pixel[band] = static_cast<unsigned char>(values[static_cast<std::size_t>(band)]);
    }
  }
  return image;
}

cv::Mat decoded(const std::string& bytes) {
  return cv::imdecode(std::vector<unsigned char>(bytes.begin(), bytes.end()), cv::IMREAD_UNCHANGED);
}

double largest_difference(const cv::Mat& a, const cv::Mat& b) {
  return cv::norm(a, b, cv::NORM_INF);
}

TEST(EncodedPicture, PngHoldsThePixelsAsTheyAre) {
  for (const int type : {CV_8UC1, CV_8UC3}) {
    const cv::Mat image = picture(type);
    const cv::Mat back = decoded(png_bytes(image));
    ASSERT_EQ(back.type(), type);
    EXPECT_EQ(largest_difference(back, image), 0.0);
  }
  const cv::Mat part = picture(CV_8UC3)(cv::Rect(10, 20, 30, 25));  // rows with a gap between
  EXPECT_EQ(largest_difference(decoded(png_bytes(part)), part), 0.0);
}

TEST(EncodedPicture, JpegComesCloseAndCloserWithQuality) {
  constexpr double kLossy = 12.0;
  for (const int type : {CV_8UC1, CV_8UC3}) {
    const cv::Mat image = picture(type);
    const cv::Mat back = decoded(jpeg_bytes(image, 90));
    ASSERT_EQ(back.type(), type);
    EXPECT_LT(largest_difference(back, image), kLossy);
    EXPECT_LT(cv::norm(decoded(jpeg_bytes(image, 95)), image),
              cv::norm(decoded(jpeg_bytes(image, 20)), image));
  }
}

TEST(DecodedJpeg, HasThePixelsThatOtherProgramsRead) {
  for (const int type : {CV_8UC1, CV_8UC3}) {
    const std::string bytes = jpeg_bytes(picture(type), 70);
    const cv::Mat back = decoded_jpeg(bytes);
    ASSERT_EQ(back.type(), type);
    ASSERT_EQ(back.size(), picture(type).size());
    EXPECT_LE(largest_difference(back, decoded(bytes)), 1.0);
  }
  EXPECT_THROW(decoded_jpeg("no JPEG"), std::runtime_error);
}

TEST(EncodedPicture, EqualPicturesGiveEqualBytes) {
  const cv::Mat image = picture(CV_8UC3);
  EXPECT_EQ(png_bytes(image), png_bytes(image.clone()));
  EXPECT_EQ(jpeg_bytes(image, 80), jpeg_bytes(image.clone(), 80));
}

TEST(EncodedPicture, OtherTypesAndQualitiesAreRefused) {
  const auto png_of = [](const cv::Mat& image) { return [image] { png_bytes(image); }; };
  EXPECT_THAT(png_of(cv::Mat()), ThrowsMessage<std::invalid_argument>(HasSubstr("not empty")));
  EXPECT_THAT(png_of(cv::Mat(2, 2, CV_16UC1)),
              ThrowsMessage<std::invalid_argument>(HasSubstr("must be CV_8UC1 or CV_8UC3")));
  for (const int quality : {0, 101}) {
    EXPECT_THAT([&] { jpeg_bytes(picture(CV_8UC1), quality); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("must be in [1, 100]")));
  }
}

}  // namespace
}  // namespace ridgeline::io
