// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/read_lines.h"

#include "io/error.h"
#include "io/files/input_file.h"
#include "io/kinds/recognise.h"
#include "io/lines/line_checks.h"
#include "io/lines/model_edges.h"
#include "io/lines/named_by_columns.h"
#include "io/lines/readers.h"
#include "io/models/read_model.h"
#include "io/text/text.h"
#include "io/text/utf8.h"
#include "io/text/wkt.h"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

namespace ridgeline::io {
namespace {

constexpr const char* kKnownExtensions =
    ".geojson .json .gpkg .shp .dxf .csv .wkt .txt .obj .ply, CityJSON, CityGML, a folder of LIMAP "
    "tracks";

std::string extension_of(const std::string& path) {
  return lower_case(std::filesystem::path(path).extension().string());
}

void require_known_name(const std::string& path, const std::string& extension) {
  if (extension == ".bin") {
    throw IoError(path, "Line3D++ .bin is a machine-dependent memory dump; give the .txt");
  }
  if (extension == ".npy") {
    throw IoError(path,
                  "LIMAP .npy is a Python pickle, which may execute code; give alltracks.txt");
  }
  if (extension == ".stl") {
    throw IoError(path, "Line3D++ .stl has triangles without area; give the .txt or .obj");
  }
}

bool is_comment(std::string_view row) { return row.starts_with('#') || row.starts_with("//"); }

/// The text formats share extensions, so the first rows distinguish them.
LineSet read_text(const std::string& path, const std::string& content) {
  const std::vector<TextRow> rows = rows_of(std::string_view(content).substr(0, 65536));
  if (rows.empty()) throw IoError(path, "is empty, which may mean no lines or a failure");
  if (begins_as_wkt(rows[0].text)) return read_wkt(path, content);
  const std::vector<std::string_view> first = words_of(rows[0].text);
  const std::vector<std::string_view> second =
      rows.size() > 1 ? words_of(rows[1].text) : std::vector<std::string_view>{};
  const bool comma_separated = rows[0].text.find_first_of(",;") != std::string_view::npos;
  if (comma_separated || is_comment(rows[0].text)) return read_csv(path, content);
  if (first.size() == 1 && to_integer(first[0])) return read_limap_tracks(path, content);
  if (first.size() == 6 && to_double(first[0])) {
    const bool is_track =
        rows.size() > 2 && second.size() == 2 && rows[2].text.starts_with("image_id_list");
    return is_track ? read_limap_track(path, content) : read_space_lines(path, content);
  }
  if (first.size() > 6 && to_integer(first[0])) return read_line3dpp(path, content);
  return read_csv(path, content);
}

/// Reads a text file of lines. Text that is not UTF-8 is read as Latin-1.
LineSet read_text_file(const std::string& path,
                       const std::string& extension,
                       const ReadLinesOptions& options) {
  std::string content = read_input(path, FileGroup::kLines);
  const bool is_text = extension != ".ply" && extension != ".obj";
  const bool is_recoded = is_text && !is_utf8(content);
  if (is_recoded) content = as_utf8(content);
  LineSet set = extension == ".obj"   ? read_obj(path, content, options.vertex_pairs)
                : extension == ".ply" ? read_ply(path, content)
                : extension == ".geojson" || extension == ".json" ? read_geojson(path, content)
                                                                  : read_text(path, content);
  if (is_recoded) set.warnings.emplace_back("is not UTF-8; reading it as Latin-1");
  return set;
}

[[noreturn]] void refuse_by_extension(const std::string& path, const std::string& extension) {
  require_regular_file(path);
  const FileKind kind = kind_of_path(path);
  if (!kind.by_name) require_kind(path, FileGroup::kLines);
  const std::string named = kind.what.empty() ? "" : ": " + kind.what;
  throw IoError(
      path, fmt::format("extension '{}'{}; supported are {}", extension, named, kKnownExtensions));
}

LineSet read_any(const std::string& path, const ReadLinesOptions& options) {
  if (std::filesystem::is_directory(path)) return read_limap_folder(path);
  if (is_model(path)) return lines_of_model(read_model(path, {options.lod}));
  const std::string extension = extension_of(path);
  require_known_name(path, extension);
  if (extension == ".gpkg" || extension == ".shp" || extension == ".dxf") {
    return read_ogr(path, extension, options.lod);
  }
  for (const char* const known : {".geojson", ".json", ".obj", ".ply", ".csv", ".txt", ".wkt"}) {
    if (extension == known) return read_text_file(path, extension, options);
  }
  refuse_by_extension(path, extension);
}

/// Throws IoError for a reference system that PROJ cannot read, because the fault lies with the
/// file and not with the caller.
void check_stated_crs(const LineSet& set) {
  try {
    (void)describe(set.crs);
  } catch (const std::invalid_argument& error) {
    throw IoError(set.path, fmt::format("its reference system cannot be used: {}", error.what()));
  }
}

}  // namespace

LineSet read_lines(const std::string& path, const ReadLinesOptions& options) {
  LineSet set = read_any(path, options);
  set.path = path;
  if (options.assume_crs.known()) {
    set.crs = options.assume_crs;
  } else {
    check_stated_crs(set);
  }
  if (!set.crs.known()) set.unit_m = options.unit_m;
  set.plan_scale = options.plan_scale;
  name_by_columns(options.id_column, options.building_column, set);
  check_lines(set);
  return set;
}

}  // namespace ridgeline::io
