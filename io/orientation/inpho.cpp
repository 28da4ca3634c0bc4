// SPDX-License-Identifier: BSD-3-Clause
#include "io/error.h"
#include "io/orientation/camera_file.h"
#include "io/orientation/inpho_blocks.h"
#include "io/orientation/left_out.h"
#include "io/orientation/orientation_text.h"
#include "io/orientation/readers.h"
#include "io/text/text.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ridgeline::io {
namespace {

class InphoReader {
 public:
  explicit InphoReader(std::string path)
      : path_(std::move(path)),
        content_(read_orientation_text(path_)),
        blocks_(inpho_blocks(content_)) {}

  [[nodiscard]] Orientation read() {
    orientation_.format = "Inpho project";
    for (const InphoBlock& block : blocks_) read_units(block);
    for (const InphoBlock& block : blocks_) {
      if (block.name == "$PHOTO") add_photo(block);
    }
    orientation_.warnings = left_out_.sentences();
    if (n_heights_ > 0) orientation_.ground_height_m = sum_of_heights_m_ / n_heights_;
    return std::move(orientation_);
  }

 private:
  [[noreturn]] void fail(int row, const std::string& message) const {
    throw IoError(place(path_, row), message);
  }

  void read_units(const InphoBlock& block) {
    const std::string unit = lower_case(block.text("$LINEAR_UNITS_OF_OBJECT"));
    if (!unit.empty() && unit != "m" && unit != "meter" && unit != "metre" && unit != "meters") {
      fail(block.row, "$LINEAR_UNITS_OF_OBJECT : " + unit + "; must be metres");
    }
    const InphoEntry* const system = block.find("$COORDINATE_SYSTEM");
    if (system == nullptr || orientation_.crs.known()) return;
    std::string definition = system->value;
    for (const TextRow& row : system->rows) definition += std::string(row.text);
    const std::size_t bracket = definition.find('[');
    if (bracket != std::string::npos) orientation_.crs.definition = definition;
  }

  /// The `n_rows` rows of `n` numbers each below a key.
  [[nodiscard]] Eigen::MatrixXd matrix(const InphoBlock& block,
                                       const std::string& key,
                                       std::size_t n_rows,
                                       std::size_t n) const {
    const InphoEntry* const entry = block.find(key);
    if (entry == nullptr) fail(block.row, fmt::format("{} has no {}", block.name, key));
    if (entry->rows.size() < n_rows) {
      fail(entry->row, fmt::format("{} is truncated; {} rows of numbers are needed", key, n_rows));
    }
    Eigen::MatrixXd values(n_rows, n);
    for (std::size_t i = 0; i < n_rows; ++i) {
      const std::string where = place(path_, entry->rows[i].number);
      const std::vector<double> numbers = to_doubles(words_of(entry->rows[i].text), where);
      if (numbers.size() != n)
        fail(entry->rows[i].number, fmt::format("{} numbers; {} has {}", numbers.size(), key, n));
      values.row(static_cast<Eigen::Index>(i)) =
          Eigen::Map<const Eigen::RowVectorXd>(numbers.data(), static_cast<Eigen::Index>(n));
    }
    if (!values.allFinite()) fail(entry->row, key + " must have finite numbers");
    return values;
  }

  [[nodiscard]] std::vector<double> numbers(const InphoBlock& block,
                                            const std::string& key,
                                            std::size_t n) const {
    const InphoEntry* const entry = block.find(key);
    if (entry == nullptr) fail(block.row, fmt::format("{} has no {}", block.name, key));
    std::vector<double> values = to_doubles(words_of(entry->value), place(path_, entry->row));
    const bool is_finite = std::ranges::all_of(values, [](double v) { return std::isfinite(v); });
    if (values.size() != n || !is_finite) {
      fail(entry->row, fmt::format("{} : {}; {} numbers are needed", key, entry->value, n));
    }
    return values;
  }

  /// The prefix of the keys of the active calibration: none, or the number of its $CALIBRATION_SET.
  [[nodiscard]] static std::string calibration_of(const InphoBlock& block) {
    const std::string active = block.text("$ACTIVE_CALIBRATION");
    std::string first;
    for (const auto& [key, entry] : block.entries) {
      if (!key.ends_with("/$ID")) continue;
      std::string prefix = key.substr(0, key.find('/') + 1);
      if (first.empty()) first = prefix;
      if (entry.value == active) return prefix;
    }
    return first;
  }

