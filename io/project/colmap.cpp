// SPDX-License-Identifier: BSD-3-Clause
#include "io/project/colmap.h"

#include "io/error.h"
#include "io/files/input_file.h"
#include "io/text/text.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <map>
#include <type_traits>

namespace ridgeline::io {
namespace {

using Cameras = std::map<std::uint32_t, InteriorOrientation>;

struct CameraModel {
  int id;  ///< number of the model in .bin files
  std::string_view name;
  std::size_t n_params;
};

constexpr std::array kModels{CameraModel{0, "SIMPLE_PINHOLE", 3}, CameraModel{1, "PINHOLE", 4},
                             CameraModel{2, "SIMPLE_RADIAL", 4}, CameraModel{3, "RADIAL", 5},
                             CameraModel{4, "OPENCV", 8}};

[[noreturn]] void refuse_model(const std::string& where, std::string_view model) {
  throw IoError(where,
                fmt::format("camera model {}; SIMPLE_PINHOLE, PINHOLE, SIMPLE_RADIAL, RADIAL and "
                            "OPENCV are read, undistort the images for others",
                            model));
}

/// The parameters stand as f, cx, cy or fx, fy, cx, cy, then the distortion.
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

/// COLMAP states camera from world with axes x right, y down, z forwards.
ExteriorOrientation exterior_of(const std::array<double, 7>& q_and_t, const std::string& where) {
  const Eigen::Quaterniond rotation(q_and_t[0], q_and_t[1], q_and_t[2], q_and_t[3]);
  if (!(rotation.norm() > 0.0)) throw IoError(where, "the rotation quaternion is zero");
  const Eigen::Matrix3d world_from_cam = rotation.normalized().conjugate().toRotationMatrix();
  const Eigen::Vector3d translation(q_and_t[4], q_and_t[5], q_and_t[6]);
  const Eigen::Vector3d flip(1.0, -1.0, -1.0);
  return {-(world_from_cam * translation), world_from_cam * flip.asDiagonal()};
}

const InteriorOrientation& camera_of(const Cameras& cameras,
                                     std::uint32_t id,
                                     const std::string& where) {
  const auto it = cameras.find(id);
  if (it == cameras.end()) throw IoError(where, fmt::format("camera {} is not in the model", id));
  return it->second;
}

/// Rows that are no comments. Blank ones stay, as an image without points has a blank second row.
std::vector<TextRow> rows_with_blanks(std::string_view content) {
  std::vector<TextRow> rows;
  for (int number = 1; !content.empty(); ++number) {
    const std::size_t end = content.find('\n');
    const std::string_view text = trimmed(content.substr(0, end));
    if (!text.starts_with('#')) rows.push_back({number, text});
    content.remove_prefix(end == std::string_view::npos ? content.size() : end + 1);
  }
  return rows;
}

std::uint32_t id_of(std::string_view word, const std::string& where) {
  const std::optional<long> id = to_integer(word);
  if (!id || *id < 0 || *id > 0xffffffffL) {
    throw IoError(where, "'" + std::string(word) + "' is no id");
  }
  return static_cast<std::uint32_t>(*id);
}

Cameras read_cameras_text(const std::string& path) {
  const std::string content = read_input(path);
  Cameras cameras;
  for (const TextRow& row : rows_of(content)) {
    if (row.text.starts_with('#')) continue;
    const std::string where = place(path, row.number);
    const std::vector<std::string_view> words = words_of(row.text);
    const std::string_view name = words.size() > 1 ? words[1] : std::string_view();
    const auto* const model = std::find_if(kModels.begin(), kModels.end(),
                                           [&](const CameraModel& m) { return m.name == name; });
    if (model == kModels.end()) refuse_model(where, name);
    if (words.size() != 4 + model->n_params) {
      throw IoError(where,
                    fmt::format("{} fields; {} has {}", words.size(), name, 4 + model->n_params));
    }
    InteriorOrientation interior =
        interior_of(*model, to_doubles({words.begin() + 4, words.end()}, where), where);
    const std::vector<double> size = to_doubles({words.begin() + 2, words.begin() + 4}, where);
    interior.size_px = Eigen::Vector2d(size[0], size[1]).cast<int>();
    cameras[id_of(words[0], where)] = interior;
  }
  return cameras;
}

std::vector<ColmapImage> read_images_text(const std::string& path, const Cameras& cameras) {
  const std::string content = read_input(path);
  const std::vector<TextRow> rows = rows_with_blanks(content);
  std::vector<ColmapImage> images;
  for (std::size_t i = 0; i < rows.size(); i += 2) {  // each second row lists 2D points
    const std::string where = place(path, rows[i].number);
    const std::vector<std::string_view> words = words_of(rows[i].text);
    if (words.empty() && i + 1 == rows.size()) break;
    if (words.size() < 10) {
      throw IoError(where,
                    "an image is ID QW QX QY QZ TX TY TZ CAMERA_ID NAME, then a row of points");
    }
    const std::vector<double> numbers = to_doubles({words.begin() + 1, words.begin() + 8}, where);
    std::array<double, 7> q_and_t{};
    std::copy(numbers.begin(), numbers.end(), q_and_t.begin());
    const std::string name(words[9].data(), rows[i].text.end() - words[9].begin());
    images.push_back({id_of(words[0], where), name,
                      camera_of(cameras, id_of(words[8], where), where),
                      exterior_of(q_and_t, where)});
  }
  return images;
}

/// Little-endian values one after another, as on every machine that COLMAP runs on.
class BinaryReader {
 public:
  explicit BinaryReader(const std::string& path) : path_(path), bytes_(read_input(path)) {}

  template <typename T>
  T next() {
    static_assert(std::is_trivially_copyable_v<T>);
    T value;
    std::memcpy(&value, take(sizeof(T)).data(), sizeof(T));
    return value;
  }
  std::string next_text() {
    const std::size_t end = bytes_.find('\0', next_);
    if (end == std::string::npos) throw IoError(path_, "is truncated");
    std::string text(take(end - next_));
    take(1);
    return text;
  }
  void skip(std::uint64_t count, std::size_t size) {
    if (count > (bytes_.size() - next_) / size) throw IoError(path_, "is truncated");
    next_ += count * size;
  }

 private:
  std::string_view take(std::size_t size) {
    if (size > bytes_.size() - next_) throw IoError(path_, "is truncated");
    next_ += size;
    return std::string_view(bytes_).substr(next_ - size, size);
  }

  std::string path_;
  std::string bytes_;
  std::size_t next_ = 0;
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
    InteriorOrientation interior = interior_of(*model, params, path);
    interior.size_px = Eigen::Vector2i(static_cast<int>(width), static_cast<int>(height));
    cameras[id] = interior;
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
    image.interior = camera_of(cameras, reader.next<std::uint32_t>(), path);
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

}  // namespace ridgeline::io
