// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/command.h"
#include "apps/common/say.h"
#include "apps/info/orientation_facts.h"
#include "apps/info/own_files.h"
#include "apps/pipeline/open_patch.h"
#include "evaluate/files/judged_lines.h"
#include "io/cloud/cloud_facts.h"
#include "io/cloud/read_cloud.h"
#include "io/crs/grid_scale.h"
#include "io/error.h"
#include "io/files/input_file.h"
#include "io/images/image.h"
#include "io/kinds/folder_kind.h"
#include "io/kinds/recognise.h"
#include "io/lines/line_facts.h"
#include "io/lines/read_lines.h"
#include "io/project/patch.h"
#include "io/text/text.h"
#include "reconstruct/extract/beyond/soft_edges/edge_facts.h"
#include "reconstruct/geometry/transformed.h"
#include "reconstruct/reconstruct.h"
#include "reconstruct/scene/normalised_image.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>

namespace ridgeline::apps {
namespace {

constexpr const char* kKnownKinds =
    "supported are point clouds (LAS, LAZ, COPC, PCD, PLY, text), lines (GeoJSON, GeoPackage, "
    "Shapefile, DXF, CSV, WKT, OBJ, PLY), building models (CityJSON, CityGML), images (TIFF, PNG, "
    "JPEG, JPEG 2000), orientations (omega-phi-kappa, OpenSfM, Pix4D, Inpho, PAT-B, "
    "BlocksExchange, Metashape, COLMAP), patch, gates and config files, tables of matches and "
    "segments, patch folders and results folders";

/// The unit of the file, with its name in the reference system if both units are the same.
std::string unit_text(double unit_m, double crs_unit_m, const std::string& crs_unit_name) {
  if (io::same_unit(unit_m, crs_unit_m))
    return fmt::format("{} ({:.12g} m)", crs_unit_name, unit_m);
  return io::unit_text(unit_m);
}

/// `unit_m`: the unit of each axis. The unit keys of a file may differ from its reference system.
void print_crs(const io::CrsFacts& crs, const Eigen::Vector3d& unit_m, bool states_unit) {
  fmt::print("  crs         {}\n", crs.name);
  if (!states_unit) {
    fmt::print("  units       unknown, assuming metres\n");
    return;
  }
  fmt::print("  units       {} in plan, {} in height\n",
             unit_text(unit_m.x(), crs.horizontal_unit_m, crs.horizontal_unit_name),
             unit_text(unit_m.z(), crs.vertical_unit_m, crs.vertical_unit_name));
}

void print_crs(const io::Crs& crs) {
  const io::CrsFacts facts = io::describe(crs);
  print_crs(facts, {facts.horizontal_unit_m, facts.horizontal_unit_m, facts.vertical_unit_m},
            crs.known());
}

/// Prints the map scale of a projected reference system at the centre of the data.
void print_scale(const std::optional<io::GridScale>& scale) {
  if (!scale) return;
  fmt::print("  scale       map scale {}\n", io::scale_text(*scale));
  if (!scale->in_area_of_use) {
    fmt::print("  warning     outside the reference system's area of use\n");
  } else if (!scale->is_true()) {
    fmt::print(
        "  warning     the plan is not true to scale; evaluate requires --scale-to-ground\n");
  }
}

void print_bounds(const Eigen::AlignedBox3d& box) {
  if (box.isEmpty()) {
    fmt::print("  bounds      none\n");
    return;
  }
  fmt::print("  bounds      x {:.3f} .. {:.3f}, y {:.3f} .. {:.3f}, z {:.3f} .. {:.3f}\n",
             box.min().x(), box.max().x(), box.min().y(), box.max().y(), box.min().z(),
             box.max().z());
}

void print_warnings(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) answer(fmt::format("  warning     {}\n", warning));
}

void print_counts(const char* label, const std::map<std::uint8_t, std::uint64_t>& counts) {
  if (counts.empty()) return;
  fmt::print("  {:<11}", label);
  for (const auto& [value, n] : counts) fmt::print(" {}: {}", value, n);
  fmt::print("\n");
}

void print_cloud(const std::string& path, double max_resolution_m) {
  const io::CloudFacts facts = io::cloud_facts(path, {.max_resolution_m = max_resolution_m});
  fmt::print("{}: {}\n  points      {}\n", path, facts.format, facts.n_points);
  if (facts.n_non_finite > 0) fmt::print("  not finite  {}\n", facts.n_non_finite);
  print_bounds(facts.bounds);
  if (facts.density_per_m2) {
    fmt::print("  density     {:.2f} points/m2 where not empty\n", *facts.density_per_m2);
  }
  print_counts("classes", facts.n_by_class);
  print_counts("returns", facts.n_by_return);
  if (facts.n_withheld > 0) fmt::print("  withheld    {}\n", facts.n_withheld);
  print_crs(facts.crs, facts.unit_m, facts.states_unit);
  print_scale(facts.plan_scale);
  if (facts.scale && facts.offset) {
    fmt::print("  stored as   scale {:g} {:g} {:g}, offset {:.3f} {:.3f} {:.3f}\n",
               facts.scale->x(), facts.scale->y(), facts.scale->z(), facts.offset->x(),
               facts.offset->y(), facts.offset->z());
  }
  print_warnings(facts.warnings);
}

/// Buildings and roof faces by LoD, and the kinds of the edges.
void print_buildings(const io::LineSet& set) {
  std::map<std::string, std::size_t> lods, kinds;
  for (const io::Building& building : set.model->buildings)
    ++lods[building.lod.empty() ? "of unknown LoD" : "of LoD " + building.lod];
  for (const io::Line& line : set.lines) ++kinds[line.kind];
  const auto listed = [](const std::map<std::string, std::size_t>& counts) {
    return transformed(
        counts, [](const auto& entry) { return fmt::format("{} {}", entry.second, entry.first); });
  };
  const auto n_roofs = std::ranges::count(set.model->faces, FaceKind::kRoof, &Face::kind);
  fmt::print("  buildings   {}; {} roof faces\n  kinds       {}\n", fmt::join(listed(lods), ", "),
             n_roofs, fmt::join(listed(kinds), ", "));
}

void print_lines(const std::string& path) {
  const io::LineSet set = io::read_lines(path);
  const io::LineFacts facts = io::line_facts(set);
  const std::string unit = io::describe(set.crs).horizontal_unit_name;
  fmt::print("{}: {}\n  lines       {}, total length {:.1f} {}\n", path, set.format, facts.n_lines,
             facts.total_length, unit == "metre" ? "m" : unit);
  if (facts.n_polylines > 0) fmt::print("  polylines   {}\n", facts.n_polylines);
  if (facts.n_non_finite > 0) fmt::print("  not finite  {}\n", facts.n_non_finite);
  print_bounds(facts.bounds);
  const Eigen::Vector3d steps_m = io::steps_of(set, results::unit_m_of(set)).steps_m();
  if (!steps_m.isZero()) fmt::print("  digits      {}\n", io::steps_text(steps_m));
  fmt::print("  attributes  {}\n", fmt::join(facts.attributes, " "));
  print_crs(set.crs);
  if (!facts.bounds.isEmpty()) {
    print_scale(io::grid_scale(set.crs, facts.bounds.center().head<2>()));
  }
  if (!set.stated_unit.empty()) fmt::print("  $INSUNITS   {}\n", set.stated_unit);
  if (set.model) print_buildings(set);
  print_warnings(set.warnings);
}

/// The facts of an image, "970 x 977 px, 3 bands of 8 bit, GTiff", or "missing".
std::string image_text(const std::string& path) {
  if (!std::filesystem::exists(path)) return "missing";
  const io::ImageFacts facts = io::image_facts(path);
  return fmt::format("{} x {} px, {} bands of {} bit, {}", facts.width_px, facts.height_px,
                     facts.n_bands, facts.bits, facts.format);
}

/// Prints the values that are mapped to 0 and 1, unless this would require decoding too much.
void print_radiometry(const std::string& path, const io::ImageFacts& facts) {
  constexpr int kSmall_px = 2;
  if (facts.width_px < kSmall_px || facts.height_px < kSmall_px) return;
  const io::Window last{facts.width_px - kSmall_px, facts.height_px - kSmall_px, kSmall_px,
                        kSmall_px};
  try {
    if (const auto slow = io::slow_reading(path, last)) return print_warnings({*slow});
    std::vector<std::string> ranges;
    for (const auto& [low, high] :
         reconstruct::band_ranges(io::read_picture(path, {.window = last}).sample))
      ranges.push_back(fmt::format("[{:g}, {:g}]", low, high));
    fmt::print("  radiometry  [{}]\n", fmt::join(ranges, ", "));
  } catch (const io::IoError& error) {
    print_warnings({error.what()});
  }
}

/// Prints the sharpness at the centre of an image.
void print_edges(const std::string& path, const io::ImageFacts& facts) {
  constexpr int kSide_px = 1024;
  constexpr int kMinSide_px = 64;
  if (std::min(facts.width_px, facts.height_px) < kMinSide_px) return;
  const cv::Size size(std::min(kSide_px, facts.width_px), std::min(kSide_px, facts.height_px));
  const io::Window middle{(facts.width_px - size.width) / 2, (facts.height_px - size.height) / 2,
                          size.width, size.height};
  try {
    if (io::slow_reading(path, middle)) return;
    reconstruct::View view;
    const io::Picture picture = io::read_picture(path, {.window = middle, .samples = false});
    view.image = reconstruct::normalised_image(picture.pixels);
    view.is_valid = picture.is_valid;
    view.corner_px = {middle.column, middle.row};
    view.segments = reconstruct::extract(view);
    const reconstruct::EdgeFacts edges = edge_facts(view);
    fmt::print("  edges       in the central {} x {} px{}\n", size.width, size.height,
               edges.noise ? fmt::format(", noise {:.2g} %", 100.0 * *edges.noise) : "");
    for (const reconstruct::EdgesOfScale& scale : edges.scales)
      fmt::print("              at {} size: {} segment{}, total length {:.0f} px{}\n",
                 scale.scale_px == 1 ? "full" : fmt::format("1/{}", scale.scale_px),
                 scale.n_segments, scale.n_segments == 1 ? "" : "s", scale.length_px,
                 scale.width_px ? fmt::format(", {:.1f} px wide (sigma)", *scale.width_px) : "");
  } catch (const io::IoError&) {  // already reported by print_radiometry()
  }
}

void print_image(const std::string& path) {
  const io::ImageFacts facts = io::image_facts(path);
  fmt::print("{}: {}\n  size        {} x {} px\n  bands       {} of {} bit\n", path, facts.format,
             facts.width_px, facts.height_px, facts.n_bands, facts.bits);
  if (facts.turn != io::ImageTurn::kNone)
    fmt::print("  rotation    EXIF orientation {}\n", static_cast<int>(facts.turn));
  print_radiometry(path, facts);
  print_edges(path, facts);
  print_use(
      fmt::format("name it under images in a patch file; ridgeline extract {} --out FILE", path));
}

std::vector<std::string> missing_files(const io::Patch& patch) {
  std::vector<std::string> warnings;
  const auto look_for = [&](const std::string& file) {
    if (!std::filesystem::exists(file)) warnings.push_back(file + " does not exist");
  };
  for (const io::PatchImage& image : patch.images) {
    look_for(image.path);
    if (image.segments) look_for(*image.segments);
  }
  for (const std::string& pattern : patch.lidar) {
    try {
      for (const std::string& file : io::expand_patterns({pattern})) look_for(file);
    } catch (const io::IoError& error) {
      warnings.emplace_back(error.what());
    }
  }
  if (patch.reference_matches) look_for(*patch.reference_matches);
  if (patch.reference_tracks) look_for(*patch.reference_tracks);
  if (patch.reference_lines) look_for(*patch.reference_lines);
  return warnings;
}

void print_image_of_patch(const io::PatchImage& image) {
  const Eigen::Vector3d centre = projection_centre(image.image_from_world).hnormalized();
  const std::string window =
      image.window ? fmt::format(", window {} x {} at {}, {}", image.window->width,
                                 image.window->height, image.window->column, image.window->row)
                   : "";
  fmt::print("  image       {}: {}, {}{}, projection centre {:.3f} {:.3f} {:.3f}\n", image.id,
             image.path, image_text(image.path), window, centre.x(), centre.y(), centre.z());
}

void print_patch(const std::string& path) {
  const io::Patch patch = read_patch(path);
  fmt::print("{}: patch {}\n  heights     {:g} .. {:g} m\n", path, patch.id,
             patch.height_range_m[0], patch.height_range_m[1]);
  for (const io::PatchImage& image : patch.images) print_image_of_patch(image);
  if (patch.area_file) fmt::print("  area        {}\n", *patch.area_file);
  if (!patch.orientation_files.empty())
    fmt::print("  orientation {}\n", fmt::join(patch.orientation_files, " "));
  fmt::print("  lidar       {}\n", fmt::join(patch.lidar, " "));
  print_crs(patch.crs);
  for (const std::string& decision : patch.decisions) fmt::print("  decided     {}\n", decision);
  print_warnings(patch.warnings);
  print_warnings(missing_files(patch));
  print_use(fmt::format("ridgeline run {} --out results", path));
}

/// A PLY contains a cloud, or lines if its header lists edges or faces.
bool is_line_ply(const std::string& path) {
  if (!std::filesystem::is_regular_file(path)) return false;  // the reader reports the error
  std::ifstream file(path, std::ios::binary);
  std::string line;
  while (std::getline(file, line) && !line.starts_with("end_header")) {
    if (line.starts_with("element edge") || line.starts_with("element face")) return true;
  }
  return false;
}

/// Text files contain a cloud or a tool's lines. Lines are tried first, because their formats are
/// stricter. A CSV that is neither was more likely meant to contain lines.
void print_text_file(const std::string& path, bool is_csv, double max_resolution_m) {
  try {
    print_lines(path);
  } catch (const io::IoError& fault_of_lines) {
    try {
      print_cloud(path, max_resolution_m);
    } catch (const io::IoError&) {
      if (is_csv) throw fault_of_lines;
      throw;
    }
  }
}

void print_patches(const std::string& folder, const io::FileKind& kind) {
  const std::vector<std::string> files = io::patch_files_in(folder);
  if (files.size() == 1) return print_patch(files.front());
  fmt::print("{}: {}\n", folder, kind.what.substr(2));
  for (const std::string& file : files) {
    const io::Patch patch = read_patch(file);
    fmt::print("  patch       {}: {}, {} images\n", patch.id, file, patch.images.size());
  }
  print_use(fmt::format("ridgeline run {} --out results", fmt::join(files, " ")));
}

/// Whether a file has the extension of a line file. If its kind is unknown, the line readers report
/// what is wrong with it.
bool is_named_as_lines(const std::string& path) {
  constexpr std::array kEndings{".geojson", ".json", ".gpkg", ".shp", ".dxf", ".obj",
                                ".ply",     ".wkt",  ".bin",  ".npy", ".stl"};
  const std::string extension = io::lower_case(std::filesystem::path(path).extension().string());
  return std::ranges::find(kEndings, extension) != kEndings.end();
}

[[noreturn]] void refuse(const std::string& path, const io::FileKind& kind) {
  const std::string advice = kind.advice.empty() ? "" : ", " + kind.advice;
  const std::string what = kind.is_known()     ? kind.what + advice
                           : kind.what.empty() ? "of an unknown kind"
                                               : kind.what;
  throw io::IoError(path, fmt::format("is {}; {}", what, kKnownKinds));
}

/// Selects by the file name if the content does not reveal the kind.
void print_by_name(const std::string& path, const io::FileKind& kind, double max_resolution_m) {
  const std::string extension = io::lower_case(std::filesystem::path(path).extension().string());
  if (extension == ".yaml" || extension == ".yml") return print_patch(path);
  if (extension == ".las" || extension == ".laz" || extension == ".pcd" || extension == ".xyz" ||
      extension == ".pts" || extension == ".asc") {
    return print_cloud(path, max_resolution_m);
  }
  if (extension == ".txt" || extension == ".csv") {
    return print_text_file(path, extension == ".csv", max_resolution_m);
  }
  if (is_named_as_lines(path)) return print_lines(path);
  if (!std::filesystem::is_directory(path)) io::require_regular_file(path);
  refuse(path, kind);
}

/// The options of the command.
struct InfoArguments {
  std::vector<std::string> files;
  double max_resolution_m = 0.0;
  OrientationArguments orientation;
};

void print_facts(const std::string& path, const InfoArguments& arguments) {
  const double max_resolution_m = arguments.max_resolution_m;
  const io::FileKind kind = io::kind_of_path(path);
  if (is_own_file(kind.group)) return print_own_file(path, kind);
  if (kind.group == io::FileGroup::kOrientation) {
    return print_orientation(path, arguments.orientation);
  }
  switch (kind.group) {
    case io::FileGroup::kPatch:
      return print_patch(path);
    case io::FileGroup::kBlock:
      fmt::print("{}: {}\n", path, kind.what.substr(2));
      return print_use(fmt::format("ridgeline block {} --out results", path));
    case io::FileGroup::kPatchFolder:
      return print_patches(path, kind);
    case io::FileGroup::kImage:
      return print_image(path);
    case io::FileGroup::kCloud:
      return print_cloud(path, max_resolution_m);
    case io::FileGroup::kPly:
      return is_line_ply(path) ? print_lines(path) : print_cloud(path, max_resolution_m);
    case io::FileGroup::kLines:
    case io::FileGroup::kModel:
    case io::FileGroup::kLineFolder:
      return print_lines(path);
    case io::FileGroup::kOther:
      refuse(path, kind);
    default:
      return print_by_name(path, kind, max_resolution_m);
  }
}

}  // namespace

