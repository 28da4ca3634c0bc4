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

/// The target of a text: a terminal, or a page that renders Markdown.
enum class Markup : std::uint8_t { kPlain, kMarkdown };

/// Makes foreign text, such as a file name, safe for use in a sentence: escapes Markdown, or
/// replaces control characters for a terminal.
std::string in_sentence(std::string_view text, Markup markup);

/// A table of text that can be written for every Markup. Cells are given as plain text; Markdown
/// syntax is escaped when the table is written.
class PrintedTable {
 public:
  /// A column whose title ends in a colon is right-aligned: "RMS:".
  explicit PrintedTable(const std::vector<std::string>& columns) : PrintedTable(columns, {}) {}

  /// `keys`: titles of the columns that identify a row. `parts`: titles of the figure columns, in
  /// groups. If a plain table with several groups is too wide for a terminal, each group becomes a
  /// block that repeats the keys.
  PrintedTable(const std::vector<std::string>& keys,
               const std::vector<std::vector<std::string>>& parts);

  /// Adds a row with a cell for each column.
  template <typename... Cells>
  void add(const Cells&... cells) {
    add_row({fmt::format("{}", cells)...});
  }
  void add_row(std::vector<std::string> cells);

  /// Adds a sentence to the most recently added row. It is printed below the row in plain text and
  /// at the end of the row's last cell in Markdown.
  void add_note(std::string note) { rows_.back().note = std::move(note); }

  [[nodiscard]] bool empty() const { return rows_.empty(); }
  [[nodiscard]] std::size_t size() const { return rows_.size(); }

  [[nodiscard]] std::string text(Markup markup) const;
  [[nodiscard]] std::string markdown_head() const;
  [[nodiscard]] std::string markdown_row(std::size_t row) const;

 private:
  struct ColumnLayout {
    std::string title;
    bool is_right = false;
    std::size_t part = 0;  ///< 0 for a key, else the 1-based position of its group in `parts`
  };
  struct PrintedRow {
    std::vector<std::string> cells;
    std::string note;
  };

  void add_columns(const std::vector<std::string>& titles, std::size_t part);
  [[nodiscard]] std::string markdown() const;
  [[nodiscard]] std::string plain() const;
  [[nodiscard]] bool has_figures(std::size_t column) const;
  [[nodiscard]] std::size_t width_of(std::size_t column) const;
  [[nodiscard]] std::string block(const std::vector<std::size_t>& columns) const;

  std::vector<ColumnLayout> columns_;
  std::vector<PrintedRow> rows_;
};

/// A table with its caption above it.
std::string captioned(std::string_view caption, const PrintedTable& table, Markup markup);

/// Sentences as a paragraph. For a terminal, lines are wrapped at the maximum width of tables;
/// Markdown is unchanged.
std::string paragraph(std::string_view sentences, Markup markup);

}  // namespace ridgeline::evaluate
