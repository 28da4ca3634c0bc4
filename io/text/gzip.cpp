// SPDX-License-Identifier: BSD-3-Clause
#include "io/text/gzip.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <limits>

namespace ridgeline::io {

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1F\x8B"); }

Inflated inflated(std::string_view bytes, std::size_t most_bytes) {
  Inflated result;
  z_stream stream{};
  constexpr int kGzipHeader = 16;
  if (inflateInit2(&stream, MAX_WBITS + kGzipHeader) != Z_OK) return result;
  std::array<char, 1U << 16U> buffer;
  int state = Z_OK;
  while (state == Z_OK && result.text.size() < most_bytes) {
    if (stream.avail_in == 0) {
      const std::size_t n = std::min<std::size_t>(bytes.size(), 1U << 30U);
      // zlib does not write to its input
      stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
      stream.avail_in = static_cast<uInt>(n);
      bytes.remove_prefix(n);
    }
    stream.next_out = reinterpret_cast<Bytef*>(buffer.data());
    stream.avail_out = static_cast<uInt>(std::min(buffer.size(), most_bytes - result.text.size()));
    const uInt room = stream.avail_out;
    state = inflate(&stream, Z_NO_FLUSH);
    result.text.append(buffer.data(), room - stream.avail_out);
    // A file may consist of several members that were compressed separately.
    const bool goes_on = state == Z_STREAM_END && stream.avail_in + bytes.size() > 0;
    if (goes_on) state = inflateReset(&stream);
  }
  result.is_whole = state == Z_STREAM_END;
  inflateEnd(&stream);
  return result;
}

}  // namespace ridgeline::io
