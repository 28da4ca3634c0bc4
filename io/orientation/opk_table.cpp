// SPDX-License-Identifier: BSD-3-Clause
#include "io/error.h"
#include "io/orientation/orientation_text.h"
#include "io/orientation/readers.h"
#include "io/orientation/stated_cameras.h"
#include "io/text/table_row.h"
#include "io/text/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>

namespace ridgeline::io {
namespace {

const std::vector<std::string> kUsualColumns{"name",  "x",   "y",     "z",
                                             "omega", "phi", "kappa", "camera"};

/// Refuses a table whose first row names roll and yaw.
void require_known_angles(const std::string& path, const TextRow& row) {
  const std::string text = lower_case(row.text);
  if (text.find("roll") == std::string::npos || text.find("yaw") == std::string::npos) return;
  throw IoError(place(path, row.number),
                "roll, pitch and yaw are angles of the aircraft, and the mounting of the camera is "
                "unknown; give omega, phi and kappa");
}

/// The information before the first row of data.
struct TableHead {
  std::vector<std::string> columns;  ///< empty without a header
  std::string text;  ///< column names and comments in lower case, which may state units
  std::string crs;   ///< from a comment "CoordinateSystem: WKT", as written by Metashape
};

class OpkTable {
 public:
  explicit OpkTable(const std::string& path)
      : path_(path), content_(read_orientation_text(path)), rows_(rows_of(content_)) {
    if (!rows_.empty()) require_known_angles(path_, rows_.front());
    read_head();
  }

  [[nodiscard]] Orientation read() {
    Orientation orientation;
    orientation.format = "table of omega, phi and kappa";
    for (const TextRow& row : rows_) {
      if (!is_comment_row(row.text)) add(row, orientation);
    }
    return orientation;
  }

  [[nodiscard]] const TableHead& head() const { return head_; }
  [[nodiscard]] const std::vector<Angles>& angles() const { return angles_; }
  /// The name of the camera of each image; empty if the table has none.
  [[nodiscard]] const std::vector<std::string>& cameras() const { return cameras_; }

 private:
  /// The header is the first row that names the columns, whether it is a comment or not.
  void read_head() {
    for (auto row = rows_.begin(); row != rows_.end(); ++row) {
      const std::vector<std::string> columns = opk_columns(row->text);
      if (columns.empty() && !is_comment_row(row->text)) break;
      head_.text += lower_case(row->text) + "\n";
      read_crs(row->text);
      if (columns.empty()) continue;
      head_.columns = columns;
      rows_.erase(rows_.begin(), row + 1);
      return;
    }
  }

  void read_crs(std::string_view row) {
    constexpr std::string_view kName = "CoordinateSystem:";
    const std::size_t at = row.find(kName);
    if (at != std::string_view::npos) head_.crs = trimmed(row.substr(at + kName.size()));
  }

  [[nodiscard]] const std::vector<std::string>& columns() const {
    return head_.columns.empty() ? kUsualColumns : head_.columns;
  }

  /// The fields of a row. An unquoted name with blanks in the first column is reassembled.
  [[nodiscard]] std::vector<std::string> fields_of(const TextRow& row, const std::string& where) {
    const char separator = separator_of(row.text);
    std::vector<std::string> fields = table_fields(row.text, separator);
    const std::size_t fewest = head_.columns.empty() ? 7 : head_.columns.size();
    const bool name_is_first = columns().front() == "name";
    while (separator == ' ' && name_is_first && fields.size() > fewest &&
           !table_number(fields[1])) {
      fields[0] += " " + fields[1];
      fields.erase(fields.begin() + 1);
    }
    const bool camera_is_missing =
        !head_.columns.empty() && fields.size() + 1 == fewest && head_.columns.back() == "camera";
    if (fields.size() < fewest && !camera_is_missing) {
      throw IoError(
          where,
          fmt::format(
              "{} fields; name, x, y, z, omega, phi and kappa are needed{}", fields.size(),
              head_.columns.empty() ? "" : fmt::format(" in {} columns", head_.columns.size())));
    }
    return fields;
  }

  [[nodiscard]] double number(const std::vector<std::string>& fields,
                              const char* column,
                              const std::string& where) const {
    const std::string& text = fields[place_of(column)];
    const std::optional<double> value = table_number(text);
    if (!value || !std::isfinite(*value)) {
      throw IoError(where, fmt::format("{} = {}; must be a finite number without thousands "
                                       "separators",
                                       column, text));
    }
    return *value;
  }

  [[nodiscard]] std::size_t place_of(const char* column) const {
    return static_cast<std::size_t>(std::ranges::find(columns(), column) - columns().begin());
  }

