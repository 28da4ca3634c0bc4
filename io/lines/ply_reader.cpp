// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/ply_header.h"
#include "io/error.h"
#include "io/lines/mesh_edges.h"
#include "io/lines/readers.h"
#include "io/lines/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>

namespace ridgeline::io {
namespace {

PlyHeader header_of(const std::string& path, std::string_view content) {
  PlyHeader header = read_ply_header(std::as_bytes(std::span(content)), path);
  for (const PlyElement& element : header.elements) {
    // its rows, of no bytes, would never end
    if (element.properties.empty()) throw IoError(path, element.name + " has no properties");
  }
  return header;
}

/// The numbers of the body one after another, whatever their encoding.
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
        body_(path, content.substr(header_.data_offset), header_.encoding) {}

  LineSet read() {
    for (const PlyElement& element : header_.elements) {
      for (std::uint64_t i = 0; i < element.count; ++i) read_item(element);
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
  void read_item(const PlyElement& element) {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    IndexList edge(2);
    IndexList polygon;
    for (const PlyProperty& property : element.properties) {
      const std::string_view name = property.name;
      if (property.list_count_type) {
        IndexList list = read_list(property);
        if (name == "vertex_indices" || name == "vertex_index") polygon = std::move(list);
        continue;
      }
      const double value = body_.next(property.type);
      if (name == "x") position.x() = value;
      if (name == "y") position.y() = value;
      if (name == "z") position.z() = value;
      if (name == "vertex1") edge[0] = index_of(value);
      if (name == "vertex2") edge[1] = index_of(value);
    }
    if (element.name == "vertex") vertices_.push_back(position);
    if (element.name == "edge") edges_.push_back(edge);
    refuse_more_lines(set_, edges_.size());
    if (element.name == "face") faces_.push_back(std::move(polygon));
  }

  IndexList read_list(const PlyProperty& property) {
    IndexList list;
    const std::size_t count = index_of(body_.next(*property.list_count_type));
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
  PlyHeader header_;
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
