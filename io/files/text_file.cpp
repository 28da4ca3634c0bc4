// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/text_file.h"

#include "io/error.h"
#include "io/files/input_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

namespace ridgeline::io {

std::string read_text_file(const std::string& path) {
  require_regular_file(path);
  std::ifstream file(path, std::ios::binary);
  if (!file) throw IoError(path, std::string("cannot be opened: ") + std::strerror(errno));
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (file.bad()) throw IoError(path, "cannot be read");
  return text;
}

}  // namespace ridgeline::io
