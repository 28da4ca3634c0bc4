// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/command.h"
#include "apps/common/say.h"
#include "apps/patch/patch_template.h"
#include "apps/pipeline/open_patch.h"
#include "evaluate/files/output_folder.h"
#include "io/error.h"
#include "io/files/atomic_file.h"
#include "io/text/text.h"
#include "reconstruct/geometry/check.h"

#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <memory>
#include <string>

namespace ridgeline::apps {
namespace fs = std::filesystem;
namespace {

struct PatchArguments {
  std::string file, area;
  PatchTemplate patch;
};

/// Sets the area: bounds if `text` consists of four numbers, else a file.
void set_area(const std::string& text, PatchTemplate& patch) {
  std::vector<double> bounds;
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const auto number = io::to_double(text.substr(begin, end - begin));
    if (!number) break;
    bounds.push_back(*number);
    begin = end + 1;
  }
  if (bounds.size() == 4 && begin == text.size() + 1) {
    patch.area_m = bounds;
  } else {
    patch.area_file = text;
  }
}

void check_new(const std::string& file) {
  if (fs::exists(fs::symlink_status(file))) {
    throw io::IoError(file, "already exists; --init only creates new files");
  }
}

/// Writes the file and removes it again if it is not usable.
void write_and_check(const std::string& file, const std::string& text) {
  io::write_file(file, text);
  try {
    for (const std::string& note : notes_on(open_patch(file))) say("{}\n", note);
  } catch (const std::exception&) {
    fs::remove(file);
    throw;
  }
}

int run_patch_command(PatchArguments a) {
  check_new(a.file);
  if (!a.area.empty()) set_area(a.area, a.patch);
  if (a.patch.id.empty()) a.patch.id = fs::path(a.file).stem().string();
  check(!a.patch.height_range_m.empty() || !a.patch.lidar.empty() || !a.patch.surface_model.empty(),
        "the heights to search are unknown; give --lidar, --surface-model or --height-range");
  const fs::path folder = fs::path(a.file).parent_path();
  write_and_check(a.file, patch_text(a.patch, folder.empty() ? "." : folder.string()));
  say("{} written. Next: ridgeline run {} --out results\n", a.file, a.file);
  return kDone;
}

}  // namespace

Run add_patch(CLI::App& subcommand) {
  auto a = std::make_shared<PatchArguments>();
  subcommand.add_option("--init", a->file, "patch file to create; must not exist yet")->required();
  subcommand
      .add_option("--orientation", a->patch.orientation, "file or folder with cameras and poses")
      ->required();
  subcommand.add_option("--cameras", a->patch.cameras,
                        "camera file, if the orientation has no cameras");
  subcommand.add_option("--images", a->patch.images, "folder or pattern of the images")->required();
  subcommand
      .add_option("--area", a->area,
                  "area to reconstruct: x_min,y_min,x_max,y_max, m, or a polygon file")
      ->required();
  subcommand.add_option("--max-views", a->patch.max_views, "maximum number of images")
      ->check(CLI::Range(2, 100))
      ->default_val(io::kDefaultMaxViews);
  subcommand.add_option("--lidar", a->patch.lidar, "LIDAR files or patterns");
  subcommand.add_option("--surface-model", a->patch.surface_model,
                        "height raster that defines the heights to search");
  subcommand
      .add_option("--height-range", a->patch.height_range_m,
                  "lowest,highest height of objects, m; default: from the surface model or LIDAR")
      ->delimiter(',')
      ->expected(2);
  subcommand.add_option("--crs", a->patch.crs,
                        "reference system; default: that of the orientation");
  subcommand.add_option("--angles", a->patch.angles, "angle unit: deg, gon or rad")
      ->check(CLI::IsMember({"deg", "gon", "rad"}));
  subcommand.add_option("--rotation", a->patch.rotation, "rotation order: opk or pok")
      ->check(CLI::IsMember({"opk", "pok"}));
  subcommand
      .add_option("--matrix", a->patch.matrix,
                  "direction of PAT-B matrices: world_from_camera or camera_from_world")
      ->check(CLI::IsMember({"world_from_camera", "camera_from_world"}));
  subcommand.add_option("--id", a->patch.id, "id of the patch; default: name of the file");
  return [a] { return run_patch_command(*a); };
}

}  // namespace ridgeline::apps
