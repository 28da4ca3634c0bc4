// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/yaml_check.h"

#include "io/files/input_file.h"
#include "io/text/nearest_name.h"
#include "io/text/text.h"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

namespace ridgeline::io {
namespace {

std::string scalar_text(const std::string& path, const YAML::Node& node, const std::string& name) {
  if (!node.IsScalar() || node.Scalar().empty()) fail_yaml(path, node, name + " must be a string");
  return node.Scalar();
}

double number_of(const std::string& path, const YAML::Node& node, const std::string& name) {
  const std::optional<double> value = node.IsScalar() ? to_double(node.Scalar()) : std::nullopt;
  if (!value || !std::isfinite(*value)) {
    const std::string found = node.IsScalar() ? node.Scalar() : "a list or a mapping";
    fail_yaml(path, node, fmt::format("{} = {}; must be a finite number", name, found));
  }
  return *value;
}

/// Throws IoError if the file has too many values. yaml-cpp needs half a kilobyte and 5
/// microseconds for each.
void require_few_values(const std::string& path, std::string_view content) {
  constexpr std::ptrdiff_t kMaxValues = 400'000;  // enough for the cameras of 10,000 images
  const auto n_values = std::ranges::count_if(
      content, [](char c) { return std::string_view(",:\n[{").find(c) != std::string_view::npos; });
  if (n_values <= kMaxValues) return;
  throw IoError(path, fmt::format("has about {} values; a YAML file may have at most {}", n_values,
                                  kMaxValues));
}

/// Where a document begins. All other events are ignored.
class DocumentStart : public YAML::EventHandler {
 public:
  void OnDocumentStart(const YAML::Mark& mark) override { position = mark; }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&,
                const std::string&,
                YAML::anchor_t,
                const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&,
                       const std::string&,
                       YAML::anchor_t,
                       YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&,
                  const std::string&,
                  YAML::anchor_t,
                  YAML::EmitterStyle::value) override {}
  void OnMapEnd() override {}

  YAML::Mark position = YAML::Mark::null_mark();
};

/// Throws YAML::ParserException for text that begins no value, such as a comma: yaml-cpp does not
/// consume it and would find empty documents there without end.
void require_values(const std::string& content) {
  std::istringstream stream(content);
  YAML::Parser parser(stream);
  DocumentStart start;
  for (int last = -1; parser.HandleNextDocument(start); last = start.position.pos) {
    if (start.position.pos == last)
      throw YAML::ParserException(start.position, "a value is expected");
  }
}

}  // namespace

void fail_yaml(const std::string& path, const YAML::Node& node, const std::string& message) {
  const YAML::Mark mark = node.Mark();
  throw IoError(path,
                mark.is_null() ? message : fmt::format("line {}: {}", mark.line + 1, message));
}

YAML::Node load_yaml(const std::string& path, std::optional<FileGroup> expected) {
  return parse_yaml(read_input(path, expected), path);
}

YAML::Node parse_yaml(const std::string& content, const std::string& path) {
  if (trimmed(content).empty()) throw IoError(path, "is empty");
  require_few_values(path, content);
  try {
    require_values(content);
    const std::vector<YAML::Node> documents = YAML::LoadAll(content);
    if (documents.size() > 1) {
      fail_yaml(path, documents[1], "a second document begins ('---'); a single one is expected");
    }
    return documents.empty() ? YAML::Node() : documents.front();
  } catch (const YAML::Exception& error) {
    throw IoError(path, fmt::format("line {}: not YAML: {}", error.mark.line + 1, error.msg));
  }
}

YamlMap::YamlMap(std::string path,
                 const YAML::Node& node,
                 const std::vector<std::string_view>& known)
    : path_(std::move(path)), node_(node) {
  const std::string known_keys = fmt::format("known keys: {}", fmt::join(known, ", "));
  if (!node.IsMap()) fail_yaml(path_, node, "a mapping is expected; " + known_keys);
  std::set<std::string> seen;
  for (const auto& entry : node) {
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "(not a string)";
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      fail_yaml(path_, entry.first,
                fmt::format("unknown key '{}', did you mean '{}'? {}", key,
                            nearest_name(key, known), known_keys));
    }
    if (!seen.insert(key).second) {
      fail_yaml(path_, entry.first, fmt::format("key '{}' appears twice", key));
    }
  }
}

std::optional<YAML::Node> YamlMap::find(const char* key) const {
  const YAML::Node value = node_[key];
  if (!value || value.IsNull()) return std::nullopt;
  return value;
}

YAML::Node YamlMap::node(const char* key) const {
  const std::optional<YAML::Node> value = find(key);
  if (!value) fail_yaml(path_, node_, fmt::format("key '{}' is missing", key));
  return *value;
}

std::string YamlMap::text(const char* key) const { return scalar_text(path_, node(key), key); }

double YamlMap::number(const char* key) const { return number_of(path_, node(key), key); }

std::vector<double> YamlMap::numbers(const char* key, std::size_t count) const {
  return yaml_numbers(path_, node(key), key, count);
}

std::vector<std::string> YamlMap::texts(const char* key) const {
  const YAML::Node value = node(key);
  if (!value.IsSequence()) return {scalar_text(path_, value, key)};
  std::vector<std::string> texts;
  for (const YAML::Node& item : value) texts.push_back(scalar_text(path_, item, key));
  return texts;
}

void YamlMap::fail(const char* key, const std::string& message) const {
  fail_yaml(path_, find(key).value_or(node_), message);
}

std::vector<double> yaml_numbers(const std::string& path,
                                 const YAML::Node& node,
                                 const std::string& name,
                                 std::size_t count) {
  if (!node.IsSequence() || node.size() != count) {
    fail_yaml(path, node, fmt::format("{} must be a list of {} numbers", name, count));
  }
  std::vector<double> numbers;
  for (const YAML::Node& item : node) numbers.push_back(number_of(path, item, name));
  return numbers;
}

}  // namespace ridgeline::io
