// SPDX-License-Identifier: BSD-3-Clause
#include "io/orientation/colmap.h"

#include "io/error.h"
#include "io/files/input_file.h"
#include "io/orientation/readers.h"
#include "io/text/text.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <type_traits>

namespace ridgeline::io {
namespace {

struct CameraModel {
  int id;  ///< id of the model in .bin files
  std::string_view name;
  std::size_t n_params;
  bool is_supported = true;
};

constexpr std::array kModels{CameraModel{0, "SIMPLE_PINHOLE", 3},
                             CameraModel{1, "PINHOLE", 4},
                             CameraModel{2, "SIMPLE_RADIAL", 4},
                             CameraModel{3, "RADIAL", 5},
                             CameraModel{4, "OPENCV", 8},
                             CameraModel{5, "OPENCV_FISHEYE", 8, false},
                             CameraModel{6, "FULL_OPENCV", 12, false},
                             CameraModel{7, "FOV", 5, false},
                             CameraModel{8, "SIMPLE_RADIAL_FISHEYE", 4, false},
                             CameraModel{9, "RADIAL_FISHEYE", 5, false},
                             CameraModel{10, "THIN_PRISM_FISHEYE", 12, false},
                             CameraModel{11, "RAD_TAN_THIN_PRISM_FISHEYE", 16, false}};

/// A camera of the model. One that is not supported is refused when an image uses it.
struct ColmapCamera {
  std::string_view unsupported;  ///< name of its camera model; empty for a supported one
  InteriorOrientation interior;
};
using Cameras = std::map<std::uint32_t, ColmapCamera>;

[[noreturn]] void refuse_model(const std::string& where, std::string_view model) {
  throw IoError(where,
                fmt::format("camera model {}; supported are SIMPLE_PINHOLE, PINHOLE, "
                            "SIMPLE_RADIAL, RADIAL and OPENCV; undistort the images for others",
                            model));
}

/// The parameters are in the order f, cx, cy or fx, fy, cx, cy, then the distortion.
InteriorOrientation interior_of(const CameraModel& model,
                                const std::vector<double>& params,
                                const std::string& where) {
  const bool two_focals = model.name == "PINHOLE" || model.name == "OPENCV";
  const std::size_t point = two_focals ? 2 : 1;
  InteriorOrientation interior;
  interior.focal_length_px = {params[0], params[point - 1]};
  if (!(interior.focal_length_px.minCoeff() > 0.0)) {
    throw IoError(where, fmt::format("focal length {}; must be positive", params[0]));
  }
  interior.principal_point_px = {params[point] - 0.5, params[point + 1] - 0.5};
  if (model.n_params > point + 2) interior.distortion.k1 = params[point + 2];
  if (model.n_params > point + 3) interior.distortion.k2 = params[point + 3];
  if (model.name == "OPENCV") {
    interior.distortion.p1 = params[6];
    interior.distortion.p2 = params[7];
  }
  return interior;
}

/// COLMAP gives the transformation from world to camera with axes x right, y down, z forwards.
ExteriorOrientation exterior_of(const std::array<double, 7>& q_and_t, const std::string& where) {
  const Eigen::Quaterniond rotation(q_and_t[0], q_and_t[1], q_and_t[2], q_and_t[3]);
  if (!(rotation.norm() > 0.0)) throw IoError(where, "the rotation quaternion is zero");
  const Eigen::Matrix3d world_from_cam = rotation.normalized().conjugate().toRotationMatrix();
  const Eigen::Vector3d translation(q_and_t[4], q_and_t[5], q_and_t[6]);
  const Eigen::Vector3d flip(1.0, -1.0, -1.0);
  return {-(world_from_cam * translation), world_from_cam * flip.asDiagonal()};
}

Eigen::Vector2i size_of(double width_px, double height_px, const std::string& where) {
  constexpr double kMaxSide_px = 1e6;
  if (width_px >= 1.0 && height_px >= 1.0 && width_px <= kMaxSide_px && height_px <= kMaxSide_px) {
    return Eigen::Vector2d(width_px, height_px).cast<int>();
  }
  throw IoError(where,
                fmt::format("a camera of {} x {} px; must be positive", width_px, height_px));
}

const InteriorOrientation& camera_of(const Cameras& cameras,
                                     std::uint32_t id,
                                     const std::string& where) {
  const auto it = cameras.find(id);
  if (it == cameras.end()) throw IoError(where, fmt::format("camera {} is not in the model", id));
  if (!it->second.unsupported.empty()) refuse_model(where, it->second.unsupported);
  return it->second.interior;
}

/// Reads the rows of a text file one by one, without comments, so that files of any size take
/// little memory. Blank rows count, because an image without points has a blank second row.
class ColmapRows {
 public:
  explicit ColmapRows(const std::string& path) : path_(path) {
    require_regular_file(path);
    stream_.open(path, std::ios::binary);
  }

