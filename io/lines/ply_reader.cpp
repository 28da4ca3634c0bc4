// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/ply_header.h"
#include "io/error.h"
#include "io/lines/mesh_edges.h"
#include "io/lines/readers.h"
#include "io/text/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace ridgeline::io {
namespace {

PlyHeader header_of(const std::string& path, std::string_view content) {
  PlyHeader header = read_ply_header(std::as_bytes(std::span(content)), path);
  for (const PlyElement& element : header.elements) {
    // rows without bytes would never end
    if (element.properties.empty()) throw IoError(path, element.name + " has no properties");
  }
  return header;
}

/// The names of an element's properties for a message: "x, y, z, red".
std::string property_names(const PlyElement& element) {
  std::string names;
  for (const PlyProperty& property : element.properties) {
    names += (names.empty() ? "" : ", ") + property.name;
  }
  return names;
}

bool is_index_type(ScalarType type) {
  return type != ScalarType::kFloat32 && type != ScalarType::kFloat64 && size_of(type) > 1;
}

/// The properties of the elements from which lines are made.
struct PlyColumns {
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::array<std::size_t, 3> xyz{kNone, kNone, kNone};
  std::array<std::size_t, 2> ends{kNone, kNone};  ///< the two vertices of an edge
  std::size_t edge_list = kNone, face_list = kNone;
};

std::size_t property_named(const PlyElement& element, std::string_view name) {
  const auto found = std::ranges::find(element.properties, name, &PlyProperty::name);
  return found == element.properties.end()
             ? PlyColumns::kNone
             : static_cast<std::size_t>(found - element.properties.begin());
}

/// The list of a face or an edge by its usual names, otherwise the only list of indices.
std::size_t index_list(const PlyElement& element) {
  for (const char* const name : {"vertex_indices", "vertex_index"}) {
    const std::size_t list = property_named(element, name);
    if (list != PlyColumns::kNone && element.properties[list].list_count_type) return list;
  }
  std::size_t found = PlyColumns::kNone;
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    if (!element.properties[i].list_count_type || !is_index_type(element.properties[i].type))
      continue;
    if (found != PlyColumns::kNone) return PlyColumns::kNone;
    found = i;
  }
  return found;
}

/// The ends of an edge: vertex1 and vertex2, otherwise its only two indices, whatever their names.
std::array<std::size_t, 2> edge_ends(const PlyElement& element) {
  const std::array named{property_named(element, "vertex1"), property_named(element, "vertex2")};
  if (named[0] != PlyColumns::kNone && named[1] != PlyColumns::kNone) return named;
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    const PlyProperty& property = element.properties[i];
    if (!property.list_count_type && is_index_type(property.type)) indices.push_back(i);
  }
  if (indices.size() != 2) return {PlyColumns::kNone, PlyColumns::kNone};
  return {indices[0], indices[1]};
}

PlyColumns ply_columns(const std::string& path, const PlyHeader& header) {
  PlyColumns columns;
  const auto refuse = [&](const PlyElement& element, const char* expected) {
    throw IoError(path, fmt::format("element {} has the properties {}; {} are expected",
                                    element.name, property_names(element), expected));
  };
  for (const PlyElement& element : header.elements) {
    if (element.count == 0) continue;
    if (element.name == "vertex") {
      columns.xyz = {property_named(element, "x"), property_named(element, "y"),
                     property_named(element, "z")};
      if (std::ranges::count(columns.xyz, PlyColumns::kNone) > 0) refuse(element, "x, y and z");
    } else if (element.name == "edge") {
      columns.ends = edge_ends(element);
      if (columns.ends[0] == PlyColumns::kNone) columns.edge_list = index_list(element);
      if (columns.ends[0] == PlyColumns::kNone && columns.edge_list == PlyColumns::kNone) {
        refuse(element, "vertex1 and vertex2, or only two integers,");
      }
    } else if (element.name == "face") {
      columns.face_list = index_list(element);
      if (columns.face_list == PlyColumns::kNone) refuse(element, "a list vertex_indices");
    }
  }
  return columns;
}

/// Reads the numbers of the body one after another, whatever their encoding.
class Body {
 public:
  Body(const std::string& path, std::string_view bytes, PlyEncoding encoding)
      : path_(path), rest_(bytes), encoding_(encoding) {}

  double next(ScalarType type) {
    if (encoding_ == PlyEncoding::kAscii) return next_word();
    const std::string_view bytes = rest_.substr(0, size_of(type));
    if (bytes.size() < size_of(type)) fail_truncated();
    rest_.remove_prefix(bytes.size());
    return load_scalar(std::as_bytes(std::span(bytes)).data(), type,
                       encoding_ == PlyEncoding::kBigEndian);
  }

