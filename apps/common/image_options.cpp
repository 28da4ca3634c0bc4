// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/image_options.h"

#include "apps/common/option_flags.h"
#include "io/images/image.h"

namespace ridgeline::apps {

void add_image_size_option(CLI::App& app, double& max_image_mpx) {
  constexpr double kMost_mpx = static_cast<double>(io::kMaxImagePixels) / 1e6;
  app.add_option("--max-image-mpx", max_image_mpx,
                 fmt::format("largest image to be read, million pixels; 0: {:g}, and of a small "
                             "file no more than {:g} "
                             "and {:g} pixels per byte",
                             io::kDefaultMaxImage_mpx, io::kFreeImage_mpx, io::kMaxPixelsPerByte))
      ->check(in_range(0.0, kMost_mpx))
      ->capture_default_str();
}

void add_pair_check_option(CLI::App& app, double& max_y_parallax_px) {
  constexpr double kMost_px = 1e6;
  app.add_option("--max-y-parallax-px", max_y_parallax_px,
                 "images do not fit their cameras if points that both show lie farther from the "
                 "epipolar lines of "
                 "each other, median, px; 0: no check")
      ->check(in_range(0.0, kMost_px))
      ->capture_default_str();
}

}  // namespace ridgeline::apps
