// SPDX-License-Identifier: BSD-3-Clause
#include "io/orientation/xml_tree.h"

#include "io/error.h"
#include "io/gdal/ogr_support.h"
#include "io/orientation/orientation_text.h"
#include "io/text/text.h"

#include <cpl_minixml.h>
#include <fmt/format.h>

#include <cmath>

namespace ridgeline::io {
namespace {

/// The first node, starting with `node` and its following siblings, that has this type and name.
const CPLXMLNode* find_from(const CPLXMLNode* node, CPLXMLNodeType type, std::string_view name) {
  while (node != nullptr && (node->eType != type || name != node->pszValue)) node = node->psNext;
  return node;
}

std::string text_under(const CPLXMLNode* node) {
  const CPLXMLNode* child = node == nullptr ? nullptr : node->psChild;
  while (child != nullptr && child->eType != CXT_Text) child = child->psNext;
  return child == nullptr ? "" : std::string(trimmed(child->pszValue));
}

}  // namespace

std::string XmlElement::name() const { return node_ == nullptr ? "" : node_->pszValue; }

XmlElement XmlElement::child(std::string_view name) const {
  if (node_ == nullptr) return *this;
  const std::size_t slash = name.find('/');
  const XmlElement found(path_, find_from(node_->psChild, CXT_Element, name.substr(0, slash)));
  return slash == std::string_view::npos ? found : found.child(name.substr(slash + 1));
}

std::vector<XmlElement> XmlElement::children(std::string_view name) const {
  std::vector<XmlElement> found;
  const CPLXMLNode* next =
      node_ == nullptr ? nullptr : find_from(node_->psChild, CXT_Element, name);
  for (; next != nullptr; next = find_from(next->psNext, CXT_Element, name)) {
    found.emplace_back(path_, next);
  }
  return found;
}

std::vector<XmlElement> XmlElement::children() const {
  std::vector<XmlElement> found;
  const CPLXMLNode* next = node_ == nullptr ? nullptr : node_->psChild;
  for (; next != nullptr; next = next->psNext) {
    if (next->eType == CXT_Element) found.emplace_back(path_, next);
  }
  return found;
}

std::string XmlElement::text() const { return text_under(node_); }

std::string XmlElement::attribute(std::string_view name) const {
  if (node_ == nullptr) return "";
  return text_under(find_from(node_->psChild, CXT_Attribute, name));
}

double XmlElement::finite(std::string_view text, std::string_view name) const {
  const std::optional<double> value = to_double(text);
  if (!value || !std::isfinite(*value)) {
    fail(fmt::format("{} = '{}'; must be a finite number", name, text));
  }
  return *value;
}

std::optional<double> XmlElement::number_if_there(std::string_view child) const {
  const XmlElement element = this->child(child);
  if (!element.exists()) return std::nullopt;
  return finite(element.text(), child);
}

double XmlElement::number(std::string_view child) const {
  const std::optional<double> value = number_if_there(child);
  if (!value) fail(fmt::format("{} is missing", child));
  return *value;
}

double XmlElement::attribute_number(std::string_view name) const {
  return finite(attribute(name), name);
}

std::vector<double> XmlElement::numbers(std::size_t count) const {
  const std::string text = this->text();
  std::vector<double> values;
  for (const std::string_view word : words_of(text)) values.push_back(finite(word, name()));
  if (values.size() != count) fail(fmt::format("{} numbers; {} are needed", values.size(), count));
  return values;
}

Eigen::Vector3d XmlElement::xyz() const { return {number("x"), number("y"), number("z")}; }

void XmlElement::fail(const std::string& message) const {
  throw IoError(*path_, fmt::format("<{}>: {}", name(), message));
}

XmlDocument::XmlDocument(const std::string& path) : path_(path) {
  const std::string text = read_orientation_text(path);
  const QuietGdal quiet;
  tree_ = CPLParseXMLString(text.c_str());
  if (tree_ == nullptr)
    throw IoError(path, "is not XML: " + quiet.complaints("it cannot be parsed"));
}

XmlDocument::~XmlDocument() { CPLDestroyXMLNode(tree_); }

XmlElement XmlDocument::root(std::string_view name) const {
  const CPLXMLNode* const root = find_from(tree_, CXT_Element, name);
  if (root == nullptr) throw IoError(path_, fmt::format("has no element <{}>", name));
  return {&path_, root};
}

}  // namespace ridgeline::io