  void add_camera(const InphoBlock& block) {
    require_closed(block);
    const std::string id = camera_id_of(block);
    note_fiducials(block, id);
    const std::string prefix = calibration_of(block);
    const auto key = [&](const char* name) {
      return block.find(prefix + name) != nullptr ? prefix + name : std::string(name);
    };
    const Eigen::MatrixXd px_from_mm = matrix(block, key("$CCD_INTERIOR_ORIENTATION"), 2, 3);
    const double focal_mm = numbers(block, key("$FOCAL_LENGTH"), 1)[0];
    const std::vector<double> point = block.find(key("$PRINCIPAL_POINT_PPA")) != nullptr
                                          ? numbers(block, key("$PRINCIPAL_POINT_PPA"), 2)
                                          : std::vector{0.0, 0.0};
    Camera camera{id, {}};
    camera.interior.size_px = size_of(block, key("$CCD_COLUMNS"), key("$CCD_ROWS"));
    const Eigen::Matrix2d scale = axes_of(block, px_from_mm.leftCols<2>());
    camera.interior.focal_length_px = focal_mm * scale.diagonal();
    if (!(camera.interior.focal_length_px.minCoeff() > 0.0))
      fail(block.row, "$FOCAL_LENGTH must be positive");
    camera.interior.principal_point_px =
        px_from_mm.leftCols<2>() * Eigen::Vector2d(point[0], point[1]) + px_from_mm.col(2) -
        Eigen::Vector2d::Constant(corner_offset(block, key("$PIXEL_REFERENCE")));
    for (const char* const name : {"$RADIAL_COEFFS", "$DECENTRE_COEFFS"}) {
      require_no_distortion(block, key(name), camera.interior, focal_mm);
    }
    orientation_.cameras.push_back(std::move(camera));
  }

  [[nodiscard]] Eigen::Vector2i size_of(const InphoBlock& block,
                                        const std::string& columns,
                                        const std::string& rows) const {
    constexpr double kMaxSide_px = 1e6;
    const Eigen::Vector2d size(numbers(block, columns, 1)[0], numbers(block, rows, 1)[0]);
    if (size.minCoeff() < 1.0 || size.maxCoeff() > kMaxSide_px)
      fail(block.row, "$CCD_COLUMNS and $CCD_ROWS must be positive");
    return size.cast<int>();
  }

  /// Pixels per millimetre along columns and rows, on the diagonal. Also stores the orientation of
  /// the camera's axes in the image.
  Eigen::Matrix2d axes_of(const InphoBlock& block, const Eigen::Matrix2d& px_from_mm) {
    constexpr double kSkew = 1e-4;  // a pixel in 10,000
    const Eigen::Vector2d px_per_mm = px_from_mm.rowwise().norm();
    if (!(px_per_mm.minCoeff() > 0.0))
      fail(block.row, "$CCD_INTERIOR_ORIENTATION must have rank 2");
    const Eigen::Vector2d up_and_right(1.0, -1.0);  // rows run down
    const Eigen::Matrix2d turn = (up_and_right.cwiseQuotient(px_per_mm)).asDiagonal() * px_from_mm;
    const bool is_turn = (turn * turn.transpose() - Eigen::Matrix2d::Identity()).norm() < kSkew;
    if (!is_turn || turn.determinant() < 0.0) {
      fail(block.row,
           "$CCD_INTERIOR_ORIENTATION is mirrored or skew; rows must run down and the axes "
           "be perpendicular");
    }
    Eigen::Matrix3d ours_from_camera = Eigen::Matrix3d::Identity();
    ours_from_camera.topLeftCorner<2, 2>() = turn;
    ours_from_camera_.push_back(ours_from_camera);
    return px_per_mm.asDiagonal();
  }

  [[nodiscard]] double corner_offset(const InphoBlock& block, const std::string& key) const {
    const std::string reference = block.text(key);
    if (reference.empty() || reference == "CenterTopLeft") return 0.0;
    if (reference == "TopLeft" || reference == "CornerTopLeft") return 0.5;
    fail(block.row,
         "$PIXEL_REFERENCE : " + reference + "; supported are CenterTopLeft and TopLeft");
  }

  /// The file does not state whether the coefficients apply to measured or ideal coordinates, so
  /// their sign is unknown.
  void require_no_distortion(const InphoBlock& block,
                             const std::string& key,
                             const InteriorOrientation& interior,
                             double focal_mm) const {
    const InphoEntry* const entry = block.find(key);
    if (entry == nullptr) return;
    const double r_mm = largest_radius(interior) * focal_mm;
    const double px_per_mm = interior.focal_length_px.maxCoeff() / focal_mm;
    double power = key.ends_with("$RADIAL_COEFFS") ? r_mm : r_mm * r_mm;
    double effect_px = 0.0;
    for (const TextRow& row : entry->rows) {
      for (const double value : to_doubles(words_of(row.text), place(path_, row.number))) {
        effect_px += std::abs(value) * power * px_per_mm;
        power *= r_mm * r_mm;
      }
    }
    if (effect_px <= kLeftOut_px) return;
    fail(entry->row,
         fmt::format(
             "{} moves pixels by up to {:.3g} px, but the file does not define whether it applies "
             "to measured or ideal coordinates; give undistorted images and a camera without it",
             key.substr(key.find('$')), effect_px));
  }