  /// The next row; std::nullopt at the end of the file. The text is valid until the next call.
  std::optional<TextRow> next() {
    while (read_row()) {
      ++number_;
      const std::string_view text = trimmed(row_);
      if (!text.starts_with('#')) return TextRow{number_, text};
    }
    return std::nullopt;
  }

 private:
  /// The limit on the length of a row is that of an image with 100,000 points.
  bool read_row() {
    constexpr std::size_t kMaxRow_bytes = std::size_t{8} << 20U;
    row_.clear();
    bool any = false;
    for (int c = buffer_->sbumpc(); c != std::char_traits<char>::eof(); c = buffer_->sbumpc()) {
      any = true;
      if (c == '\n') return true;
      if (row_.size() == kMaxRow_bytes) {
        throw IoError(place(path_, number_ + 1), "is not text; the file is damaged");
      }
      row_ += static_cast<char>(c);
    }
    return any;
  }

  std::string path_, row_;
  std::ifstream stream_;
  std::filebuf* buffer_ = stream_.rdbuf();
  int number_ = 0;
};

std::uint32_t id_of(std::string_view word, const std::string& where) {
  const std::optional<long> id = to_integer(word);
  if (!id || *id < 0 || *id > 0xffffffffL) {
    throw IoError(where, "'" + std::string(word) + "' is not an id");
  }
  return static_cast<std::uint32_t>(*id);
}

Cameras read_cameras_text(const std::string& path) {
  ColmapRows rows(path);
  Cameras cameras;
  while (const std::optional<TextRow> row = rows.next()) {
    if (row->text.empty()) continue;
    const std::string where = place(path, row->number);
    const std::vector<std::string_view> words = words_of(row->text);
    const std::string_view name = words.size() > 1 ? words[1] : std::string_view();
    const auto* const model = std::find_if(kModels.begin(), kModels.end(),
                                           [&](const CameraModel& m) { return m.name == name; });
    if (model == kModels.end()) refuse_model(where, name);
    if (words.size() != 4 + model->n_params) {
      throw IoError(where,
                    fmt::format("{} fields; {} has {}", words.size(), name, 4 + model->n_params));
    }
    ColmapCamera& camera = cameras[id_of(words[0], where)];
    if (!model->is_supported) {
      camera.unsupported = model->name;
      continue;
    }
    camera.interior =
        interior_of(*model, to_doubles({words.begin() + 4, words.end()}, where), where);
    const std::vector<double> size = to_doubles({words.begin() + 2, words.begin() + 4}, where);
    camera.interior.size_px = size_of(size[0], size[1], where);
  }
  return cameras;
}

ColmapImage image_of(const TextRow& row, const std::string& where, const Cameras& cameras) {
  const std::vector<std::string_view> words = words_of(row.text);
  if (words.size() < 10) {
    throw IoError(
        where,
        "an image must be ID QW QX QY QZ TX TY TZ CAMERA_ID NAME, followed by a row of points");
  }
  const std::vector<double> numbers = to_doubles({words.begin() + 1, words.begin() + 8}, where);
  std::array<double, 7> q_and_t{};
  std::copy(numbers.begin(), numbers.end(), q_and_t.begin());
  const std::string name(words[9].data(), row.text.end() - words[9].begin());
  const std::uint32_t camera = id_of(words[8], where);
  return {id_of(words[0], where), name, camera, camera_of(cameras, camera, where),
          exterior_of(q_and_t, where)};
}

std::vector<ColmapImage> read_images_text(const std::string& path, const Cameras& cameras) {
  ColmapRows rows(path);
  std::vector<ColmapImage> images;
  while (const std::optional<TextRow> row = rows.next()) {
    const std::string where = place(path, row->number);
    const std::string text(row->text);
    const std::optional<TextRow> points = rows.next();  // every second row lists 2D points
    if (text.empty() && !points) break;
    images.push_back(image_of({row->number, text}, where, cameras));
  }
  return images;
}

/// Reads consecutive little-endian values, as on every machine that COLMAP runs on.
class BinaryReader {
 public:
  explicit BinaryReader(const std::string& path) : path_(path) {
    require_regular_file(path);
    stream_.open(path, std::ios::binary);
    left_ = std::filesystem::file_size(path);
  }

