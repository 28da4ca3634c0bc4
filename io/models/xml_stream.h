// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace ridgeline::io {

/// The name of an element or an attribute: its namespace, not the prefix that a file gives it, and
/// its local name.
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
  const char* const* pairs_;  ///< as expat gives them: name, value, ..., nullptr
};

/// What is called for the parts of a document, in their order. Views last as long as the call.
struct XmlEvents {
  std::function<void(const XmlName&, const XmlAttributes&)> start;
  std::function<void(std::string_view)> text;  ///< a text may come in several pieces
  std::function<void()> end;
};

/// An XML file, read piece by piece, also if it is compressed by gzip: its first bytes tell, not
/// its name. What would take memory or time out of proportion is refused: a DOCTYPE, and with it
/// all entities of the file, elements that lie more than 200 deep within each other, tags and
/// comments of more than 4 MiB, and more than 100 bytes of text for each byte of a compressed file.
class XmlStream {
 public:
  XmlStream(const std::string& path, XmlEvents events);
  ~XmlStream();
  XmlStream(const XmlStream&) = delete;
  XmlStream& operator=(const XmlStream&) = delete;

  /// Reads the whole file. Throws IoError if it cannot be read or is no whole XML document, and
  /// whatever an event throws.
  void read();

  /// `path:line` of the event that is reported.
  [[nodiscard]] std::string place() const;

 private:
  struct Parser;

  std::string path_;
  std::unique_ptr<Parser> parser_;
};

}  // namespace ridgeline::io