  void require_closed(const InphoBlock& block) const {
    if (!block.is_closed) fail(block.row, block.name + " has no $END; the file is truncated");
  }

  void add_photo(const InphoBlock& block) {
    require_closed(block);
    OrientedImage image;
    image.name = block.text("$PHOTO_FILE");
    if (image.name.empty()) image.name = block.text("$PHOTO_NUM");
    if (block.find("$EXT_ORI") == nullptr) {
      return left_out_.add("photos without $EXT_ORI", image.name);
    }
    if (image.name.empty()) {
      return left_out_.add("photos without a name", fmt::format("row {}", block.row));
    }
    note_fiducials(block, image.name);
    image.camera = camera_number(block);
    add_pose(block, image);
    if (block.find("$TERRAIN_HEIGHT") != nullptr) {
      sum_of_heights_m_ += numbers(block, "$TERRAIN_HEIGHT", 1)[0];
      ++n_heights_;
    }
    orientation_.images.push_back(std::move(image));
  }

  /// Fiducial marks relate the pixels of a scan to the camera; digital cameras have none.
  void note_fiducials(const InphoBlock& block, const std::string& name) {
    const bool has_some = std::ranges::any_of(block.entries, [](const auto& entry) {
      return entry.first.find("FIDUCIAL") != std::string::npos && !entry.second.rows.empty();
    });
    if (has_some) left_out_.add("fiducial marks", name);
  }

  static std::string camera_id_of(const InphoBlock& block) {
    return block.text(block.name == "$CAMERA" ? "$TYPE" : "$ID");
  }

  [[nodiscard]] const InphoBlock& camera_block_of(const InphoBlock& photo) const {
    const std::string id = photo.text("$CAMERA_ID");
    std::vector<const InphoBlock*> cameras;
    for (const InphoBlock& block : blocks_) {
      if (block.name != "$CAMERA" && block.name != "$CAMERA_DEFINITION") continue;
      if (camera_id_of(block) == id) return block;
      cameras.push_back(&block);
    }
    if (cameras.size() == 1 && id.empty()) return *cameras.front();
    fail(photo.row, fmt::format("$CAMERA_ID : {}; the file has no such camera", id));
  }

  /// The camera of a photo; cameras without photos are not read.
  [[nodiscard]] std::size_t camera_number(const InphoBlock& photo) {
    const InphoBlock& block = camera_block_of(photo);
    const auto& cameras = orientation_.cameras;
    const auto camera = std::ranges::find(cameras, camera_id_of(block), &Camera::name);
    const std::size_t number = static_cast<std::size_t>(camera - cameras.begin());
    if (camera == cameras.end()) add_camera(block);
    return number;
  }

  /// Focal length and position, followed by the world-to-camera matrix, row by row.
  void add_pose(const InphoBlock& block, OrientedImage& image) const {
    const InphoEntry& entry = *block.find("$EXT_ORI");
    if (entry.rows.size() < 4)
      fail(entry.row, "$EXT_ORI is truncated; four rows of numbers are needed");
    const std::vector<double> position =
        to_doubles(words_of(entry.rows[0].text), place(path_, entry.rows[0].number));
    if (position.size() != 4) fail(entry.rows[0].number, "focal length, X, Y and Z are needed");
    image.exterior.position_m = {position[1], position[2], position[3]};
    Eigen::Matrix3d camera_from_world;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::vector<double> row =
          to_doubles(words_of(entry.rows[i + 1].text), place(path_, entry.rows[i + 1].number));
      if (row.size() != 3)
        fail(entry.rows[i + 1].number, "a row of the matrix must have three numbers");
      camera_from_world.row(static_cast<Eigen::Index>(i)) =
          Eigen::Map<const Eigen::RowVector3d>(row.data());
    }
    image.exterior.world_from_camera_axes =
        camera_from_world.transpose() * ours_from_camera_[*image.camera].transpose();
  }

  std::string path_, content_;
  std::vector<InphoBlock> blocks_;
  Orientation orientation_;
  std::vector<Eigen::Matrix3d> ours_from_camera_;
  double sum_of_heights_m_ = 0.0;
  int n_heights_ = 0;
  LeftOut left_out_;
};

}  // namespace

Orientation read_inpho(const std::string& path, const OrientationOptions&) {
  return InphoReader(path).read();
}

}  // namespace ridgeline::io
