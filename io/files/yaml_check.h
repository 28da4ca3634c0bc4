// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/error.h"
#include "io/kinds/recognise.h"

#include <yaml-cpp/yaml.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::io {

/// Throws IoError "PATH: line N: MESSAGE", without the line if the node has no position in the
/// file.
[[noreturn]] void fail_yaml(const std::string& path,
                            const YAML::Node& node,
                            const std::string& message);

/// The root of a YAML file. Throws IoError if it cannot be read (with the parser's line), if it is
/// empty or has more than one document, and if it is recognised as a kind other than `expected`.
YAML::Node load_yaml(const std::string& path, std::optional<FileGroup> expected = std::nullopt);
/// The root of a YAML text. Throws IoError if load_yaml() would reject the content; messages refer
/// to the text as `path`.
YAML::Node parse_yaml(const std::string& content, const std::string& path);

/// A mapping that is read strictly, so that a misspelt key does not silently fall back to a
/// default.
class YamlMap {
 public:
  /// Throws IoError if `node` is not a mapping, or has a duplicate key or one that is not in
  /// `known`.
  YamlMap(std::string path, const YAML::Node& node, const std::vector<std::string_view>& known);

  [[nodiscard]] bool has(const char* key) const { return find(key).has_value(); }

  // The functions below throw IoError if the key is missing or its value has the wrong form.
  [[nodiscard]] YAML::Node node(const char* key) const;
  [[nodiscard]] std::string text(const char* key) const;
  [[nodiscard]] double number(const char* key) const;  ///< finite
  [[nodiscard]] std::vector<double> numbers(const char* key, std::size_t count) const;
  /// A list of texts; a single text is read as a list of one.
  [[nodiscard]] std::vector<std::string> texts(const char* key) const;

  [[noreturn]] void fail(const char* key, const std::string& message) const;

 private:
  [[nodiscard]] std::optional<YAML::Node> find(const char* key) const;

  std::string path_;
  YAML::Node node_;
};

/// A sequence of `count` finite numbers; otherwise throws IoError, with `name` in its message.
std::vector<double> yaml_numbers(const std::string& path,
                                 const YAML::Node& node,
                                 const std::string& name,
                                 std::size_t count);

}  // namespace ridgeline::io
