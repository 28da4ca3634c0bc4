// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/tables/text_table.h"

#include "evaluate/tables/display_width.h"
#include "evaluate/tables/format.h"

#include <algorithm>
#include <utility>

namespace ridgeline::evaluate {
namespace {

constexpr std::size_t kMaxWidth = 100;  // columns; most terminals have as many
constexpr std::size_t kGap = 2;

}  // namespace

std::string in_sentence(std::string_view text, Markup markup) {
  return markup == Markup::kMarkdown ? escape_markdown(text) : printable(text);
}

PrintedTable::PrintedTable(const std::vector<std::string>& keys,
                           const std::vector<std::vector<std::string>>& parts) {
  add_columns(keys, 0);
  for (std::size_t i = 0; i < parts.size(); ++i) add_columns(parts[i], i + 1);
}

void PrintedTable::add_columns(const std::vector<std::string>& titles, std::size_t part) {
  for (const std::string& title : titles) {
    const bool is_right = title.ends_with(':');
    columns_.push_back({title.substr(0, title.size() - (is_right ? 1 : 0)), is_right, part});
  }
}

void PrintedTable::add_row(std::vector<std::string> cells) {
  rows_.push_back({std::move(cells), ""});
}

std::string PrintedTable::text(Markup markup) const {
  return markup == Markup::kMarkdown ? markdown() : plain();
}

std::string PrintedTable::markdown() const {
  std::string text = markdown_head();
  for (std::size_t i = 0; i < rows_.size(); ++i) text += markdown_row(i);
  return text;
}

std::string PrintedTable::markdown_head() const {
  std::string head = "|";
  std::string rule = "|";
  for (const ColumnLayout& column : columns_) {
    head += " " + escape_markdown(column.title) + " |";
    rule += column.is_right ? "--:|" : "---|";
  }
  return head + "\n" + rule + "\n";
}

std::string PrintedTable::markdown_row(std::size_t row) const {
  std::string text = "|";
  for (const std::string& cell : rows_[row].cells) text += " " + escape_markdown(cell) + " |";
  const std::string& note = rows_[row].note;
  if (!note.empty()) text.insert(text.size() - 2, ": " + escape_markdown(note));
  return text + "\n";
}

/// Whether a plain table shows a column: all keys, and columns with a figure in at least one row.
bool PrintedTable::has_figures(std::size_t column) const {
  if (columns_[column].part == 0 || rows_.empty()) return true;
  return std::ranges::any_of(rows_,
                             [&](const PrintedRow& row) { return row.cells[column] != kNoValue; });
}

std::size_t PrintedTable::width_of(std::size_t column) const {
  std::size_t width = display_width(printable(columns_[column].title));
  for (const PrintedRow& row : rows_) {
    width = std::max(width, display_width(printable(row.cells[column])));
  }
  return width;
}

std::string PrintedTable::plain() const {
  std::vector<std::size_t> all;
  std::vector<std::vector<std::size_t>> blocks(columns_.back().part + 1);
  std::size_t width = 0;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (!has_figures(i)) continue;
    width += (all.empty() ? 0 : kGap) + width_of(i);
    all.push_back(i);
    blocks[columns_[i].part].push_back(i);
  }
  if (width <= kMaxWidth || blocks.size() <= 2) return block(all);
  std::string text;
  for (std::size_t part = 1; part < blocks.size(); ++part) {
    if (blocks[part].empty()) continue;
    blocks[part].insert(blocks[part].begin(), blocks[0].begin(), blocks[0].end());
    text += (text.empty() ? "" : "\n") + block(blocks[part]);
  }
  return text;
}

std::string PrintedTable::block(const std::vector<std::size_t>& columns) const {
  std::vector<std::string> lines(rows_.size() + 1);
  for (const std::size_t i : columns) {
    const std::size_t width = width_of(i);
    for (std::size_t line = 0; line < lines.size(); ++line) {
      const std::string cell = printable(line == 0 ? columns_[i].title : rows_[line - 1].cells[i]);
      const std::string padding(width - display_width(cell), ' ');
      lines[line] += i == columns.front() ? "" : std::string(kGap, ' ');
      lines[line] += columns_[i].is_right ? padding + cell : cell + padding;
    }
  }
  std::string text;
  for (std::size_t line = 0; line < lines.size(); ++line) {
    text += lines[line].substr(0, lines[line].find_last_not_of(' ') + 1) + "\n";
    if (line > 0 && !rows_[line - 1].note.empty()) {
      text += std::string(kGap, ' ') + printable(rows_[line - 1].note) + "\n";
    }
  }
  return text;
}

std::string captioned(std::string_view caption, const PrintedTable& table, Markup markup) {
  const char* gap = markup == Markup::kMarkdown ? "\n\n" : "\n";
  return fmt::format("{}{}{}", caption, gap, table.text(markup));
}

std::string paragraph(std::string_view sentences, Markup markup) {
  std::string text(sentences);
  std::size_t begin = 0;
  for (std::size_t at = text.find(' '); at != std::string::npos && markup == Markup::kPlain;) {
    const std::size_t next = text.find(' ', at + 1);
    const std::size_t end = std::min(next, text.size());
    if (display_width(std::string_view(text).substr(begin, end - begin)) > kMaxWidth) {
      text[at] = '\n';
      begin = at + 1;
    }
    at = next;
  }
  return text + "\n";
}

}  // namespace ridgeline::evaluate