 private:
  [[noreturn]] void fail_truncated() const {
    throw IoError(path_, "ends before the elements declared in its header");
  }

  double next_word() {
    constexpr std::string_view kBlanks = " \t\r\n";
    rest_.remove_prefix(std::min(rest_.find_first_not_of(kBlanks), rest_.size()));
    if (rest_.empty()) fail_truncated();
    const std::string_view word = rest_.substr(0, rest_.find_first_of(kBlanks));
    rest_.remove_prefix(word.size());
    return to_doubles({word}, path_).front();
  }

  std::string path_;
  std::string_view rest_;
  PlyEncoding encoding_;
};

class PlyReader {
 public:
  PlyReader(const std::string& path, std::string_view content)
      : path_(path),
        set_(lines_for_file(path, "PLY", content.size())),
        header_(header_of(path, content)),
        columns_(ply_columns(path, header_)),
        body_(path, content.substr(header_.data_offset), header_.encoding) {}

  LineSet read() {
    for (const PlyElement& element : header_.elements) {
      for (std::uint64_t i = 0; i < element.count; ++i) read_item(element);
    }
    check_indices(edges_);
    check_indices(faces_);
    for (std::size_t i = 0; i < edges_.size(); ++i) append_edge(edges_[i], i);
    if (edges_.empty() && !faces_.empty()) append_mesh({vertices_, faces_, {}}, set_);
    if (!edges_.empty()) set_.left_out.add(kinds::kFace, faces_.size());
    if (edges_.empty() && faces_.empty()) set_.left_out.add(kinds::kVertex, vertices_.size());
    return std::move(set_);
  }

 private:
  void append_edge(const IndexList& edge, std::size_t number) {
    Vertices vertices;
    for (const std::size_t index : edge) vertices.push_back(vertices_[index]);
    append_feature({}, {vertices}, static_cast<std::int64_t>(number), set_);
  }

  void read_item(const PlyElement& element) {
    std::vector<double>& values = values_;
    std::vector<IndexList>& lists = lists_;
    values.assign(element.properties.size(), 0.0);
    lists.resize(element.properties.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      if (property.list_count_type) {
        lists[i] = read_list(property);
      } else {
        values[i] = body_.next(property.type);
      }
    }
    if (element.name == "vertex") {
      vertices_.emplace_back(values[columns_.xyz[0]], values[columns_.xyz[1]],
                             values[columns_.xyz[2]]);
    } else if (element.name == "face") {
      faces_.push_back(std::move(lists[columns_.face_list]));
    } else if (element.name == "edge") {
      edges_.push_back(
          columns_.edge_list == PlyColumns::kNone
              ? IndexList{index_of(values[columns_.ends[0]]), index_of(values[columns_.ends[1]])}
              : std::move(lists[columns_.edge_list]));
      require_room(set_, edges_.size());
    }
  }

  IndexList read_list(const PlyProperty& property) {
    IndexList list;
    const std::size_t count = index_of(body_.next(*property.list_count_type));
    for (std::size_t i = 0; i < count; ++i) list.push_back(index_of(body_.next(property.type)));
    return list;
  }

  /// A value that is not an index becomes one that no file has, which check_indices() reports.
  static std::size_t index_of(double value) {
    const bool is_index = value >= 0.0 && value < 4294967296.0 && std::floor(value) == value;
    return is_index ? static_cast<std::size_t>(value) : static_cast<std::size_t>(-1);
  }

  void check_indices(const std::vector<IndexList>& lists) const {
    for (std::size_t i = 0; i < lists.size(); ++i) {
      for (const std::size_t index : lists[i]) {
        if (index < vertices_.size()) continue;
        throw IoError(path_,
                      fmt::format("edge or face {} refers to a vertex beyond the {} vertices", i,
                                  vertices_.size()));
      }
    }
  }

  std::string path_;
  LineSet set_;
  PlyHeader header_;
  PlyColumns columns_;
  Body body_;
  std::vector<double> values_;    ///< scalars of the current item
  std::vector<IndexList> lists_;  ///< lists of the current item
  Vertices vertices_;
  std::vector<IndexList> edges_;
  std::vector<IndexList> faces_;
};

}  // namespace

LineSet read_ply(const std::string& path, std::string_view content) {
  return PlyReader(path, content).read();
}

}  // namespace ridgeline::io
