// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/command.h"
#include "apps/info/data_facts.h"
#include "apps/info/image_facts.h"
#include "apps/info/info_warnings.h"
#include "apps/info/orientation_facts.h"
#include "apps/info/own_files.h"
#include "apps/info/patch_facts.h"
#include "io/error.h"
#include "io/files/input_file.h"
#include "io/kinds/folder_kind.h"
#include "io/kinds/recognise.h"
#include "io/text/text.h"

#include <fmt/core.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <exception>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace ridgeline::apps {
namespace {

constexpr const char* kKnownKinds =
    "supported are point clouds (LAS, LAZ, COPC, PCD, PLY, text), lines (GeoJSON, GeoPackage, "
    "Shapefile, DXF, CSV, WKT, OBJ, PLY), building models (CityJSON, CityGML), images (TIFF, PNG, "
    "JPEG, JPEG 2000), orientations (omega-phi-kappa, OpenSfM, Pix4D, Inpho, PAT-B, "
    "BlocksExchange, Metashape, COLMAP), patch, gates and config files, tables of matches and "
    "segments, and folders of patches, blocks, orientations and results";

/// Whether a file has the extension of a line file. If its kind is unknown, the line readers report
/// what is wrong with it.
bool is_named_as_lines(const std::string& path) {
  constexpr std::array kEndings{".geojson", ".json", ".gpkg", ".shp", ".dxf", ".obj",
                                ".ply",     ".wkt",  ".bin",  ".npy", ".stl"};
  const std::string extension = io::lower_case(std::filesystem::path(path).extension().string());
  return std::ranges::find(kEndings, extension) != kEndings.end();
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

[[noreturn]] void refuse(const std::string& path, const io::FileKind& kind) {
  const std::string advice = kind.advice.empty() ? "" : ", " + kind.advice;
  const std::string what = kind.is_known()     ? kind.what + advice
                           : kind.what.empty() ? "of an unknown kind"
                                               : kind.what;
  throw io::IoError(path, fmt::format("is {}; {}", what, kKnownKinds));
}

/// The options of the command.
struct InfoArguments {
  std::vector<std::string> files;
  double max_resolution_m = 0.0;
  OrientationArguments orientation;
};

/// Prints the facts of files and folders.
class FactPrinter {
 public:
  explicit FactPrinter(const InfoArguments& arguments)
      : arguments_(arguments), warnings_(arguments.files.size()) {}

  /// Throws IoError for a file that cannot be read or is of no known kind.
  void print(const std::string& path) {
    const io::FileKind kind = io::kind_of_path(path);
    if (is_own_file(kind.group)) return print_own_file(path, kind);
    switch (kind.group) {
      case io::FileGroup::kOrientation:
        return print_orientation(path, arguments_.orientation, warnings_);
      case io::FileGroup::kPatch:
        return print_patch(path, warnings_);
      case io::FileGroup::kBlock:
        fmt::print("{}: {}\n", path, kind.what.substr(2));
        return print_use(fmt::format("ridgeline block {} --out results", path));
      case io::FileGroup::kBlockFolder:
        return print(io::block_file_in(path));
      case io::FileGroup::kPatchFolder:
        return print_patches(path, kind, warnings_);
      case io::FileGroup::kOrientationFolder:
        return print_orientations(path, kind, arguments_.orientation, warnings_);
      case io::FileGroup::kImage:
        return print_image(path, warnings_);
      case io::FileGroup::kCloud:
        return cloud(path);
      case io::FileGroup::kPly:
        return is_line_ply(path) ? print_lines(path, warnings_) : cloud(path);
      case io::FileGroup::kLines:
      case io::FileGroup::kModel:
      case io::FileGroup::kLineFolder:
        return print_lines(path, warnings_);
      case io::FileGroup::kOther:
        refuse(path, kind);
      default:
        return print_by_name(path, kind);
    }
  }

  void print_warnings() const { warnings_.print(); }

 private:
  void cloud(const std::string& path) { print_cloud(path, arguments_.max_resolution_m, warnings_); }

  /// Text files contain a cloud or a tool's lines. Lines are tried first, because their formats are
  /// stricter. A CSV that is neither was more likely meant to contain lines.
  void print_text_file(const std::string& path, bool is_csv) {
    try {
      print_lines(path, warnings_);
    } catch (const io::IoError& fault_of_lines) {
      try {
        cloud(path);
      } catch (const io::IoError&) {
        if (is_csv) throw fault_of_lines;
        throw;
      }
    }
  }

  /// Selects by the file name if the content does not reveal the kind.
  void print_by_name(const std::string& path, const io::FileKind& kind) {
    constexpr std::array kClouds{".las", ".laz", ".pcd", ".xyz", ".pts", ".asc"};
    const std::string extension = io::lower_case(std::filesystem::path(path).extension().string());
    if (extension == ".yaml" || extension == ".yml") return print_patch(path, warnings_);
    if (std::ranges::find(kClouds, extension) != kClouds.end()) return cloud(path);
    if (extension == ".txt" || extension == ".csv")
      return print_text_file(path, extension == ".csv");
    if (is_named_as_lines(path)) return print_lines(path, warnings_);
    if (!std::filesystem::is_directory(path)) io::require_regular_file(path);
    refuse(path, kind);
  }

  const InfoArguments& arguments_;
  InfoWarnings warnings_;
};

/// Shows all files, even if some cannot be read.
int run_info(const InfoArguments& arguments) {
  FactPrinter printer(arguments);
  ExitCode code = kDone;
  const bool is_single = arguments.files.size() == 1;
  const auto report = [&](const std::exception& error) {
    spdlog::error("{}", error.what());
    code = kWrongInput;
  };
  for (const std::string& file : arguments.files) {
    try {
      printer.print(file);
    } catch (const io::IoError& error) {
      if (is_single) throw;
      report(error);
    } catch (const std::invalid_argument& error) {
      if (is_single) throw;
      report(error);
    }
  }
  printer.print_warnings();
  return code;
}

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
  return [arguments] { return run_info(*arguments); };
}

}  // namespace ridgeline::apps
