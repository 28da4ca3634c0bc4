// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/attributes.h"

#include "io/error.h"
#include "io/text/json_text.h"
#include "io/text/text.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace ridgeline::io {
namespace {

using nlohmann::json;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

constexpr std::array kTextAttributes{TextAttribute{"id", &Line::id},
                                     TextAttribute{"parent_id", &Line::parent_id},
                                     TextAttribute{"class", &Line::line_class},
                                     TextAttribute{"class_base", &Line::class_base},
                                     TextAttribute{"method", &Line::method},
                                     TextAttribute{"kind", &Line::kind},
                                     TextAttribute{"building", &Line::building},
                                     TextAttribute{"status", &Line::status},
                                     TextAttribute{"left_id", &Line::base_id},
                                     TextAttribute{"right_id", &Line::other_id}};

constexpr std::array kSegmentAttributes{SegmentAttribute{"left_px", &Line::base_px},
                                        SegmentAttribute{"right_px", &Line::other_px}};

constexpr std::array kNumberAttributes{NumberAttribute{"visible_left", &Line::visible_base},
                                       NumberAttribute{"visible_right", &Line::visible_other},
                                       NumberAttribute{"support", &Line::support},
                                       NumberAttribute{"moved_out_m", &Line::moved_out_m}};

bool is_empty(const json& value) {
  return value.is_null() || (value.is_string() && value.get_ref<const std::string&>().empty());
}

/// The value itself if it is JSON wrapped in text.
json unwrapped(const json& value) {
  if (!value.is_string()) return value;
  const std::string& text = value.get_ref<const std::string&>();
  if (!is_shallow_json(text)) return value;
  const json inner = json::parse(text, nullptr, false);
  return inner.is_discarded() ? value : inner;
}

/// Thrown for a value whose shape differs from ours and which therefore belongs to another tool's
/// column.
struct OtherShape {
  std::string rule;  ///< shape that our values have
};

double number_of(const json& value) {
  if (value.is_number()) return value.get<double>();
  if (value.is_string()) {
    const std::optional<double> number = to_double(value.get_ref<const std::string&>());
    if (number) return *number;
  }
  throw OtherShape{"a number"};
}

int integer_of(const json& value) {
  const double number = number_of(value);
  const bool fits =
      std::floor(number) == number && std::abs(number) <= std::numeric_limits<int>::max();
  if (!fits) throw OtherShape{"an integer"};
  return static_cast<int>(number);
}

void flatten(const json& value, std::vector<double>& numbers) {
  if (!value.is_array()) return numbers.push_back(number_of(value));
  for (const json& element : value) flatten(element, numbers);
}

std::vector<double> numbers_of(const json& value, std::size_t count) {
  std::vector<double> numbers;
  try {
    flatten(unwrapped(value), numbers);
  } catch (const OtherShape&) {
    numbers.clear();
  }
  if (numbers.size() != count) throw OtherShape{fmt::format("{} numbers", count)};
  return numbers;
}

Matrix6d covariance_of(const json& value) {
  const std::vector<double> numbers = numbers_of(value, 36);
  return Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>>(numbers.data());
}

std::vector<int> plane_ids_of(const json& value) {
  const json ids = unwrapped(value);
  if (!ids.is_array()) return {integer_of(ids)};
  return transformed(ids, [&](const json& id) { return integer_of(id); });
}

Segment2 segment_of(const json& value) {
  const std::vector<double> ends = numbers_of(value, 4);
  return {{ends[0], ends[1]}, {ends[2], ends[3]}};
}

std::vector<LineObservation> observations_of(const json& value) {
  constexpr const char* kRule = "must be a list of [\"IMAGE\", x1, y1, x2, y2]";
  const json list = unwrapped(value);
  if (!list.is_array()) throw OtherShape{kRule};
  return transformed(list, [&](const json& observation) {
    if (!observation.is_array() || observation.size() != 5 || !observation[0].is_string())
      throw OtherShape{kRule};
    return LineObservation{observation[0].get<std::string>(),
                           segment_of(json(observation.begin() + 1, observation.end()))};
  });
}

json with_lower_case_names(const json& properties) {
  json lower = json::object();
  for (const auto& [name, value] : properties.items()) {
    if (!is_empty(value)) lower[lower_case(name)] = value;
  }
  // The name epi_deg fits into the ten characters of a Shapefile column name.
  if (lower.contains("epi_deg")) lower.emplace("epipolar_angle_deg", lower["epi_deg"]);
  return lower;
}

void clear_attribute(std::string_view name, Line& line) {
  if (name == "epipolar_angle_deg") line.epipolar_angle_deg.reset();
  if (name == "n_points") line.n_points.reset();
  if (name == "n_images") line.n_images.reset();
  if (name == "plane_ids") line.plane_ids.clear();
  if (name == "observations") line.observations.clear();
  if (name == "covariance" || name.starts_with("sigma_")) line.covariance_m2.reset();
  for (const NumberAttribute& attribute : kNumberAttributes) {
    if (name == attribute.name) (line.*attribute.member).reset();
  }
  for (const SegmentAttribute& attribute : kSegmentAttributes) {
    if (name == attribute.name) (line.*attribute.member).reset();
  }
}

/// The location without the path, with which warnings already begin: "feature 3" of "lines.geojson:
/// feature 3", "row 4" of "lines.csv:4".
std::string place_in_file(std::string_view where, std::string_view path) {
  if (where.starts_with(path)) where.remove_prefix(path.size());
  if (where.starts_with(": ")) return std::string(where.substr(2));
  return where.starts_with(':') ? fmt::format("row {}", where.substr(1)) : std::string(where);
}

/// Throws IoError for a value of our shape that no line can have, because the file is then faulty.
void check_covariance(const Matrix6d& covariance_m2,
                      const std::string& id,
                      const std::string& where) {
  for (int i = 0; i < 6; ++i) {
    if (covariance_m2(i, i) >= 0.0 && covariance_m2.row(i).allFinite()) continue;
    throw IoError(
        where,
        fmt::format(
            "covariance{}: the variance is {} m2 for the {}'s {}; must be finite and at least 0",
            id.empty() ? "" : fmt::format(" of line {}", id), covariance_m2(i, i),
            i < 3 ? "start" : "end", "xyz"[i % 3]));
  }
}

}  // namespace

