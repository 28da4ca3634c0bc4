// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/tiff_tag.h"

#include <array>
#include <fstream>

namespace ridgeline::io {
namespace {

/// Reads integers of a TIFF (Adobe: TIFF, Revision 6.0, 1992, section 2) or BigTIFF in the byte
/// order of the file.
class TiffBytes {
 public:
  explicit TiffBytes(const std::string& path) : file_(path, std::ios::binary) {
    std::array<char, 2> order{};
    file_.read(order.data(), order.size());
    is_big_endian_ = order[0] == 'M';
  }

  /// std::nullopt beyond the end of the file.
  [[nodiscard]] std::optional<std::uint64_t> number(std::uint64_t offset, int n_bytes) {
    std::array<unsigned char, 8> bytes{};
    file_.clear();
    file_.seekg(static_cast<std::streamoff>(offset));
    if (!file_.read(reinterpret_cast<char*>(bytes.data()), n_bytes)) return std::nullopt;
    std::uint64_t value = 0;
    for (int i = 0; i < n_bytes; ++i) {
      const int place = is_big_endian_ ? i : n_bytes - 1 - i;
      value = value << 8U | bytes[static_cast<std::size_t>(place)];
    }
    return value;
  }

 private:
  std::ifstream file_;
  bool is_big_endian_ = false;
};

/// Size of SHORT, LONG or LONG8.
int bytes_of_type(std::optional<std::uint64_t> type) {
  constexpr std::uint64_t kLong = 4;
  constexpr std::uint64_t kLong8 = 16;
  if (type == kLong) return 4;
  return type == kLong8 ? 8 : 2;
}

/// Positions of the parts of a directory.
struct HeaderLayout {
  std::uint64_t first_offset;  ///< position of the offset of the first directory
  int offset_bytes, count_bytes;
  std::uint64_t entry_bytes, value_in_entry;
};
constexpr HeaderLayout kClassic{4, 4, 2, 12, 8};
constexpr HeaderLayout kBig{8, 8, 8, 20, 12};

}  // namespace

std::optional<std::uint64_t> tiff_tag(const std::string& path, int tag) {
  constexpr std::uint64_t kBigMagic = 43;
  constexpr std::uint64_t kMaxEntries = 4096;  // in an undamaged directory
  TiffBytes bytes(path);
  const HeaderLayout& layout = bytes.number(2, 2) == kBigMagic ? kBig : kClassic;
  const auto directory = bytes.number(layout.first_offset, layout.offset_bytes);
  if (!directory) return std::nullopt;
  const auto n_entries = bytes.number(*directory, layout.count_bytes);
  if (!n_entries || *n_entries > kMaxEntries) return std::nullopt;
  for (std::uint64_t i = 0; i < *n_entries; ++i) {
    const std::uint64_t entry =
        *directory + static_cast<std::uint64_t>(layout.count_bytes) + i * layout.entry_bytes;
    if (bytes.number(entry, 2) != static_cast<std::uint64_t>(tag)) continue;
    return bytes.number(entry + layout.value_in_entry, bytes_of_type(bytes.number(entry + 2, 2)));
  }
  return std::nullopt;
}

}  // namespace ridgeline::io
