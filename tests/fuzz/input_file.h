// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace ridgeline::io::fuzz {

/// A file that holds one input after the other, for readers that open their file by its path. A
/// program has one of each name; the file stays in memory where /dev/shm is there.
class InputFile {
 public:
  explicit InputFile(const std::string& name)
      : path_((std::filesystem::exists("/dev/shm") ? "/dev/shm" : "/tmp") + std::string("/fuzz.") +
              std::to_string(getpid()) + "." + name) {}
  ~InputFile() { std::filesystem::remove(path_); }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  /// Replaces what the file holds and returns its path.
  const std::string& hold(const std::uint8_t* data, std::size_t size) const {
    std::ofstream(path_, std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    return path_;
  }

 private:
  std::string path_;
};

}  // namespace ridgeline::io::fuzz
