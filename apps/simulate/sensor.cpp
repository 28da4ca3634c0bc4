// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/sensor.h"

#include "apps/simulate/random.h"
#include "io/images/encoded_picture.h"

#include <oneapi/tbb/parallel_for.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ridgeline::simulate {
namespace {

enum SensorStream : std::uint64_t { kRadiometryStream = 0x73656e736f72, kNoiseStream };

/// Indices of the radiance bands in file order.
std::vector<int> file_bands(const std::string& bands) {
  if (bands == "rgb") return {0, 1, 2};
  if (bands == "cir") return {3, 0, 1};
  if (bands == "rgbn") return {0, 1, 2, 3};
  check(false, "bands = ", bands, ", must be rgb, cir or rgbn");
  return {};
}

/// Gain of each band. At full gain, the near-infrared reflection of plants would outshine
/// everything else.
constexpr std::array<double, 4> kBandGain{1.0, 1.0, 1.0, 0.75};

double recorded(double radiance, std::size_t band, const SensorOptions& o, const SensorTone& r) {
  return kBandGain[band] * r.gain[band] * radiance / o.white_radiance + r.offset[band];
}

double toned(double recorded, const SensorOptions& o, const SensorTone& r) {
  return std::pow(std::clamp(recorded, 0.0, 1.0), 1.0 / (o.gamma * r.gamma));
}

int blur_reach_px(const SensorOptions& options) {
  constexpr double kReachSigmas = 4.0;  // 6e-5 of the light spreads further
  return static_cast<int>(std::ceil(kReachSigmas * options.blur_px));
}

/// Blurs with the discrete Gaussian (Lindeberg 1990), whose variance is exactly sigma^2. A sampled
/// continuous Gaussian is too narrow for a sigma below 0.7 px.
cv::Mat blurred(const cv::Mat& radiance, const SensorOptions& options) {
  const int reach = blur_reach_px(options);
  const double variance = options.blur_px * options.blur_px;
  cv::Mat kernel(2 * reach + 1, 1, CV_32F);
  for (int i = -reach; i <= reach; ++i) {
    kernel.at<float>(i + reach) =
        static_cast<float>(std::exp(-variance) * std::cyl_bessel_i(std::abs(i), variance));
  }
  kernel /= cv::sum(kernel)[0];
  cv::Mat result;
  cv::sepFilter2D(radiance, result, -1, kernel, kernel);
  return result;
}

/// Keeps one colour per pixel (red green / green blue) and interpolates the other two.
template <typename Number>
cv::Mat demosaiced(const cv::Mat& image, int first_row) {
  cv::Mat mosaic(image.size(), CV_MAKETYPE(image.depth(), 1));
  for (int row = 0; row < image.rows; ++row) {
    const auto* in = image.ptr<cv::Vec<Number, 3>>(row);
    auto* out = mosaic.ptr<Number>(row);
    for (int column = 0; column < image.cols; ++column) {
      out[column] = in[column][(first_row + row) % 2 + column % 2];
    }
  }
  cv::Mat result;
  cv::cvtColor(mosaic, result,
               first_row % 2 == 0 ? cv::COLOR_BayerRGGB2RGB : cv::COLOR_BayerGBRG2RGB);
  return result;
}

cv::Mat through_jpeg(const cv::Mat& image, int quality) {
  cv::Mat result;
  cv::cvtColor(image, result, cv::COLOR_RGB2BGR);
  result = io::decoded_jpeg(io::jpeg_bytes(result, quality));
  cv::cvtColor(result, result, cv::COLOR_BGR2RGB);
  return result;
}

template <typename Number>
void expose_row(const cv::Mat& radiance,
                const SensorOptions& options,
                std::uint64_t view,
                int first_row,
                int row,
                cv::Mat& image) {
  const SensorTone radiometry = radiometry_of(options, view);
  const std::vector<int> bands = file_bands(options.bands);
  const double well = options.full_well_electrons;
  constexpr double kMaxValue = std::numeric_limits<Number>::max();
  Random random({options.seed, kNoiseStream, view, static_cast<std::uint64_t>(first_row + row)});
  const auto* in = radiance.ptr<cv::Vec4f>(row);
  auto* out = image.ptr<Number>(row);
  for (int column = 0; column < radiance.cols; ++column) {
    for (const int band : bands) {
      const auto b = static_cast<std::size_t>(band);
      const double signal = recorded(static_cast<double>(in[column][band]), b, options, radiometry);
      const double variance = std::max(signal, 0.0) * well +
                              options.read_noise_electrons * options.read_noise_electrons;
      const double noisy = signal + std::sqrt(variance) / well * random.normal();
      *out++ = static_cast<Number>(std::lround(kMaxValue * toned(noisy, options, radiometry)));
    }
  }
}

}  // namespace

SensorTone radiometry_of(const SensorOptions& options, std::uint64_t view) {
  Random random({options.seed, kRadiometryStream, view});
  const double sigma = options.radiometric_sigma;
  SensorTone r;
  for (std::size_t band = 0; band < r.gain.size(); ++band) {
    r.gain[band] = std::exp(sigma * random.normal());
    r.offset[band] = 0.2 * sigma * std::abs(random.normal());
  }
  r.gamma = std::exp(sigma * random.normal());
  return r;
}

double tone(double radiance, std::size_t band, const SensorOptions& options, const SensorTone& r) {
  return toned(recorded(radiance, band, options, r), options, r);
}

void check_sensor(const SensorOptions& options) {
  validate(options);
  check(options.bits == 8 || options.bits == 16, "bits = ", options.bits, ", must be 8 or 16");
  (void)file_bands(options.bands);
  check(!options.bayer || options.bands == "rgb", "bands = ", options.bands,
        ", must be rgb with a Bayer pattern");
  if (options.jpeg_quality == 0) return;
  check(options.bits == 8, "bits = ", options.bits, ", must be 8 with a JPEG quality");
  check(options.bands != "rgbn", "bands = ", options.bands,
        ", must be rgb or cir with a JPEG quality");
}

cv::Mat expose(const cv::Mat& radiance,
               const SensorOptions& options,
               std::uint64_t view,
               int first_row) {
  check_sensor(options);
  const cv::Mat light = options.blur_px > 0.0 ? blurred(radiance, options) : radiance;
  const int depth = options.bits == 8 ? CV_8U : CV_16U;
  const auto bands = static_cast<int>(file_bands(options.bands).size());
  cv::Mat image(light.rows, light.cols, CV_MAKETYPE(depth, bands));
  tbb::parallel_for(0, light.rows, [&](int row) {
    if (options.bits == 8) {
      expose_row<std::uint8_t>(light, options, view, first_row, row, image);
    } else {
      expose_row<std::uint16_t>(light, options, view, first_row, row, image);
    }
  });
  if (options.bayer) {
    image = options.bits == 8 ? demosaiced<std::uint8_t>(image, first_row)
                              : demosaiced<std::uint16_t>(image, first_row);
  }
  return options.jpeg_quality > 0 ? through_jpeg(image, options.jpeg_quality) : image;
}

int rows_around(const SensorOptions& options) {
  constexpr int kBlock = 16;  // JPEG stores colours at half resolution, in blocks of 8 x 8
  const int rows =
      blur_reach_px(options) + (options.bayer ? 1 : 0) + (options.jpeg_quality > 0 ? kBlock : 0);
  return (rows + kBlock - 1) / kBlock * kBlock;
}

}  // namespace ridgeline::simulate
