// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/png_writer.h"

#include "io/files/atomic_file.h"
#include "io/images/encoded_picture.h"

#include <cstddef>
#include <fstream>
#include <string>
#include <string_view>

namespace ridgeline::io {
namespace {

/// The chunk "Software" of the texts of a PNG (its specification, 11.3.4.3), with length and checksum.
constexpr std::string_view kSoftware("\0\0\0\x12tEXtSoftware\0ridgeline\xfd\x5e\x07\x06", 30);
constexpr std::size_t kEndOfHeader = 33;  ///< bytes of signature and IHDR, which must come first

}  // namespace

void write_png(const std::string& path, const cv::Mat& picture) {
  std::string bytes = png_bytes(picture);
  bytes.insert(kEndOfHeader, kSoftware);
  write_file(path, bytes);
}

bool is_own_png(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string chunk(kSoftware.size(), '\0');
  stream.seekg(kEndOfHeader);
  stream.read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
  return stream && chunk == kSoftware;
}

}  // namespace ridgeline::io
