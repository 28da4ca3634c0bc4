// SPDX-License-Identifier: BSD-3-Clause
#include "io/error.h"
#include "io/lines/mesh_edges.h"
#include "io/lines/readers.h"
#include "io/lines/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace ridgeline::io {
namespace {

enum class Encoding : std::uint8_t { kAscii, kLittleEndian, kBigEndian };
enum class Type : std::uint8_t { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat, kDouble };

struct Property {
  std::string name;
  Type type = Type::kFloat;
  bool is_list = false;
  Type count_type = Type::kUint8;
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  Encoding encoding = Encoding::kAscii;
  std::vector<Element> elements;
  std::size_t n_bytes = 0;
};

Type type_of(std::string_view name, const std::string& where) {
  struct Name {
    std::string_view old_name, new_name;
    Type type;
  };
  static constexpr Name kNames[] = {
      {"char", "int8", Type::kInt8},      {"uchar", "uint8", Type::kUint8},
      {"short", "int16", Type::kInt16},   {"ushort", "uint16", Type::kUint16},
      {"int", "int32", Type::kInt32},     {"uint", "uint32", Type::kUint32},
      {"float", "float32", Type::kFloat}, {"double", "float64", Type::kDouble}};
  for (const Name& entry : kNames) {
    if (name == entry.old_name || name == entry.new_name) return entry.type;
  }
  throw IoError(where, "'" + std::string(name) + "' is no PLY type");
}

Property property_of(const std::vector<std::string_view>& words, const std::string& where) {
  const bool is_list = words.size() == 5 && words[1] == "list";
  if (!is_list && words.size() != 3) throw IoError(where, "a property is 'property TYPE NAME'");
  if (!is_list) return {std::string(words[2]), type_of(words[1], where), false, Type::kUint8};
  return {std::string(words[4]), type_of(words[3], where), true, type_of(words[2], where)};
}

Encoding encoding_of(const std::vector<std::string_view>& words, const std::string& where) {
  if (words.size() == 3 && words[1] == "ascii") return Encoding::kAscii;
  if (words.size() == 3 && words[1] == "binary_little_endian") return Encoding::kLittleEndian;
  if (words.size() == 3 && words[1] == "binary_big_endian") return Encoding::kBigEndian;
  throw IoError(where, "format must be ascii, binary_little_endian or binary_big_endian");
}

Element element_of(const std::vector<std::string_view>& words, const std::string& where) {
  const std::optional<long> count = words.size() == 3 ? to_integer(words[2]) : std::nullopt;
  if (!count || *count < 0) throw IoError(where, "an element is 'element NAME COUNT'");
  return {std::string(words[1]), static_cast<std::size_t>(*count), {}};
}

Header parse_header(const std::string& path, std::string_view content) {
  const std::size_t end = content.find("end_header");
  const std::size_t newline = end == content.npos ? end : content.find('\n', end);
  if (!content.starts_with("ply") || newline == content.npos) {
    throw IoError(path, "is no PLY: it must begin with 'ply' and have an 'end_header'");
  }
  Header header;
  header.n_bytes = newline + 1;
  for (const TextRow& row : rows_of(content.substr(0, end))) {
    const std::string where = place(path, row.number);
    const std::vector<std::string_view> words = words_of(row.text);
    if (words[0] == "format") header.encoding = encoding_of(words, where);
    if (words[0] == "element") header.elements.push_back(element_of(words, where));
    if (words[0] != "property") continue;
    if (header.elements.empty()) throw IoError(where, "a property before any element");
    header.elements.back().properties.push_back(property_of(words, where));
  }
  for (const Element& element : header.elements) {
    if (element.properties.empty()) throw IoError(path, element.name + " has no properties");
  }
  return header;
}

/// The numbers of the body one after another, whatever their encoding.
class Body {
 public:
  Body(const std::string& path, std::string_view bytes, Encoding encoding)
      : path_(path), rest_(bytes), encoding_(encoding) {}

  double next(Type type) {
    if (encoding_ == Encoding::kAscii) return next_word();
    switch (type) {
      case Type::kInt8:
        return next_binary<std::int8_t>();
      case Type::kUint8:
        return next_binary<std::uint8_t>();
      case Type::kInt16:
        return next_binary<std::int16_t>();
      case Type::kUint16:
        return next_binary<std::uint16_t>();
      case Type::kInt32:
        return next_binary<std::int32_t>();
      case Type::kUint32:
        return next_binary<std::uint32_t>();
      case Type::kFloat:
        return static_cast<double>(next_binary<float>());
      case Type::kDouble:
        return next_binary<double>();
    }
    return 0.0;
  }

