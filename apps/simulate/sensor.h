// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/field.h"

#include <opencv2/core/mat.hpp>

#include <array>
#include <cstdint>
#include <string>

namespace ridgeline::simulate {

/// Model of a digital frame camera and its image processing.
struct SensorOptions {
  std::string bands = "rgb";  ///< rgb, cir (near infrared, red, green) or rgbn
  int bits = 8;               ///< 8 or 16
  double blur_px = 0.0;       ///< sigma of a Gaussian blur of the light, in addition to the optics
  bool bayer = false;         ///< each pixel records one colour; the other two are interpolated
  int jpeg_quality = 0;       ///< 1 to 100; 0: no compression
  std::uint64_t seed = 1;
  // Not options; tests change them.
  double white_radiance = 0.45;          ///< radiance that maps to the largest pixel value
  double gamma = 1.5;                    ///< pixel values are proportional to radiance^(1 / gamma)
  double full_well_electrons = 12000.0;  ///< electrons at white, which determine the shot noise
  double read_noise_electrons = 30.0;
  double radiometric_sigma = 0.05;  ///< spread of gain and gamma between views; offsets: a fifth

  static constexpr auto fields() {
    using O = SensorOptions;
    return std::tuple{
        Field{"bits", &O::bits, 8, 16, "of the numbers: 8 or 16"},
        Field{"blur_px", &O::blur_px, 0.0, 20.0,
              "sigma of a Gaussian blur of the image before its noise arises; 0: none"},
        Field{"jpeg_quality", &O::jpeg_quality, 0, 100,
              "of a JPEG compression of the finished image, 1 to 100; 0: none"}};
  }
};

/// How one view differs from the nominal exposure, per band.
struct SensorTone {
  std::array<double, 4> gain{1.0, 1.0, 1.0, 1.0};
  std::array<double, 4> offset{};  ///< haze, as a share of white
  double gamma = 1.0;              ///< factor on the nominal gamma
};

/// The radiometry of view number 0, 1, ...
SensorTone radiometry_of(const SensorOptions& options, std::uint64_t view);

/// Noise-free pixel value in [0, 1] for a radiance (1: the largest value of the file).
double tone(double radiance, std::size_t band, const SensorOptions& options, const SensorTone& r);

/// Throws std::invalid_argument for an option outside its range and for incompatible options: a
/// Bayer pattern requires the bands `rgb`, JPEG requires 8 bits and three bands.
void check_sensor(const SensorOptions& options);

/// The image taken by view number `view`: CV_8UC(n) or CV_16UC(n), n = 3 or 4 bands in the order of
/// `bands`, from the result of Renderer::radiance(). Byte-identical for any number of threads.
/// `first_row`: the image row at which the radiance begins; noise and Bayer pattern depend on it.
/// Pixel (0, 0) of the image records red. Throws std::invalid_argument under the same conditions as
/// check_sensor().
cv::Mat expose(const cv::Mat& radiance,
               const SensorOptions& options,
               std::uint64_t view,
               int first_row = 0);

/// The number of rows above and below on which a row of the image depends, a multiple of 16. Rows
/// that are exposed together with this many surrounding rows, starting at a multiple of 16, get the
/// same bytes as in the whole image.
int rows_around(const SensorOptions& options);

}  // namespace ridgeline::simulate
