// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/sensor.h"

#include "apps/simulate/random.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ridgeline::simulate {
namespace {

enum SensorStream : std::uint64_t { kRadiometryStream = 0x73656e736f72, kNoiseStream };

/// Bands of the radiance in order of the file.
std::vector<int> file_bands(const std::string& bands) {
  if (bands == "rgb") return {0, 1, 2};
  if (bands == "cir") return {3, 0, 1};
  if (bands == "rgbn") return {0, 1, 2, 3};
  check(false, "bands = ", bands, ", must be rgb, cir or rgbn");
  return {};
}

/// Gain of each band. At full gain the near infrared of plants would outshine everything else.
constexpr std::array<double, 4> kBandGain{1.0, 1.0, 1.0, 0.75};

double recorded(double radiance, std::size_t band, const SensorOptions& o, const Radiometry& r) {
  return kBandGain[band] * r.gain[band] * radiance / o.white_radiance + r.offset[band];
}

double toned(double recorded, const SensorOptions& o, const Radiometry& r) {
  return std::pow(std::clamp(recorded, 0.0, 1.0), 1.0 / (o.gamma * r.gamma));
}

template <typename Number>
void expose_row(const cv::Mat& radiance,
                const SensorOptions& options,
                std::uint64_t view,
                int first_row,
                int row,
                cv::Mat& image) {
  const Radiometry radiometry = radiometry_of(options, view);
  const std::vector<int> bands = file_bands(options.bands);
  const double well = options.full_well_electrons;
  constexpr double kLargest = std::numeric_limits<Number>::max();
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
      *out++ = static_cast<Number>(std::lround(kLargest * toned(noisy, options, radiometry)));
    }
  }
}

}  // namespace

Radiometry radiometry_of(const SensorOptions& options, std::uint64_t view) {
  Random random({options.seed, kRadiometryStream, view});
  const double sigma = options.radiometric_sigma;
  Radiometry r;
  for (std::size_t band = 0; band < r.gain.size(); ++band) {
    r.gain[band] = std::exp(sigma * random.normal());
    r.offset[band] = 0.2 * sigma * std::abs(random.normal());
  }
  r.gamma = std::exp(sigma * random.normal());
  return r;
}

double tone(double radiance, std::size_t band, const SensorOptions& options, const Radiometry& r) {
  return toned(recorded(radiance, band, options, r), options, r);
}

cv::Mat expose(const cv::Mat& radiance,
               const SensorOptions& options,
               std::uint64_t view,
               int first_row) {
  validate(options);
  check(options.bits == 8 || options.bits == 16, "bits = ", options.bits, ", must be 8 or 16");
  const int depth = options.bits == 8 ? CV_8U : CV_16U;
  const auto bands = static_cast<int>(file_bands(options.bands).size());
  cv::Mat image(radiance.rows, radiance.cols, CV_MAKETYPE(depth, bands));
  tbb::parallel_for(0, radiance.rows, [&](int row) {
    if (options.bits == 8) {
      expose_row<std::uint8_t>(radiance, options, view, first_row, row, image);
    } else {
      expose_row<std::uint16_t>(radiance, options, view, first_row, row, image);
    }
  });
  return image;
}

}  // namespace ridgeline::simulate