 private:
  [[noreturn]] void fail_truncated() const {
    throw IoError(path_, "ends before the elements that its header states");
  }

  double next_word() {
    constexpr std::string_view kBlanks = " \t\r\n";
    rest_.remove_prefix(std::min(rest_.find_first_not_of(kBlanks), rest_.size()));
    if (rest_.empty()) fail_truncated();
    const std::string_view word = rest_.substr(0, rest_.find_first_of(kBlanks));
    rest_.remove_prefix(word.size());
    return to_doubles({word}, path_).front();
  }

  template <typename T>
  T next_binary() {
    if (rest_.size() < sizeof(T)) fail_truncated();
    char bytes[sizeof(T)];
    std::memcpy(bytes, rest_.data(), sizeof(T));
    rest_.remove_prefix(sizeof(T));
    const bool is_big = std::endian::native == std::endian::big;
    if ((encoding_ == Encoding::kBigEndian) != is_big) std::reverse(bytes, bytes + sizeof(T));
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
  }

  std::string path_;
  std::string_view rest_;
  Encoding encoding_;
};

class PlyReader {
 public:
  PlyReader(const std::string& path, std::string_view content)
      : path_(path),
        set_(lines_for_file(path, "PLY", content.size())),
        header_(parse_header(path, content)),
        body_(path, content.substr(header_.n_bytes), header_.encoding) {}

  LineSet read() {
    for (const Element& element : header_.elements) {
      for (std::size_t i = 0; i < element.count; ++i) read_item(element);
    }
    if (edges_.empty() && !faces_.empty()) set_.format = "PLY, edges of faces";
    check_indices(edges_);
    check_indices(faces_);
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      append_segment({}, {vertices_[edges_[i][0]], vertices_[edges_[i][1]]}, i, set_);
    }
    if (edges_.empty()) append_distinct_edges(vertices_, faces_, set_);
    return std::move(set_);
  }

 private:
  void read_item(const Element& element) {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    IndexList edge(2);
    IndexList polygon;
    for (const Property& property : element.properties) {
      if (property.is_list) {
        const IndexList list = read_list(property);
        if (property.name == "vertex_indices" || property.name == "vertex_index") polygon = list;
        continue;
      }
      const double value = body_.next(property.type);
      if (property.name == "x") position.x() = value;
      if (property.name == "y") position.y() = value;
      if (property.name == "z") position.z() = value;
      if (property.name == "vertex1") edge[0] = index_of(value);
      if (property.name == "vertex2") edge[1] = index_of(value);
    }
    if (element.name == "vertex") vertices_.push_back(position);
    if (element.name == "edge") edges_.push_back(edge);
    refuse_more_lines(set_, edges_.size());
    if (element.name == "face") faces_.push_back(polygon);
  }

  IndexList read_list(const Property& property) {
    IndexList list;
    const std::size_t count = index_of(body_.next(property.count_type));
    for (std::size_t i = 0; i < count; ++i) list.push_back(index_of(body_.next(property.type)));
    return list;
  }

  /// A value that is no index becomes one that no file has, for check_indices() to name.
  static std::size_t index_of(double value) {
    const bool is_index = value >= 0.0 && value < 4294967296.0 && std::floor(value) == value;
    return is_index ? static_cast<std::size_t>(value) : static_cast<std::size_t>(-1);
  }

  void check_indices(const std::vector<IndexList>& lists) const {
    for (std::size_t i = 0; i < lists.size(); ++i) {
      for (const std::size_t index : lists[i]) {
        if (index < vertices_.size()) continue;
        throw IoError(path_, fmt::format("edge or face {} names a vertex beyond the {} vertices", i,
                                         vertices_.size()));
      }
    }
  }

  std::string path_;
  LineSet set_;
  Header header_;
  Body body_;
  Vertices vertices_;
  std::vector<IndexList> edges_;
  std::vector<IndexList> faces_;
};

}  // namespace

LineSet read_ply(const std::string& path, std::string_view content) {
  return PlyReader(path, content).read();
}

}  // namespace ridgeline::io
