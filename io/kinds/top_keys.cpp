// SPDX-License-Identifier: BSD-3-Clause
#include "io/kinds/top_keys.h"

#include "io/text/text.h"

#include <algorithm>
#include <cctype>
#include <utility>

namespace ridgeline::io {
namespace {

/// Scans braces, quotes, colons and commas; only keys directly inside the outermost braces count.
class FlowKeys {
 public:
  TopKeys read(std::string_view text) {
    for (const char c : text) {
      if (quote_ != '\0') {
        take_quoted(c);
      } else if (c == '"' || c == '\'') {
        quote_ = c;
      } else {
        take_plain(c);
      }
    }
    return std::move(found_);
  }

 private:
  void take_quoted(char c) {
    if (escaped_) {
      escaped_ = false;
    } else if (c == '\\') {
      escaped_ = true;
      return;
    } else if (c == quote_) {
      quote_ = '\0';
      return;
    }
    if (depth_ == 1) word_ += c;
  }

  void take_plain(char c) {
    if (c == '}' || c == ']') end_value();
    if (c == '{' || c == '[') ++depth_;
    if (c == '}' || c == ']') --depth_;
    if (depth_ != 1) return;
    if (c == ':' && !in_value_) {
      found_.names.push_back(std::exchange(word_, ""));
      in_value_ = true;
    } else if (c == ',') {
      end_value();
    } else if (std::isspace(static_cast<unsigned char>(c)) == 0 && c != '{' && c != '}') {
      word_ += c;
    }
  }

  void end_value() {
    if (depth_ != 1) return;
    if (in_value_ && found_.names.back() == "type") found_.type = word_;
    in_value_ = false;
    word_.clear();
  }

  TopKeys found_;
  std::string word_;
  int depth_ = 0;
  char quote_ = '\0';
  bool escaped_ = false, in_value_ = false;
};

/// Removes and returns the first row, including its leading blanks.
std::string_view take_row(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view row = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return row;
}

bool begins_a_key(std::string_view row) {
  return !row.empty() && (std::isalpha(static_cast<unsigned char>(row.front())) != 0 ||
                          std::string_view("_\"'").find(row.front()) != std::string_view::npos);
}

/// Whether a row is `key:` or `key: value`, without blanks before the colon.
bool is_key(std::string_view row) {
  const std::size_t colon = row.find(':');
  if (!begins_a_key(row) || colon == std::string_view::npos) return false;
  const std::string_view value = row.substr(colon + 1);
  return row.find(' ') > colon && (trimmed(value).empty() || value.front() == ' ');
}

/// The keys of YAML in block style: `key:` at the very beginning of a row. Empty for prose with
/// examples, in which most rows are not keys.
TopKeys block_keys(std::string_view text) {
  TopKeys found;
  std::size_t n_prose = 0;
  while (!text.empty()) {
    const std::string_view row = take_row(text);
    if (!is_key(row)) {
      n_prose += begins_a_key(row) ? 1 : 0;
      continue;
    }
    const std::size_t colon = row.find(':');
    const std::string_view value = row.substr(colon + 1);
    std::string name(row.substr(0, colon));
    std::erase_if(name, [](char c) { return c == '"' || c == '\''; });
    if (name == "type") found.type = trimmed(value);
    found.names.push_back(std::move(name));
  }
  return n_prose > found.names.size() ? TopKeys() : found;
}

}  // namespace

bool TopKeys::has(std::string_view name) const {
  return std::ranges::find(names, name) != names.end();
}

TopKeys top_keys(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const bool is_flow =
      first != std::string_view::npos && (text[first] == '{' || text[first] == '[');
  return is_flow ? FlowKeys().read(text.substr(first)) : block_keys(text);
}

}  // namespace ridgeline::io
