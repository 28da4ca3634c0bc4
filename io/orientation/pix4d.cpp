// SPDX-License-Identifier: BSD-3-Clause
// Facts: Pix4D, "How are the internal and external camera parameters defined".
#include "io/error.h"
#include "io/orientation/orientation_text.h"
#include "io/orientation/readers.h"
#include "io/text/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace ridgeline::io {
namespace {

constexpr std::string_view kSuffix = "calibrated_camera_parameters.txt";

/// Rows of an image: K (3), radial and tangential distortion, position, R (3).
constexpr std::size_t kRowsOfImage = 10;
constexpr std::size_t kRowsOfHead = 8;

class Pix4dReader {
 public:
  explicit Pix4dReader(std::string path)
      : path_(std::move(path)), content_(read_orientation_text(path_)), rows_(rows_of(content_)) {}

  [[nodiscard]] Orientation read() {
    Orientation orientation;
    orientation.format = "Pix4D calibrated camera parameters";
    const Eigen::Vector3d offset_m = offset(orientation);
    for (std::size_t row = first_row(); row < rows_.size(); row += kRowsOfImage) {
      if (rows_.size() - row < kRowsOfImage) {
        throw IoError(place(path_, rows_[row].number), "is truncated; an image has ten rows");
      }
      add_image(row, offset_m, orientation);
    }
    orientation.crs.definition = text_beside(path_, name_beside("wkt.prj"), orientation);
    return orientation;
  }

 private:
  /// The header names the rows, up to "camera model m = K [R|-Rt] X"; the model determines the
  /// direction of R.
  [[nodiscard]] std::size_t first_row() const {
    const auto model = std::ranges::find_if(
        rows_, [](const TextRow& row) { return row.text.starts_with("camera model"); });
    const std::size_t first = static_cast<std::size_t>(model - rows_.begin()) + 1;
    if (model == rows_.end() || first > kRowsOfHead ||
        model->text.find("K [R|-Rt] X") == std::string_view::npos) {
      throw IoError(path_, "does not state the camera model m = K [R|-Rt] X");
    }
    return first;
  }

  void add_image(std::size_t row, const Eigen::Vector3d& offset_m, Orientation& orientation) const {
    OrientedImage image;
    InteriorOrientation interior = interior_of(row, image.name);
    image.camera = camera_number(interior, orientation);
    image.exterior.position_m = numbers_at<3>(row + 6).transpose() + offset_m;
    Eigen::Matrix3d cam_from_world;
    for (int i = 0; i < 3; ++i) {
      cam_from_world.row(i) = numbers_at<3>(row + 7 + static_cast<std::size_t>(i));
    }
    const Eigen::Vector3d flip(1.0, -1.0, -1.0);
    image.exterior.world_from_camera_axes = cam_from_world.transpose() * flip.asDiagonal();
    orientation.images.push_back(std::move(image));
  }

  /// Pixels are counted from the corner of the image: in the .cam file, the principal point is
  /// relative to width / 2.
  [[nodiscard]] InteriorOrientation interior_of(std::size_t row, std::string& name) const {
    const std::string where = place(path_, rows_[row].number);
    const std::vector<std::string_view> words = words_of(rows_[row].text);
    if (words.size() < 3) throw IoError(where, "name, width and height of an image are expected");
    const std::vector<double> size = to_doubles({words.end() - 2, words.end()}, where);
    constexpr double kMaxSide_px = 1e6;
    if (!(std::min(size[0], size[1]) >= 1.0) || std::max(size[0], size[1]) > kMaxSide_px) {
      throw IoError(where, fmt::format("{} x {} px; must be positive", size[0], size[1]));
    }
    name = trimmed(rows_[row].text.substr(
        0, static_cast<std::size_t>((words.end() - 2)->data() - rows_[row].text.data())));
    Eigen::Matrix3d K;
    for (int i = 0; i < 3; ++i) K.row(i) = numbers_at<3>(row + 1 + static_cast<std::size_t>(i));
    if (!(std::min(K(0, 0), K(1, 1)) > 0.0))
      throw IoError(where, "K must have positive focal lengths");
    const Eigen::RowVector3d radial = numbers_at<3>(row + 4);
    const Eigen::RowVector2d tangential = numbers_at<2>(row + 5);
    return {{K(0, 0), K(1, 1)},
            {K(0, 2) - 0.5, K(1, 2) - 0.5},
            {radial[0], radial[1], radial[2], tangential[0], tangential[1]},
            Eigen::Vector2d(size[0], size[1]).cast<int>()};
  }

  template <int N>
  [[nodiscard]] Eigen::Matrix<double, 1, N> numbers_at(std::size_t row) const {
    const std::string where = place(path_, rows_[row].number);
    const std::vector<double> values = to_doubles(words_of(rows_[row].text), where);
    if (values.size() != N)
      throw IoError(where, fmt::format("{} numbers; {} are needed", values.size(), N));
    return Eigen::Map<const Eigen::Matrix<double, 1, N>>(values.data());
  }

  /// The file repeats the camera with each image.
  static std::size_t camera_number(const InteriorOrientation& interior, Orientation& orientation) {
    const auto same = [&](const Camera& camera) {
      const InteriorOrientation& other = camera.interior;
      return other.focal_length_px == interior.focal_length_px &&
             other.principal_point_px == interior.principal_point_px &&
             other.size_px == interior.size_px && other.distortion.k1 == interior.distortion.k1 &&
             other.distortion.k2 == interior.distortion.k2 &&
             other.distortion.k3 == interior.distortion.k3 &&
             other.distortion.p1 == interior.distortion.p1 &&
             other.distortion.p2 == interior.distortion.p2;
    };
    std::vector<Camera>& cameras = orientation.cameras;
    const auto known = std::ranges::find_if(cameras, same);
    const std::size_t number = static_cast<std::size_t>(known - cameras.begin());
    if (known == cameras.end()) cameras.push_back({fmt::format("camera {}", number + 1), interior});
    return number;
  }

  /// The name of a file of the same export: "PREFIX_offset.xyz". A renamed file is its own prefix.
  [[nodiscard]] std::string name_beside(std::string_view ending) const {
    const std::string name = std::filesystem::path(path_).filename().string();
    const std::string prefix = name.ends_with(kSuffix)
                                   ? name.substr(0, name.size() - kSuffix.size())
                                   : std::filesystem::path(name).stem().string() + "_";
    return prefix + std::string(ending);
  }

  [[nodiscard]] Eigen::Vector3d offset(Orientation& orientation) const {
    const std::string text = text_beside(path_, name_beside("offset.xyz"), orientation);
    if (text.empty()) {
      orientation.warnings.push_back(
          fmt::format("has no {} next to it, so its positions are read without an offset",
                      name_beside("offset.xyz")));
      return Eigen::Vector3d::Zero();
    }
    const std::vector<double> values = to_doubles(words_of(text), path_ + ", offset.xyz");
    if (values.size() != 3)
      throw IoError(path_, "the offset.xyz next to it must contain three numbers");
    return {values[0], values[1], values[2]};
  }

  std::string path_, content_;
  std::vector<TextRow> rows_;
};

}  // namespace

Orientation read_pix4d(const std::string& path, const OrientationOptions&) {
  return Pix4dReader(path).read();
}

}  // namespace ridgeline::io
