// SPDX-License-Identifier: BSD-3-Clause
#include "io/project/lines_block_file.h"

#include "io/files/yaml_check.h"
#include "io/project/stated_crs.h"
#include "io/text/text.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>

namespace ridgeline::io {
namespace {

class LinesBlockReader {
 public:
  explicit LinesBlockReader(const std::string& path)
      : path_(path),
        folder_(std::filesystem::path(path).parent_path()),
        map_(path,
             load_yaml(path, FileGroup::kBlock),
             {"block", "lines", "lidar", "crs", "reference_lines", "patch_size_m", "classes",
              "exclude_withheld", "last_returns", "scale_to_ground", "bounds", "origin"}) {}

  [[nodiscard]] LinesBlockFile read() const {
    LinesBlockFile block;
    block.path = path_;
    if (map_.has("block")) block.block = map_.text("block");
    block.lines = paths("lines");
    block.lidar = paths("lidar");
    block.crs = stated_crs(map_);
    if (map_.has("reference_lines")) block.reference_lines = resolved(map_.text("reference_lines"));
    if (map_.has("patch_size_m")) block.patch_size_m = patch_size_m();
    if (map_.has("classes")) block.classes = classes();
    block.exclude_withheld = flag("exclude_withheld", block.exclude_withheld);
    block.last_returns = flag("last_returns", block.last_returns);
    block.scale_to_ground = flag("scale_to_ground", block.scale_to_ground);
    if (map_.has("bounds")) block.bounds = bounds();
    if (map_.has("origin")) block.origin = origin();
    return block;
  }

 private:
  [[nodiscard]] std::string resolved(const std::string& file) const {
    return (folder_ / file).lexically_normal().string();
  }

  [[nodiscard]] std::vector<std::string> paths(const char* key) const {
    std::vector<std::string> files = map_.texts(key);
    if (files.empty()) map_.fail(key, fmt::format("{} is empty; at least one file is needed", key));
    return transformed(files, [&](const std::string& file) { return resolved(file); });
  }

  [[nodiscard]] double patch_size_m() const {
    constexpr double kMinSize_m = 1.0, kMaxSize_m = 1e6;
    const double size_m = map_.number("patch_size_m");
    if (size_m < kMinSize_m || size_m > kMaxSize_m) {
      map_.fail("patch_size_m", fmt::format("patch_size_m = {}; must be in [{:g}, {:g}]", size_m,
                                            kMinSize_m, kMaxSize_m));
    }
    return size_m;
  }

  [[nodiscard]] std::set<std::uint8_t> classes() const {
    std::set<std::uint8_t> classes;
    for (const std::string& text : map_.texts("classes")) {
      const std::optional<double> code = to_double(text);
      if (!code || *code != std::floor(*code) || *code < 0.0 || *code > 255.0) {
        map_.fail("classes", fmt::format("classes: {}; must be whole numbers, 0 to 255", text));
      }
      classes.insert(static_cast<std::uint8_t>(*code));
    }
    if (classes.empty()) map_.fail("classes", "classes is empty; no point would be kept");
    return classes;
  }

  [[nodiscard]] bool flag(const char* key, bool otherwise) const {
    if (!map_.has(key)) return otherwise;
    const std::string text = map_.text(key);
    if (text != "true" && text != "false") {
      map_.fail(key, fmt::format("{} = {}; must be true or false", key, text));
    }
    return text == "true";
  }

  [[nodiscard]] std::vector<double> bounds() const {
    std::vector<double> bounds = map_.numbers("bounds", 4);
    if (bounds[0] > bounds[2] || bounds[1] > bounds[3]) {
      map_.fail("bounds", "bounds must be [x_min, y_min, x_max, y_max] with min <= max");
    }
    return bounds;
  }

  [[nodiscard]] std::vector<double> origin() const {
    std::vector<double> origin = map_.numbers("origin", 3);
    for (const double x : origin) {
      if (x != std::round(x))
        map_.fail("origin", fmt::format("origin: {}; must be whole metres", x));
    }
    return origin;
  }

  std::string path_;
  std::filesystem::path folder_;
  YamlMap map_;
};

}  // namespace

LinesBlockFile read_lines_block(const std::string& path) { return LinesBlockReader(path).read(); }

bool is_lines_block(const std::string& path) {
  const YAML::Node root = load_yaml(path, FileGroup::kBlock);
  return root.IsMap() && root["lines"].IsDefined();
}

}  // namespace ridgeline::io
