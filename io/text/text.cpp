// SPDX-License-Identifier: BSD-3-Clause
#include "io/text/text.h"

#include "io/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace ridgeline::io {
namespace {

constexpr std::string_view kWhiteSpace = " \t\r\v\f";

template <typename Number>
std::optional<Number> from_whole(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

std::vector<TextRow> rows_of(std::string_view content) {
  std::vector<TextRow> rows;
  for (int number = 1; !content.empty(); ++number) {
    const std::size_t end = content.find('\n');
    const std::string_view text = trimmed(content.substr(0, end));
    if (!text.empty()) rows.push_back({number, text});
    content.remove_prefix(end == std::string_view::npos ? content.size() : end + 1);
  }
  return rows;
}

std::string place(const std::string& path, int row_number) {
  return path + ":" + std::to_string(row_number);
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kWhiteSpace);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kWhiteSpace) - first + 1);
}

std::vector<std::string> csv_fields_of(std::string_view row,
                                       char separator,
                                       const std::string& where) {
  constexpr std::size_t kMaxFields = 10'000;
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const char c = row[i];
    if (c == '"' && quoted && i + 1 < row.size() && row[i + 1] == '"') {
      fields.back() += row[++i];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == separator && !quoted) {
      fields.emplace_back();
      if (fields.size() > kMaxFields) {
        throw IoError(where, fmt::format("more than {} fields", kMaxFields));
      }
    } else {
      fields.back() += c;
    }
  }
  if (quoted) throw IoError(where, "a quoted field is not closed");
  for (std::string& field : fields) field = std::string(trimmed(field));
  return fields;
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return lower;
}

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
    const std::size_t length = std::min(text.find_first_of(kWhiteSpace), text.size());
    words.push_back(text.substr(0, length));
    text.remove_prefix(length);
  }
  return words;
}

std::optional<double> to_double(std::string_view text) { return from_whole<double>(text); }
std::optional<long> to_integer(std::string_view text) { return from_whole<long>(text); }

std::vector<double> to_doubles(const std::vector<std::string_view>& words,
                               const std::string& where) {
  std::vector<double> numbers;
  numbers.reserve(words.size());
  for (const std::string_view word : words) {
    const std::optional<double> number = to_double(word);
    if (!number) throw IoError(where, "'" + std::string(word.substr(0, 40)) + "' is not a number");
    numbers.push_back(*number);
  }
  return numbers;
}

}  // namespace ridgeline::io
