// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

struct CPLXMLNode;

namespace ridgeline::io {

/// An element of an XML document; the document must outlive it. A missing element has no text and
/// no children.
class XmlElement {
 public:
  XmlElement(const std::string* path, const CPLXMLNode* node) : path_(path), node_(node) {}

  [[nodiscard]] bool exists() const { return node_ != nullptr; }
  [[nodiscard]] std::string name() const;
  /// The first child with this name; "a/b" is a child of a child.
  [[nodiscard]] XmlElement child(std::string_view name) const;
  [[nodiscard]] std::vector<XmlElement> children(std::string_view name) const;
  [[nodiscard]] std::vector<XmlElement> children() const;
  /// The text of the element, trimmed; empty if there is none.
  [[nodiscard]] std::string text() const;
  [[nodiscard]] std::string attribute(std::string_view name) const;  ///< empty if there is none

  // The functions below throw IoError, naming the element, for a text that is not a finite number.
  [[nodiscard]] double number(
      std::string_view child) const;  ///< also throws IoError if the child is missing
  [[nodiscard]] std::optional<double> number_if_there(std::string_view child) const;
  [[nodiscard]] double number_or(std::string_view child, double otherwise) const {
    return number_if_there(child).value_or(otherwise);
  }
  [[nodiscard]] double attribute_number(std::string_view name) const;
  [[nodiscard]] std::vector<double> numbers(
      std::size_t count) const;               ///< in the text, separated by blanks
  [[nodiscard]] Eigen::Vector3d xyz() const;  ///< of the children x, y and z

  [[noreturn]] void fail(const std::string& message) const;

 private:
  [[nodiscard]] double finite(std::string_view text, std::string_view name) const;

  const std::string* path_;
  const CPLXMLNode* node_;
};

/// A parsed XML file.
class XmlDocument {
 public:
  /// Throws IoError if the file cannot be read or is not a complete XML document.
  explicit XmlDocument(const std::string& path);
  ~XmlDocument();
  XmlDocument(const XmlDocument&) = delete;
  XmlDocument& operator=(const XmlDocument&) = delete;

  /// The outermost element with this name. Throws IoError if there is none.
  [[nodiscard]] XmlElement root(std::string_view name) const;

 private:
  std::string path_;
  CPLXMLNode* tree_ = nullptr;
};

}  // namespace ridgeline::io
