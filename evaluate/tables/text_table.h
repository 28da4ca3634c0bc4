// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ridgeline::evaluate {

/// What a text is written for: a terminal, or a page that shows Markdown.
enum class Markup : std::uint8_t { kPlain, kMarkdown };

/// `text`, which may be anybody's, as it stands in a sentence.
std::string in_sentence(std::string_view text, Markup markup);

/// Rows of text under titles, given once for all that they are written for. Cells are as they shall be read; what
/// Markdown takes for markup is escaped when they are written.
class TextTable {
 public:
  /// A column whose title ends in a colon is flush right: "RMS:".
  explicit TextTable(const std::vector<std::string>& columns) : TextTable(columns, {}) {}

  /// `keys` tell the rows apart, `parts` are the columns of their figures. A plain table that would be too wide for a
  /// terminal has a block for each part, all with the keys.
  TextTable(const std::vector<std::string>& keys,
            const std::vector<std::vector<std::string>>& parts);

  /// A cell for each column.
  template <typename... Cells>
  void add(const Cells&... cells) {
    add_row({fmt::format("{}", cells)...});
  }
  void add_row(std::vector<std::string> cells);

  /// A sentence to the row that was added last: plain below it, in Markdown at the end of its last cell.
  void add_note(std::string note) { rows_.back().note = std::move(note); }

  [[nodiscard]] bool empty() const { return rows_.empty(); }
  [[nodiscard]] std::size_t size() const { return rows_.size(); }

  [[nodiscard]] std::string text(Markup markup) const;
  [[nodiscard]] std::string markdown_head() const;
  [[nodiscard]] std::string markdown_row(std::size_t row) const;

 private:
  struct Column {
    std::string title;
    bool is_right = false;
    std::size_t part = 0;  ///< 0: the keys
  };
  struct Row {
    std::vector<std::string> cells;
    std::string note;
  };

  void add_columns(const std::vector<std::string>& titles, std::size_t part);
  [[nodiscard]] std::string markdown() const;
  [[nodiscard]] std::string plain() const;
  [[nodiscard]] bool has_figures(std::size_t column) const;
  [[nodiscard]] std::size_t width_of(std::size_t column) const;
  [[nodiscard]] std::string block(const std::vector<std::size_t>& columns) const;

  std::vector<Column> columns_;
  std::vector<Row> rows_;
};

/// A table below its caption.
std::string captioned(std::string_view caption, const TextTable& table, Markup markup);

/// Sentences as a paragraph: in a terminal broken between words into lines that are no wider than tables, and not
/// changed in Markdown.
std::string paragraph(std::string_view sentences, Markup markup);

}  // namespace ridgeline::evaluate