  template <typename T>
  T next() {
    static_assert(std::is_trivially_copyable_v<T>);
    T value;
    take(sizeof(T));
    stream_.read(reinterpret_cast<char*>(&value), sizeof(T));
    return value;
  }
  std::string next_text() {
    constexpr std::size_t kMaxName_bytes = 4096;  // of a path
    std::string text;
    while (const char c = next<char>()) {
      text += c;
      if (text.size() > kMaxName_bytes) throw IoError(path_, "has a name of more than 4096 bytes");
    }
    return text;
  }
  void skip(std::uint64_t count, std::size_t size) {
    if (count > left_ / size) throw IoError(path_, "is truncated");
    take(count * size);
    stream_.seekg(static_cast<std::streamoff>(count * size), std::ios::cur);
  }

 private:
  void take(std::uint64_t size) {
    if (size > left_) throw IoError(path_, "is truncated");
    left_ -= size;
  }

  std::string path_;
  std::ifstream stream_;
  std::uint64_t left_ = 0;
};

Cameras read_cameras_binary(const std::string& path) {
  BinaryReader reader(path);
  Cameras cameras;
  const auto count = reader.next<std::uint64_t>();
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto id = reader.next<std::uint32_t>();
    const auto model_id = reader.next<std::int32_t>();
    const auto width = reader.next<std::uint64_t>();
    const auto height = reader.next<std::uint64_t>();
    const auto* const model = std::find_if(kModels.begin(), kModels.end(),
                                           [&](const CameraModel& m) { return m.id == model_id; });
    if (model == kModels.end()) refuse_model(path, std::to_string(model_id));
    std::vector<double> params(model->n_params);
    for (double& param : params) param = reader.next<double>();
    ColmapCamera& camera = cameras[id];
    if (!model->is_supported) {
      camera.unsupported = model->name;
      continue;
    }
    camera.interior = interior_of(*model, params, path);
    camera.interior.size_px =
        size_of(static_cast<double>(width), static_cast<double>(height), path);
  }
  return cameras;
}

std::vector<ColmapImage> read_images_binary(const std::string& path, const Cameras& cameras) {
  constexpr std::size_t kPointSize = 24;  // x, y, id of the 3D point
  BinaryReader reader(path);
  std::vector<ColmapImage> images;
  const auto count = reader.next<std::uint64_t>();
  for (std::uint64_t i = 0; i < count; ++i) {
    ColmapImage image;
    image.id = reader.next<std::uint32_t>();
    std::array<double, 7> q_and_t{};
    for (double& value : q_and_t) value = reader.next<double>();
    image.exterior = exterior_of(q_and_t, path);
    image.camera = reader.next<std::uint32_t>();
    image.interior = camera_of(cameras, image.camera, path);
    image.name = reader.next_text();
    reader.skip(reader.next<std::uint64_t>(), kPointSize);
    images.push_back(std::move(image));
  }
  return images;
}

}  // namespace

std::vector<ColmapImage> read_colmap(const std::string& folder) {
  const std::filesystem::path path(folder);
  if (!std::filesystem::is_directory(path)) throw MissingFileError(folder, "no such folder");
  const bool binary = std::filesystem::exists(path / "images.bin");
  std::vector<ColmapImage> images =
      binary ? read_images_binary((path / "images.bin").string(),
                                  read_cameras_binary((path / "cameras.bin").string()))
             : read_images_text((path / "images.txt").string(),
                                read_cameras_text((path / "cameras.txt").string()));
  std::sort(images.begin(), images.end(),
            [](const ColmapImage& a, const ColmapImage& b) { return a.id < b.id; });
  return images;
}

std::vector<std::string> colmap_files(const std::string& folder) {
  std::vector<std::string> files;
  for (const char* const name : {"cameras.bin", "cameras.txt", "images.bin", "images.txt"}) {
    const std::filesystem::path file = std::filesystem::path(folder) / name;
    if (std::filesystem::exists(file)) files.push_back(file.string());
  }
  return files;
}

Orientation read_colmap_orientation(const std::string& folder, const OrientationOptions&) {
  Orientation orientation;
  orientation.format = "COLMAP model";
  std::map<std::uint32_t, std::size_t> numbers;
  for (const ColmapImage& image : read_colmap(folder)) {
    const auto [number, is_new] = numbers.try_emplace(image.camera, orientation.cameras.size());
    if (is_new) {
      orientation.cameras.push_back({fmt::format("camera {}", image.camera), image.interior});
    }
    orientation.images.push_back({image.name, number->second, image.exterior});
  }
  return orientation;
}

}  // namespace ridgeline::io
