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

/// A foreign `text`, such as a file's name, made safe for a sentence: its Markdown is escaped; for
/// a terminal its control characters are replaced.
std::string in_sentence(std::string_view text, Markup markup);

/// A table of text that can be written for every Markup. Cells are given as they shall be read;
/// what Markdown takes for markup is escaped when the table is written.
class PrintedTable {
 public:
  /// A column whose title ends in a colon is flush right: "RMS:".
  explicit PrintedTable(const std::vector<std::string>& columns) : PrintedTable(columns, {}) {}

  /// `keys` are the titles of the columns that tell the rows apart, `parts` those of their figures,
  /// in groups. If a plain table with several groups is too wide for a terminal, each group becomes
  /// a block that repeats the keys.
  PrintedTable(const std::vector<std::string>& keys,
               const std::vector<std::vector<std::string>>& parts);

  /// Adds a row with a cell for each column.
  template <typename... Cells>
  void add(const Cells&... cells) {
    add_row({fmt::format("{}", cells)...});
  }
  void add_row(std::vector<std::string> cells);

  /// Adds a sentence to the row that was added last. It stands below the row in plain text, and at
  /// the end of the row's last cell in Markdown.
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
    std::size_t part = 0;  ///< 0 for a key, else the place of its group in `parts`, from 1
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

/// A table below its caption.
std::string captioned(std::string_view caption, const PrintedTable& table, Markup markup);

/// Sentences as a paragraph. For a terminal it is broken between words into lines that are no wider
/// than tables; in Markdown it is not changed.
std::string paragraph(std::string_view sentences, Markup markup);

}  // namespace ridgeline::evaluate
