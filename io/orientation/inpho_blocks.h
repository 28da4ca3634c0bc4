// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/text/text.h"

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::io {

/// A row "$KEY : value" and the rows below it, up to the next key.
struct InphoEntry {
  int row = 0;  ///< for messages
  std::string value;
  std::vector<TextRow> rows;
};

/// The content from $PHOTO or $CAMERA to the next such block. If a key occurs several times, the
/// first one counts.
struct InphoBlock {
  std::string name;
  int row = 0;
  bool is_closed = false;
  std::map<std::string, InphoEntry, std::less<>> entries;

  [[nodiscard]] const InphoEntry* find(std::string_view key) const {
    const auto entry = entries.find(key);
    return entry == entries.end() ? nullptr : &entry->second;
  }
  [[nodiscard]] std::string text(std::string_view key) const {
    const InphoEntry* const entry = find(key);
    return entry == nullptr ? "" : entry->value;
  }
};

/// The blocks of an Inpho project file. A new one begins at each key without leading blanks, and at
/// each $PHOTO and $CAMERA_DEFINITION. If a camera has several calibrations, the keys of each are
/// prefixed with its number: "0/$ID". The rows point into `content`.
std::vector<InphoBlock> inpho_blocks(std::string_view content);

}  // namespace ridgeline::io