std::span<const TextAttribute> text_attributes() { return kTextAttributes; }

std::span<const SegmentAttribute> segment_attributes() { return kSegmentAttributes; }

std::span<const NumberAttribute> number_attributes() { return kNumberAttributes; }

std::string segment_text(const Segment2& segment_px) {
  return fmt::format("[{:.4f},{:.4f},{:.4f},{:.4f}]", segment_px.start.x(), segment_px.start.y(),
                     segment_px.end.x(), segment_px.end.y());
}

std::string observations_text(const std::vector<LineObservation>& observations) {
  return fmt::format("[{}]", fmt::join(transformed(observations,
                                                   [](const LineObservation& s) {
                                                     return fmt::format(
                                                         "[{},{}", json_text(s.image),
                                                         segment_text(s.px).substr(1));
                                                   }),
                                       ","));
}

std::string text_of(const json& value) {
  if (value.is_null()) return {};
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_number_float()) return json_text(value);
  const double number = value.get<double>();
  const bool integer = std::floor(number) == number && std::abs(number) < 1e15;
  return integer ? fmt::format("{:.0f}", number) : fmt::format("{}", number);
}

template <typename Take>
void AttributeReader::take(const json& values,
                           std::string_view name,
                           const std::string& where,
                           const Take& take_value) {
  const auto it = values.find(name);
  if (it == values.end()) return;
  try {
    take_value(*it);
  } catch (const OtherShape& other) {
    Misfit& misfit = misfits_[std::string(name)];
    if (misfit.n_values++ > 0) return;
    misfit.first = excerpt(*it);
    misfit.where = where;
    misfit.rule = other.rule;
  }
}

Line AttributeReader::line_of(const json& properties, const std::string& where) {
  Line line;
  if (!properties.is_object()) return line;
  const json values = with_lower_case_names(properties);
  for (const TextAttribute& attribute : kTextAttributes) {
    if (values.contains(attribute.name)) line.*attribute.member = text_of(values[attribute.name]);
  }
  take(values, "epipolar_angle_deg", where,
       [&](const json& value) { line.epipolar_angle_deg = number_of(value); });
  take(values, "n_points", where, [&](const json& value) { line.n_points = integer_of(value); });
  take(values, "n_images", where, [&](const json& value) { line.n_images = integer_of(value); });
  take(values, "plane_ids", where,
       [&](const json& value) { line.plane_ids = plane_ids_of(value); });
  take(values, "observations", where,
       [&](const json& value) { line.observations = observations_of(value); });
  for (const NumberAttribute& attribute : kNumberAttributes) {
    take(values, attribute.name, where,
         [&](const json& value) { line.*attribute.member = number_of(value); });
  }
  for (const SegmentAttribute& attribute : kSegmentAttributes) {
    take(values, attribute.name, where,
         [&](const json& value) { line.*attribute.member = segment_of(value); });
  }
  take_covariance(values, where, line);
  return line;
}

void AttributeReader::take_covariance(const json& values, const std::string& where, Line& line) {
  if (values.contains("covariance")) {
    take(values, "covariance", where,
         [&](const json& value) { line.covariance_m2 = covariance_of(value); });
  } else if (values.contains("sigma_start_m") && values.contains("sigma_end_m")) {
    Eigen::Matrix<double, 6, 1> sigma_m;
    bool is_whole = true;
    for (const auto& [name, first] : {std::pair{"sigma_start_m", 0}, std::pair{"sigma_end_m", 3}}) {
      sigma_m.segment<3>(first).setConstant(-1.0);
      take(values, name, where, [&, first = first](const json& value) {
        const std::vector<double> numbers = numbers_of(value, 3);
        sigma_m.segment<3>(first) = Eigen::Map<const Eigen::Vector3d>(numbers.data());
      });
      is_whole = is_whole && !misfits_.contains(name);
    }
    if (!is_whole) return;
    // The sign is kept because the squares of negative sigmas would pass for variances.
    line.covariance_m2 = sigma_m.cwiseProduct(sigma_m.cwiseAbs()).asDiagonal();
  }
  if (line.covariance_m2) check_covariance(*line.covariance_m2, line.id, where);
}

void AttributeReader::finish(LineSet& set) const {
  for (const auto& [name, misfit] : misfits_) {
    for (Line& line : set.lines) clear_attribute(name, line);
    set.warnings.push_back(fmt::format(
        "column {} has another meaning in this file and is ignored: {} in {}{} must be {}", name,
        misfit.first, place_in_file(misfit.where, set.path),
        misfit.n_values > 1 ? fmt::format(" and {} more", misfit.n_values - 1) : "", misfit.rule));
  }
}

std::string covariance_text(const Matrix6d& covariance_m2) {
  std::string text = "[";
  for (int row = 0; row < 6; ++row) {
    text += row == 0 ? "[" : ",[";
    for (int col = 0; col < 6; ++col) {
      text += fmt::format("{}{:.5e}", col == 0 ? "" : ",", covariance_m2(row, col));
    }
    text += "]";
  }
  return text + "]";
}

}  // namespace ridgeline::io
