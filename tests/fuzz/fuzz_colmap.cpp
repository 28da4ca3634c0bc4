// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as the images of a COLMAP model, binary if the first byte is even, beside cameras that
// are good.
#include "io/error.h"
#include "io/orientation/colmap.h"

#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

/// A folder with cameras of both kinds; stays until the process ends.
const std::string& model_folder() {
  static const std::string folder = [] {
    const std::string made = "/tmp/fuzz.colmap." + std::to_string(getpid());
    std::filesystem::create_directories(made);
    std::ofstream(made + "/cameras.txt") << "1 SIMPLE_PINHOLE 640 480 500 320 240\n";
    const std::string binary(
        "\1\0\0\0\0\0\0\0\1\0\0\0\0\0\0\0\x80\2\0\0\0\0\0\0\xE0\1\0\0\0\0\0\0"
        "\0\0\0\0\0\0\x24\x40\0\0\0\0\0\0\x24\x40\0\0\0\0\0\0\x24\x40",
        56);
    std::ofstream(made + "/cameras.bin", std::ios::binary) << binary;
    return made;
  }();
  return folder;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const bool is_binary = data[0] % 2 == 0;
  const std::string images = model_folder() + (is_binary ? "/images.bin" : "/images.txt");
  std::ofstream(images, std::ios::binary)
      .write(reinterpret_cast<const char*>(data + 1), static_cast<std::streamsize>(size - 1));
  try {
    ridgeline::io::read_colmap(model_folder());
  } catch (const ridgeline::io::IoError&) {
  }
  std::filesystem::remove(images);
  return 0;
}
