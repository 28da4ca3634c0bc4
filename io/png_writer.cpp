// SPDX-License-Identifier: BSD-3-Clause
#include "io/png_writer.h"

#include "io/atomic_file.h"
#include "io/error.h"
#include "reconstruct/geometry/check.h"

#include <opencv2/imgcodecs.hpp>

#include <string_view>
#include <vector>

namespace ridgeline::io {

void write_png(const std::string& path, const cv::Mat& picture) {
  check(!picture.empty() && (picture.type() == CV_8UC1 || picture.type() == CV_8UC3),
        "write_png: OpenCV type ", picture.type(), ", must be CV_8UC1 or CV_8UC3 and not empty");
  std::vector<unsigned char> bytes;
  if (!cv::imencode(".png", picture, bytes)) throw IoError(path, "could not be encoded as PNG");
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes are bytes
  write_file(path, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

}  // namespace ridgeline::io
