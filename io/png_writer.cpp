// SPDX-License-Identifier: BSD-3-Clause
#include "io/png_writer.h"

#include "io/atomic_file.h"
#include "io/error.h"
#include "reconstruct/geometry/check.h"

#include <opencv2/imgcodecs.hpp>

#include <cstddef>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::io {
namespace {

/// The chunk "Software" of the texts of a PNG (its specification, 11.3.4.3), with length and checksum.
constexpr std::string_view kSoftware("\0\0\0\x12tEXtSoftware\0ridgeline\xfd\x5e\x07\x06", 30);
constexpr std::ptrdiff_t kEndOfHeader = 33;  ///< of signature and IHDR, which must come first

}  // namespace

void write_png(const std::string& path, const cv::Mat& picture) {
  check(!picture.empty() && (picture.type() == CV_8UC1 || picture.type() == CV_8UC3),
        "write_png: OpenCV type ", picture.type(), ", must be CV_8UC1 or CV_8UC3 and not empty");
  std::vector<unsigned char> bytes;
  if (!cv::imencode(".png", picture, bytes)) throw IoError(path, "could not be encoded as PNG");
  bytes.insert(bytes.begin() + kEndOfHeader, kSoftware.begin(), kSoftware.end());
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes are bytes
  write_file(path, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

bool is_own_png(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string chunk(kSoftware.size(), '\0');
  stream.seekg(kEndOfHeader);
  stream.read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
  return stream && chunk == kSoftware;
}

}  // namespace ridgeline::io
