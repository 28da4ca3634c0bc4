// SPDX-License-Identifier: BSD-3-Clause
#include "apps/patch/patch_template.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace ridgeline::apps {
namespace fs = std::filesystem;
namespace {

/// A text in quotes that YAML reads correctly regardless of its content: a JSON string is also
/// valid YAML.
std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }

/// Writes the sections of the file in sequence.
class Writer {
 public:
  explicit Writer(std::string folder) : folder_(std::move(folder)) {}

  void comment(const std::string& text) { text_ += "# " + text + "\n"; }
  void value(const char* key, const std::string& value) {
    text_ += fmt::format("{}: {}\n", key, value);
  }
  void text(const char* key, const std::string& text) {
    if (!text.empty()) value(key, quoted(text));
  }
  void path(const char* key, const std::string& path) {
    if (!path.empty()) value(key, quoted(from_folder(path)));
  }
  void paths(const char* key, const std::vector<std::string>& paths) {
    if (paths.empty()) return;
    text_ += fmt::format("{}:\n", key);
    for (const std::string& path : paths)
      text_ += fmt::format("  - {}\n", quoted(from_folder(path)));
  }
  void numbers(const char* key, const std::vector<double>& numbers) {
    value(key, fmt::format("[{}]", fmt::join(numbers, ", ")));
  }
  void gap() { text_ += "\n"; }

  [[nodiscard]] const std::string& whole() const { return text_; }

 private:
  /// A path that the user gave as absolute stays absolute.
  [[nodiscard]] std::string from_folder(const std::string& path) const {
    if (fs::path(path).is_absolute()) return path;
    const fs::path relative =
        fs::weakly_canonical(path).lexically_relative(fs::weakly_canonical(folder_));
    return relative.empty() ? fs::absolute(path).string() : relative.string();
  }

  std::string folder_;
  std::string text_;
};

void write_images(const PatchTemplate& patch, Writer& out) {
  out.comment(
      "Cameras and poses of the images, and conventions that their file does not define. Also read "
      "by `ridgeline info`.");
  out.path("orientation", patch.orientation);
  out.path("cameras", patch.cameras);
  out.text("angles", patch.angles);
  out.text("rotation", patch.rotation);
  out.text("matrix", patch.matrix);
  out.gap();
  out.comment("Folder or pattern of the images, which are matched to the orientation by name.");
  out.path("images", patch.images);
  out.gap();
  out.comment(
      "Area to reconstruct: [x_min, y_min, x_max, y_max], m, or a polygon file. Only the image "
      "windows");
  out.comment("that show it are read.");
  patch.area_file.empty() ? out.numbers("area", patch.area_m) : out.path("area", patch.area_file);
  out.comment("Maximum number of images; those that show the area best are used.");
  out.value("max_views", fmt::format("{}", patch.max_views));
}

void write_heights(const PatchTemplate& patch, Writer& out) {
  out.comment(
      "Lowest and highest height of objects, m. auto: from lidar or surface_model with a margin of "
      "10 m.");
  if (patch.height_range_m.empty()) {
    out.value("height_range", "auto");
  } else {
    out.numbers("height_range", patch.height_range_m);
  }
  out.path("surface_model", patch.surface_model);
}

}  // namespace

std::string patch_text(const PatchTemplate& patch, const std::string& folder) {
  Writer out(folder);
  out.comment(
      "A patch: the inputs of one reconstruction. Run it with `ridgeline run FILE --out results`.");
  out.comment("Paths are relative to this file.");
  out.gap();
  out.comment("Name of the patch and of its folder in the results.");
  out.value("id", quoted(patch.id));
  out.comment("Reference system; default: that of the orientation.");
  patch.crs.empty() ? out.comment("crs: EPSG:25832") : out.text("crs", patch.crs);
  out.gap();
  write_images(patch, out);
  out.gap();
  write_heights(patch, out);
  out.gap();
  out.comment(
      "LIDAR to judge the lines against: files or patterns. Without it, lines are only "
      "reconstructed.");
  patch.lidar.empty() ? out.comment("lidar: [tiles/*.laz]") : out.paths("lidar", patch.lidar);
  return out.whole();
}

}  // namespace ridgeline::apps
