// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace ridgeline::io {

/// The name of an element or an attribute: its namespace (not the prefix used in the file) and its
/// local name.
struct XmlName {
  std::string_view space, local;
};

/// The attributes of an element that has just begun.
class XmlAttributes {
 public:
  explicit XmlAttributes(const char* const* pairs) : pairs_(pairs) {}

  /// The value of an attribute without a namespace, or of one whose namespace begins with `space`;
  /// empty if there is none.
  [[nodiscard]] std::string_view value(std::string_view local, std::string_view space = {}) const;

 private:
  const char* const* pairs_;  ///< as passed by expat: name, value, ..., nullptr
};

/// Callbacks for the parts of a document, called in document order. Views are valid only during the
/// call.
struct XmlEvents {
  std::function<void(const XmlName&, const XmlAttributes&)> start;
  std::function<void(std::string_view)> text;  ///< a text may arrive in several pieces
  std::function<void()> end;
};

/// An XML file, read piece by piece; gzip compression is detected from the first bytes, not from
/// the name. Anything that would take disproportionate memory or time is rejected: a DOCTYPE, and
/// with it all entities of the file, elements nested more than 200 deep, tags and comments of more
/// than 4 MiB, and more than 100 bytes of text per byte of a compressed file.
class XmlStream {
 public:
  XmlStream(const std::string& path, XmlEvents events);
  ~XmlStream();
  XmlStream(const XmlStream&) = delete;
  XmlStream& operator=(const XmlStream&) = delete;

  /// Reads the whole file. Throws IoError if it cannot be read or is not a complete XML document,
  /// and whatever an event throws.
  void read();

  /// `path:line` of the current event.
  [[nodiscard]] std::string place() const;

 private:
  struct Parser;

  std::string path_;
  std::unique_ptr<Parser> parser_;
};

}  // namespace ridgeline::io
