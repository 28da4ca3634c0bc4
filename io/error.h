// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace ridgeline::io {

/// An error concerning a file. Message: "PATH: what is wrong: value, and the rule it breaks", one
/// line.
class IoError : public std::runtime_error {
 public:
  IoError(const std::string& path, const std::string& message)
      : std::runtime_error(path + ": " + message), path_(path) {}

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// The error for a file or folder that does not exist.
class MissingFileError : public IoError {
 public:
  using IoError::IoError;
};

}  // namespace ridgeline::io
