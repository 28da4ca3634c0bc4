// SPDX-License-Identifier: BSD-3-Clause
#include "io/error.h"
#include "io/orientation/geocentric_poses.h"
#include "io/orientation/orientation_text.h"
#include "io/orientation/readers.h"
#include "io/text/json_text.h"
#include "io/text/text.h"

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace ridgeline::io {
namespace {

using Json = nlohmann::json;

/// Whether a key of a reconstruction or of one of its shots is large and not needed.
bool is_key_left_out(const Json& key) {
  constexpr std::array kLeftOut{"points", "biases", "vertices", "faces", "covariance"};
  return std::ranges::any_of(kLeftOut, [&](const char* name) { return key == name; });
}

/// Parses without the points. A duplicate name in an object is an error; the parser itself would
/// keep the last one.
Json parse_without_points(const std::string& path) {
  constexpr int kOfReconstruction = 2;  // depth: within the list and the object
  const std::string text = read_orientation_text(path, std::uint64_t{4} * kMaxOrientation_bytes);
  if (!is_shallow_json(text)) throw IoError(path, "is nested more than 64 levels deep");
  std::set<std::string> names;
  const auto keep = [&](int depth, Json::parse_event_t event, Json& parsed) {
    if (event != Json::parse_event_t::key) return true;
    if (depth == kOfReconstruction) names.clear();
    if (depth == kOfReconstruction + 1 && !names.insert(parsed.get<std::string>()).second) {
      throw IoError(path, fmt::format("states {} twice", excerpt(parsed)));
    }
    return !is_key_left_out(parsed);
  };
  try {
    return Json::parse(text, keep);
  } catch (const Json::exception& error) {
    throw IoError(path, fmt::format("is not JSON: {}", excerpt(error.what())));
  }
}

class OpensfmReader {
 public:
  OpensfmReader(std::string path, const OrientationOptions& options)
      : path_(std::move(path)), options_(options) {}

  [[nodiscard]] Orientation read() {
    const Json file = parse_without_points(path_);
    const Json& reconstruction = largest_of(file);
    Orientation orientation;
    orientation.format = "OpenSfM reconstruction";
    const Json& cameras = member(reconstruction, "cameras");
    for (const auto& [name, shot] : member(reconstruction, "shots").items()) {
      orientation.images.push_back(image_of(name, shot));
      orientation.images.back().camera = camera_number(name, shot, cameras, orientation);
    }
    if (file.size() > 1) {
      orientation.warnings.push_back(
          fmt::format("has {} reconstructions; using the one with the most images", file.size()));
    }
    if (!unread_.empty()) {
      orientation.warnings.push_back(
          fmt::format("members that are not read: {}", fmt::join(unread_, ", ")));
    }
    if (is_on_map()) {
      place_on_map(orientation);
    } else {
      place_on_earth(reconstruction, orientation);
    }
    return orientation;
  }

 private:
  [[nodiscard]] const Json& largest_of(const Json& file) const {
    if (!file.is_array() || file.empty()) fail("is not a list of reconstructions");
    const auto n_shots = [](const Json& one) {
      return one.is_object() && one.contains("shots") ? one["shots"].size() : 0;
    };
    return *std::ranges::max_element(file, {}, n_shots);
  }

  [[nodiscard]] const Json& member(const Json& parent, const char* name) const {
    if (!parent.is_object() || !parent.contains(name) || !parent[name].is_object()) {
      fail(fmt::format("has no object \"{}\"", name));
    }
    return parent[name];
  }

  [[nodiscard]] double number(const Json& parent, const char* name) const {
    const bool is_number = parent.contains(name) && parent[name].is_number();
    const double value = is_number ? parent[name].get<double>() : std::nan("");
    if (!std::isfinite(value))
      fail(fmt::format("{} must be a number in {}", name, excerpt(parent)));
    return value;
  }

  [[nodiscard]] double number_or_zero(const Json& parent, const char* name) const {
    return parent.contains(name) ? number(parent, name) : 0.0;
  }

  [[nodiscard]] Eigen::Vector3d vector(const Json& parent, const char* name) const {
    const Json* const list = parent.contains(name) ? &parent[name] : nullptr;
    if (list == nullptr || !list->is_array() || list->size() != 3) {
      fail(fmt::format("{} must be three numbers in {}", name, excerpt(parent)));
    }
    Eigen::Vector3d x;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!(*list)[i].is_number()) fail(fmt::format("{} must be three numbers", name));
      x[static_cast<Eigen::Index>(i)] = (*list)[i].get<double>();
    }
    return x;
  }

  /// Focal lengths and the principal point are in units of the longer side; the latter is relative
  /// to the image centre.
  [[nodiscard]] InteriorOrientation interior_of(const std::string& name, const Json& camera) const {
    const std::string type = camera.is_object() && camera.contains("projection_type") &&
                                     camera["projection_type"].is_string()
                                 ? camera["projection_type"].get<std::string>()
                                 : "";
    const bool has_one_focal = type == "perspective" || type == "simple_radial";
    if (!has_one_focal && type != "brown" && type != "radial") {
      fail(fmt::format(
          "camera {} is of type '{}'; supported are perspective, simple_radial, radial and brown",
          name, type));
    }
    InteriorOrientation interior;
    interior.size_px = size_of(camera);
    const Eigen::Vector2d size_px = interior.size_px->cast<double>();
    interior.focal_length_px = size_px.maxCoeff() * focal_of(camera);
    const Eigen::Vector2d offset(number_or_zero(camera, "c_x"), number_or_zero(camera, "c_y"));
    interior.principal_point_px =
        0.5 * (size_px - Eigen::Vector2d::Ones()) + size_px.maxCoeff() * offset;
    const auto value = [&](const char* key) { return number_or_zero(camera, key); };
    interior.distortion = {value("k1"), value("k2"), value("k3"), value("p1"), value("p2")};
    return interior;
  }

  [[nodiscard]] Eigen::Vector2i size_of(const Json& camera) const {
    constexpr double kMaxSide_px = 1e6;
    const Eigen::Vector2d size(number(camera, "width"), number(camera, "height"));
    if (size.minCoeff() < 1.0 || size.maxCoeff() > kMaxSide_px)
      fail("a camera's size must be positive");
    return size.cast<int>();
  }

  [[nodiscard]] Eigen::Vector2d focal_of(const Json& camera) const {
    const bool is_one = camera.contains("focal");
    Eigen::Vector2d focal(number(camera, is_one ? "focal" : "focal_x"),
                          number(camera, is_one ? "focal" : "focal_y"));
    if (!(focal.minCoeff() > 0.0))
      fail(fmt::format("focal length {}; must be positive", focal.x()));
    return focal;
  }

  /// The camera of a shot, which is read when its first shot needs it: the file lists all cameras
  /// of the data set.
  [[nodiscard]] std::size_t camera_number(const std::string& image,
                                          const Json& shot,
                                          const Json& cameras,
                                          Orientation& orientation) {
    const Json named = shot.value("camera", Json());
    const std::string name = named.is_string() ? named.get<std::string>() : "";
    if (!cameras.contains(name)) {
      fail(fmt::format("image {} does not name a camera of the file", image));
    }
    std::vector<Camera>& read = orientation.cameras;
    const auto known = std::ranges::find(read, name, &Camera::name);
    const std::size_t number = static_cast<std::size_t>(known - read.begin());
    if (known == read.end()) {
      read.push_back({name, interior_of(name, cameras[name])});
      note_unread("camera", cameras[name],
                  {"projection_type", "width", "height", "focal", "focal_x", "focal_y", "c_x",
                   "c_y", "k1", "k2", "k3", "p1", "p2"});
    }
    return number;
  }

  /// Notes members that concern the pixels or the pose, except those that are zero and the values
  /// before the adjustment.
  void note_unread(const char* of,
                   const Json& parent,
                   std::initializer_list<std::string_view> known) {
    for (const auto& [name, value] : parent.items()) {
      if (std::ranges::find(known, name) != known.end() || name.ends_with("_prior")) continue;
      if (value == 0 || value == false || value.is_null() || value.is_string()) continue;
      unread_.insert(fmt::format("{} of {}", name, of));
    }
  }

  [[nodiscard]] OrientedImage image_of(const std::string& name, const Json& shot) {
    if (!shot.is_object()) fail(fmt::format("image {} must be an object", name));
    OrientedImage image;
    image.name = name;
    note_unread("shot", shot,
                {"rotation", "translation", "camera", "orientation", "capture_time", "gps_dop",
                 "gps_position", "gps_accuracy", "compass", "gravity_down", "opk_angles",
                 "opk_accuracy", "sequence_key", "scale", "merge_cc", "skey"});
    const Eigen::Vector3d turn = vector(shot, "rotation");
    const double angle_rad = turn.norm();
    const Eigen::Matrix3d cam_from_world =
        angle_rad > 0.0 ? Eigen::AngleAxisd(angle_rad, turn / angle_rad).toRotationMatrix()
                        : Eigen::Matrix3d::Identity();
    const Eigen::Vector3d flip(1.0, -1.0, -1.0);
    image.exterior.position_m = -(cam_from_world.transpose() * vector(shot, "translation"));
    image.exterior.world_from_camera_axes = cam_from_world.transpose() * flip.asDiagonal();
    return image;
  }

  /// Whether the file is one of `opensfm export_geocoords`, whose positions are map coordinates
  /// less an offset. Only its name shows this.
  [[nodiscard]] bool is_on_map() const {
    return lower_case(std::filesystem::path(path_).filename().string()).find("geocoords") !=
           std::string::npos;
  }

  /// The coords.txt of OpenDroneMap states the system ("WGS84 UTM 32N" or a PROJ string) and the
  /// offset. It lies next to the file or in the project's folder odm_georeferencing.
  void place_on_map(Orientation& orientation) const {
    std::string text;
    for (const char* const name : {"coords.txt", "../odm_georeferencing/coords.txt"}) {
      if (text.empty()) text = text_beside(path_, name, orientation);
    }
    const std::vector<TextRow> rows = rows_of(text);
    if (rows.size() < 2) {
      fail(
          "has map coordinates less an offset, and coords.txt of OpenDroneMap, which states both, "
          "is neither next to it nor in ../odm_georeferencing; give reconstruction.json instead");
    }
    const std::vector<double> offset = to_doubles(words_of(rows[1].text), path_ + ", coords.txt");
    if (offset.size() < 2) fail("the coords.txt next to it must state an offset in x and y");
    for (OrientedImage& image : orientation.images) {
      image.exterior.position_m += Eigen::Vector3d(offset[0], offset[1], 0.0);
    }
    orientation.crs.definition = system_named(rows[0].text);
  }

  /// "EPSG:32632" for "WGS84 UTM 32N"; other definitions unchanged.
  [[nodiscard]] static std::string system_named(std::string_view text) {
    const std::vector<std::string_view> words = words_of(text);
    if (words.size() != 3 || words[1] != "UTM" || words[2].empty()) return std::string(text);
    const auto zone = to_integer(words[2].substr(0, words[2].size() - 1));
    const int hemisphere = words[2].ends_with('N') ? 32600 : 32700;
    return zone ? fmt::format("EPSG:{}", hemisphere + *zone) : std::string(text);
  }

  /// Poses are topocentric; their origin is given in the file or in reference_lla.json next to it.
  void place_on_earth(const Json& reconstruction, Orientation& orientation) const {
    Json reference = reconstruction.value("reference_lla", Json());
    if (!reference.is_object()) {
      const std::string text = text_beside(path_, "reference_lla.json", orientation);
      reference = Json::parse(text, nullptr, false);
    }
    if (!reference.is_object()) {
      orientation.warnings.emplace_back(
          "has no reference_lla; its coordinates are local and without a reference system");
      return;
    }
    const GeodeticPlace place{number(reference, "latitude"), number(reference, "longitude"),
                              number(reference, "altitude")};
    if (std::abs(place.lat_deg) > 90.0 || std::abs(place.lon_deg) > 360.0) {
      fail("reference_lla must be latitude and longitude in degrees");
    }
    convert_to_map(path_, geocentric_from_enu(place), options_.crs, orientation);
  }

  [[noreturn]] void fail(const std::string& message) const { throw IoError(path_, message); }

  std::string path_;
  const OrientationOptions& options_;
  std::set<std::string> unread_;  ///< "rolling_shutter of camera"
};

}  // namespace

Orientation read_opensfm(const std::string& path, const OrientationOptions& options) {
  return OpensfmReader(path, options).read();
}

}  // namespace ridgeline::io
