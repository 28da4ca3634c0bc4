// SPDX-License-Identifier: BSD-3-Clause
#include "io/error.h"
#include "io/lines/mesh_edges.h"
#include "io/lines/readers.h"
#include "io/text/text.h"
#include "reconstruct/geometry/median.h"

#include <fmt/format.h>

#include <algorithm>

namespace ridgeline::io {
namespace {

/// An `l` or `f` record; indices from 1 as in the file, negative ones already resolved.
struct Record {
  int row = 0;
  std::vector<long> indices;
};

struct ObjFile {
  Vertices vertices;
  std::vector<Record> lines;
  std::vector<Record> faces;
  MeshNames names;  ///< of the faces
};

/// A row together with the rows that continue it. A row that ends in a backslash continues on the
/// next one.
struct LogicalRow {
  int number = 0;
  std::string text;
};

std::vector<LogicalRow> logical_rows(std::string_view content) {
  std::vector<LogicalRow> logical;
  bool continued = false;
  for (const TextRow& row : rows_of(content)) {
    std::string_view text = row.text.substr(0, row.text.find('#'));
    if (!continued) logical.push_back({row.number, {}});
    text = trimmed(text);
    continued = text.ends_with('\\');
    if (continued) text.remove_suffix(1);
    logical.back().text += std::string(text) + " ";
  }
  return logical;
}

Eigen::Vector3d parse_vertex(const std::vector<std::string_view>& words, const std::string& where) {
  if (words.size() < 4) throw IoError(where, "a vertex must have three coordinates: v x y z");
  const std::vector<double> x = to_doubles({words[1], words[2], words[3]}, where);
  return {x[0], x[1], x[2]};
}

/// Reads the words `v`, `v/vt`, `v//vn` or `v/vt/vn` of a record. A negative index counts back from
/// the last vertex so far.
Record parse_indices(const std::vector<std::string_view>& words,
                     int row,
                     std::size_t n_vertices,
                     const std::string& where) {
  Record record{row, {}};
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::optional<long> index = to_integer(words[i].substr(0, words[i].find('/')));
    if (!index || *index == 0) {
      throw IoError(where, "vertex index '" + std::string(words[i]) + "'; must count from 1 or -1");
    }
    record.indices.push_back(*index > 0 ? *index : static_cast<long>(n_vertices) + 1 + *index);
  }
  return record;
}

/// The text of a record after its first word.
std::string name_in(const std::vector<std::string_view>& words) {
  return fmt::format("{}", fmt::join(words.begin() + 1, words.end(), " "));
}

/// Notes a record that names the faces after it; an object begins without a group.
void take_name(const std::vector<std::string_view>& words, MeshNames& names) {
  FaceNames stated = names.all.back();
  if (words[0] == "o") stated.group.clear();
  (words[0] == "o"   ? stated.object
   : words[0] == "g" ? stated.group
                     : stated.material) = name_in(words);
  names.all.push_back(std::move(stated));
}

/// Reads the records. `set` is where the lines will go; it must have room for them.
ObjFile parse_obj(const std::string& path, std::string_view content, const LineSet& set) {
  constexpr std::size_t kMaxRow_bytes = 4U << 20U;  // polylines of half a million vertices
  ObjFile obj;
  obj.names.all.emplace_back();
  for (const LogicalRow& row : logical_rows(content)) {
    const std::string where = place(path, row.number);
    if (row.text.size() > kMaxRow_bytes) {
      throw IoError(
          where, fmt::format("a row of {} bytes; the limit is {}", row.text.size(), kMaxRow_bytes));
    }
    const std::vector<std::string_view> words = words_of(row.text);
    if (words.empty()) continue;
    if (words[0] == "v") {
      obj.vertices.push_back(parse_vertex(words, where));
    } else if (words[0] == "o" || words[0] == "g" || words[0] == "usemtl") {
      take_name(words, obj.names);
    } else if (words[0] == "l" || words[0] == "f") {
      if (words[0] == "f") obj.names.of_face.push_back(obj.names.all.size() - 1);
      (words[0] == "l" ? obj.lines : obj.faces)
          .push_back(parse_indices(words, row.number, obj.vertices.size(), where));
      require_room(set, obj.lines.size());
    }
  }
  return obj;
}

/// The records as lists of indices from 0. Throws IoError for an index without a vertex.
std::vector<IndexList> resolved(const std::vector<Record>& records,
                                std::size_t n_vertices,
                                const std::string& path) {
  std::vector<IndexList> lists;
  for (const Record& record : records) {
    IndexList& list = lists.emplace_back();
    for (const long index : record.indices) {
      if (index < 1 || index > static_cast<long>(n_vertices)) {
        throw IoError(
            place(path, record.row),
            fmt::format("vertex index {}, but the file has {} vertices", index, n_vertices));
      }
      list.push_back(static_cast<std::size_t>(index - 1));
    }
  }
  return lists;
}

/// Whether the file is from ELSR, which writes each segment as two vertices of its own, then
/// records "l k k+1", "l k+2 k+3", ... that do not begin at 1.
bool has_shifted_pairs(const ObjFile& obj) {
  if (!obj.faces.empty() || obj.lines.empty() || obj.vertices.size() % 2 != 0) return false;
  const auto is_pair = [](const Record& record) {
    return record.indices.size() == 2 && record.indices[1] == record.indices[0] + 1;
  };
  if (!std::all_of(obj.lines.begin(), obj.lines.end(), is_pair)) return false;
  for (std::size_t i = 1; i < obj.lines.size(); ++i) {
    if (obj.lines[i].indices[0] != obj.lines[i - 1].indices[0] + 2) return false;
  }
  return obj.lines.front().indices[0] != 1;
}

/// Whether the `l` records repeat the faces. Each record of TopoLAP lists the vertices of a face,
/// without the closing edge.
bool lines_repeat_faces(const ObjFile& obj) {
  return obj.lines.size() == obj.faces.size() &&
         std::equal(obj.lines.begin(), obj.lines.end(), obj.faces.begin(),
                    [](const Record& line, const Record& face) {
                      return line.indices == face.indices && line.indices.size() > 2;
                    });
}

void append_vertex_pairs(const std::string& path, const Vertices& vertices, LineSet& set) {
  if (vertices.size() % 2 != 0) {
    throw IoError(path, fmt::format("{} vertices; pairs need an even number", vertices.size()));
  }
  for (std::size_t i = 0; i + 1 < vertices.size(); i += 2) {
    append_segment({}, {vertices[i], vertices[i + 1]}, i / 2, set);
  }
}

double median_length(const std::vector<Line>& lines) {
  std::vector<double> lengths;
  for (const Line& line : lines) {
    if (all_finite(line.segment_in_world)) lengths.push_back(length(line.segment_in_world));
  }
  return lengths.empty() ? 0.0 : upper_median(std::move(lengths));
}

/// Drops segments that are not finite or far too long: ELSR leaves failed triangulations in the
/// file.
void drop_failed_segments(LineSet& set) {
  constexpr double kHugeRatio = 1000.0;  // far above any roof edge, in whatever unit
  const double limit = kHugeRatio * median_length(set.lines);
  const std::size_t n_dropped = std::erase_if(set.lines, [&](const Line& line) {
    return !all_finite(line.segment_in_world) || length(line.segment_in_world) > limit;
  });
  if (n_dropped > 0) {
    set.warnings.push_back(
        fmt::format("{} segments dropped: not finite, or longer than {:.0f} times the median",
                    n_dropped, kHugeRatio));
  }
}

void append_polylines(const Vertices& vertices,
                      const std::vector<IndexList>& polylines,
                      LineSet& set) {
  std::int64_t number = 0;
  for (const IndexList& polyline : polylines) {
    Vertices points;
    for (const std::size_t index : polyline) points.push_back(vertices[index]);
    append_feature({}, {points}, number++, set);
  }
}

}  // namespace

LineSet read_obj(const std::string& path, std::string_view content, bool vertex_pairs) {
  LineSet set = lines_for_file(path, "OBJ", content.size());
  const ObjFile obj = parse_obj(path, content, set);
  if (vertex_pairs) {
    append_vertex_pairs(path, obj.vertices, set);
  } else if (has_shifted_pairs(obj)) {
    set.format = "ELSR OBJ";
    set.warnings.emplace_back("l records start at a wrong index: pairing consecutive vertices");
    append_vertex_pairs(path, obj.vertices, set);
    drop_failed_segments(set);
  } else if (!obj.lines.empty() && !lines_repeat_faces(obj)) {
    append_polylines(obj.vertices, resolved(obj.lines, obj.vertices.size(), path), set);
    set.left_out.add(kinds::kFace, obj.faces.size());
  } else if (!obj.faces.empty()) {
    append_mesh({obj.vertices, resolved(obj.faces, obj.vertices.size(), path), obj.names}, set);
  } else if (!obj.vertices.empty()) {
    throw IoError(path,
                  "has vertices but no l and no f records; `pairs` takes vertices two by two");
  }
  return set;
}

}  // namespace ridgeline::io
