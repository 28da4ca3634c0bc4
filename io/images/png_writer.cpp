// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/png_writer.h"

#include "io/files/atomic_file.h"
#include "io/images/encoded_picture.h"

namespace ridgeline::io {
void write_png(const std::string& path, const cv::Mat& picture) {
  write_file(path, png_bytes(picture));
}

}  // namespace ridgeline::io