  void add(const TextRow& row, Orientation& orientation) {
    const std::string where = place(path_, row.number);
    const std::vector<std::string> fields = fields_of(row, where);
    const auto value = [&](const char* column) { return number(fields, column, where); };
    OrientedImage image;
    const std::size_t name = place_of("name");
    image.name = fields[name < columns().size() ? name : 0];
    image.exterior.position_m = {value("x"), value("y"), value("z")};
    angles_.push_back({value("omega"), value("phi"), value("kappa")});
    const std::size_t camera = place_of("camera");
    cameras_.push_back(camera < fields.size() ? fields[camera] : "");
    orientation.images.push_back(std::move(image));
  }

  std::string path_, content_;
  std::vector<TextRow> rows_;
  TableHead head_;
  std::vector<Angles> angles_;
  std::vector<std::string> cameras_;
};

/// The unit stated by the column names or a comment.
std::optional<AngleUnit> stated_unit(const std::string& text) {
  const auto says = [&](std::string_view word) { return text.find(word) != std::string::npos; };
  constexpr std::array kGonWords{"gon]",  "gon)",  "_gon", "grad]",
                                 "grad)", "_grad", "gons", "grads"};
  constexpr std::array kDegreeWords{"deg]", "deg)", "_deg", "degree", "\xC2\xB0"};
  constexpr std::array kRadianWords{"rad]", "rad)", "_rad", "radian"};
  if (std::ranges::any_of(kGonWords, says)) return AngleUnit::kGon;
  if (std::ranges::any_of(kDegreeWords, says)) return AngleUnit::kDegree;
  if (std::ranges::any_of(kRadianWords, says)) return AngleUnit::kRadian;
  return std::nullopt;
}

const char* angle_unit_name(AngleUnit unit) {
  if (unit == AngleUnit::kDegree) return "deg";
  return unit == AngleUnit::kGon ? "gon" : "rad";
}

/// The rotation orders compatible with the file and the user's options. Columns in the order omega,
/// phi, kappa imply that order.
std::vector<RotationOrder> possible_orders(const TableHead& head,
                                           const OrientationOptions& options) {
  if (options.rotation) return {*options.rotation};
  const auto place_of = [&](const char* name) { return std::ranges::find(head.columns, name); };
  if (place_of("phi") < place_of("omega")) {
    return {RotationOrder::kPhiOmegaKappa, RotationOrder::kOmegaPhiKappa};
  }
  return {RotationOrder::kOmegaPhiKappa};
}

std::vector<AngleUnit> open_units(const OpkTable& table,
                                  const OrientationOptions& options,
                                  Orientation& orientation) {
  if (options.angles) return {*options.angles};
  if (const std::optional<AngleUnit> unit = stated_unit(table.head().text)) {
    orientation.decisions.push_back(
        fmt::format("Angles are in {} (stated in the table).", angle_unit_name(*unit)));
    return {*unit};
  }
  return possible_units(table.angles());
}

std::vector<RotationReading> readings_of(const OpkTable& table,
                                         const OrientationOptions& options,
                                         Orientation& orientation) {
  const std::vector<RotationOrder> orders = possible_orders(table.head(), options);
  std::vector<RotationReading> readings;
  for (const AngleUnit unit : open_units(table, options, orientation)) {
    for (const RotationOrder order : orders) {
      const char* const order_name = order == RotationOrder::kOmegaPhiKappa ? "opk" : "pok";
      const std::string named = fmt::format("rotation: {}", order_name);
      RotationReading reading{fmt::format("angles in {}", angle_unit_name(unit)),
                              fmt::format("angles: {}", angle_unit_name(unit)),
                              {}};
      if (orders.size() > 1) {
        reading.what += " and " + named;
        reading.option += ", " + named;
      }
      for (const Angles& a : table.angles()) {
        reading.world_from_camera_axes.push_back(rotation_of(a, unit, order));
      }
      readings.push_back(std::move(reading));
    }
  }
  return readings;
}

}  // namespace

Orientation read_opk_table(const std::string& path, const OrientationOptions& options) {
  OpkTable table(path);
  Orientation orientation = table.read();
  if (orientation.images.empty()) return orientation;
  const std::filesystem::path beside = std::filesystem::path(path).replace_extension(".prj");
  const std::string& stated = table.head().crs;
  orientation.crs.definition =
      stated.empty() ? text_beside(path, beside.filename().string(), orientation) : stated;
  add_stated_cameras(path, options, table.cameras(), orientation);
  std::vector<RotationReading> readings = readings_of(table, options, orientation);
  if (readings.empty()) {
    throw IoError(path, "has angles of more than a full turn in any unit; check the columns");
  }
  decide_rotations(path, readings, options.find_observations, orientation);
  return orientation;
}

}  // namespace ridgeline::io