namespace {

void add_orientation_options(CLI::App& subcommand, OrientationArguments& a) {
  constexpr const char* kGroup = "Orientations";
  const auto add = [&](const char* name, auto& value, const char* help) {
    return subcommand.add_option(name, value, help)->group(kGroup);
  };
  add("--cameras", a.cameras, "camera file (YAML), for orientations without cameras");
  add("--images", a.images,
      "folder of the images, for resolving ambiguities of the orientation; default: folder of the "
      "orientation");
  add("--angles", a.angles, "angle unit: deg, gon or rad")
      ->check(CLI::IsMember({"deg", "gon", "rad"}));
  add("--rotation", a.rotation, "rotation order: opk (omega, phi, kappa) or pok")
      ->check(CLI::IsMember({"opk", "pok"}));
  add("--matrix", a.matrix, "direction of PAT-B matrices: world_from_camera or camera_from_world")
      ->check(CLI::IsMember({"world_from_camera", "camera_from_world"}));
  add("--crs", a.crs, "reference system of a file without one, or the target for geocentric poses");
  add("--map", a.map,
      "write a GeoPackage of footprints, camera positions and number of images per cell");
  add("--ground-height", a.ground_height_m, "ground height for the map, m");
}

}  // namespace

Run add_info(CLI::App& subcommand) {
  auto arguments = std::make_shared<InfoArguments>();
  subcommand
      .add_option(
          "files", arguments->files,
          "clouds, images, orientations, line files, patch files, gates files, results or folders")
      ->required();
  subcommand
      .add_option("--max-resolution", arguments->max_resolution_m,
                  "quick look: read COPC levels only down to this point distance, m; 0: all")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  add_orientation_options(subcommand, arguments->orientation);
  return [arguments] {
    for (const std::string& file : arguments->files) print_facts(file, *arguments);
    return static_cast<int>(kDone);
  };
}

}  // namespace ridgeline::apps
