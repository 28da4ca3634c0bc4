// SPDX-License-Identifier: BSD-3-Clause
#include "io/error.h"
#include "io/orientation/orientation_text.h"
#include "io/orientation/readers.h"
#include "io/orientation/stated_cameras.h"
#include "io/text/pat_b_record.h"
#include "io/text/text.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>

#include <array>

namespace ridgeline::io {
namespace {

/// Each image has three records: number and position, then five and four elements of the matrix,
/// row by row.
constexpr std::size_t kRecords = 3;

class PatBReader {
 public:
  explicit PatBReader(std::string path)
      : path_(std::move(path)), content_(read_orientation_text(path_)), rows_(rows_of(content_)) {}

  [[nodiscard]] Orientation read() {
    Orientation orientation;
    orientation.format = "PAT-B orientation";
    for (std::size_t row = 0; row < rows_.size() && !is_end(row); row += kRecords) {
      if (rows_.size() - row < kRecords) {
        throw IoError(place(path_, rows_[row].number), "is truncated; an image has three records");
      }
      orientation.images.push_back(image_at(row));
      matrices_.push_back(matrix_at(row));
    }
    return orientation;
  }

  [[nodiscard]] const std::vector<Eigen::Matrix3d>& matrices() const { return matrices_; }

 private:
  /// Some programs end the file with -99.
  [[nodiscard]] bool is_end(std::size_t row) const {
    return row + 1 == rows_.size() && trimmed(rows_[row].text) == "-99";
  }

  /// Some programs write the focal length between the number and the position.
  [[nodiscard]] OrientedImage image_at(std::size_t row) const {
    const std::string where = place(path_, rows_[row].number);
    const std::vector<std::string_view> words = pat_b_words(rows_[row].text, 4);
    if (words.size() < 4) throw IoError(where, "the number of an image, X, Y and Z are expected");
    const std::vector<double> position = numbers_of({words.end() - 3, words.end()}, where);
    OrientedImage image;
    image.name = std::string(words.front());
    image.exterior.position_m = {position[0], position[1], position[2]};
    return image;
  }

  static std::vector<double> numbers_of(const std::vector<std::string_view>& words,
                                        const std::string& where) {
    return transformed(words, [&](std::string_view word) {
      const std::optional<double> number = fortran_number(word);
      if (!number) throw IoError(where, fmt::format("'{}' is not a number", word.substr(0, 40)));
      return *number;
    });
  }

  [[nodiscard]] Eigen::Matrix3d matrix_at(std::size_t row) const {
    std::vector<double> elements;
    for (const std::size_t record : {1U, 2U}) {
      const TextRow& text = rows_[row + record];
      const std::string where = place(path_, text.number);
      const std::size_t expected = record == 1 ? 5 : 4;
      const std::vector<double> numbers = numbers_of(pat_b_words(text.text, expected), where);
      if (numbers.size() != expected) {
        throw IoError(where, fmt::format("{} elements of the matrix; this record has {}",
                                         numbers.size(), expected));
      }
      elements.insert(elements.end(), numbers.begin(), numbers.end());
    }
    return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(elements.data());
  }

  std::string path_, content_;
  std::vector<TextRow> rows_;
  std::vector<Eigen::Matrix3d> matrices_;
};

}  // namespace

Orientation read_pat_b(const std::string& path, const OrientationOptions& options) {
  PatBReader reader(path);
  Orientation orientation = reader.read();
  if (orientation.images.empty()) return orientation;
  const auto names = transformed(orientation.images, &OrientedImage::name);
  // if there are several cameras, each is named after its image
  add_stated_cameras(path, options, names, orientation);
  std::vector<RotationReading> readings;
  if (options.matrix.value_or(MatrixDirection::kWorldFromCamera) ==
      MatrixDirection::kWorldFromCamera) {
    readings.push_back(
        {"the matrix is world_from_camera", "matrix: world_from_camera", reader.matrices()});
  }
  if (options.matrix.value_or(MatrixDirection::kCameraFromWorld) ==
      MatrixDirection::kCameraFromWorld) {
    RotationReading reading{"the matrix is camera_from_world", "matrix: camera_from_world", {}};
    for (const Eigen::Matrix3d& M : reader.matrices()) {
      reading.world_from_camera_axes.emplace_back(M.transpose());
    }
    readings.push_back(std::move(reading));
  }
  decide_rotations(path, readings, options.find_observations, orientation);
  return orientation;
}

}  // namespace ridgeline::io
