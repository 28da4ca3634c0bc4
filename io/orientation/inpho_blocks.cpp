// SPDX-License-Identifier: BSD-3-Clause
#include "io/orientation/inpho_blocks.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace ridgeline::io {
namespace {

class InphoParser {
 public:
  explicit InphoParser(std::string_view content) {
    for (int number = 1; !content.empty(); ++number) {
      const std::size_t end = content.find('\n');
      take({number, content.substr(0, end)});
      content.remove_prefix(end == std::string_view::npos ? content.size() : end + 1);
    }
  }

  [[nodiscard]] std::vector<InphoBlock> take_blocks() { return std::move(blocks_); }

 private:
  void take(const TextRow& row) {
    const std::string_view text = trimmed(row.text);
    if (text.empty()) return;
    if (!text.starts_with('$')) {
      if (last_ != nullptr) last_->rows.push_back({row.number, text});
      return;
    }
    const std::size_t colon = text.find_first_of(": \t");
    const std::string key(text.substr(0, colon));
    if (key.starts_with("$END")) return close();
    const bool begins = row.text.front() == '$' || key == "$PHOTO" || key == "$CAMERA_DEFINITION";
    if (begins) blocks_.push_back({key, row.number, false, {}});
    if (blocks_.empty()) return;
    if (key == "$CALIBRATION_SET") return begin_calibration();
    const std::size_t value = text.find(':');
    InphoEntry entry{
        row.number,
        value == std::string_view::npos ? "" : std::string(trimmed(text.substr(value + 1))),
        {}};
    last_ = &blocks_.back().entries.try_emplace(prefix_ + key, std::move(entry)).first->second;
  }

  void close() {
    last_ = nullptr;
    prefix_.clear();
    if (!blocks_.empty()) blocks_.back().is_closed = true;
  }

  /// The calibrations of one camera are numbered to keep their keys apart.
  void begin_calibration() {
    last_ = nullptr;
    const auto n = std::ranges::count_if(
        blocks_.back().entries, [](const auto& entry) { return entry.first.ends_with("/$ID"); });
    prefix_ = fmt::format("{}/", n);
  }

  std::vector<InphoBlock> blocks_;
  InphoEntry* last_ = nullptr;
  std::string prefix_;
};

}  // namespace

std::vector<InphoBlock> inpho_blocks(std::string_view content) {
  return InphoParser(content).take_blocks();
}

}  // namespace ridgeline::io
