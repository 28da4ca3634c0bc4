// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/attributes.h"

#include "io/error.h"
#include "io/lines/json_text.h"
#include "io/lines/text.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace ridgeline::io {
namespace {

using nlohmann::json;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

constexpr std::array kTextAttributes{TextAttribute{"id", &Line::id},
                                     TextAttribute{"parent_id", &Line::parent_id},
                                     TextAttribute{"class", &Line::line_class},
                                     TextAttribute{"method", &Line::method},
                                     TextAttribute{"kind", &Line::kind},
                                     TextAttribute{"building", &Line::building},
                                     TextAttribute{"status", &Line::status},
                                     TextAttribute{"left_id", &Line::left_id},
                                     TextAttribute{"right_id", &Line::right_id}};

constexpr std::array kSegmentAttributes{SegmentAttribute{"left_px", &Line::left_px},
                                        SegmentAttribute{"right_px", &Line::right_px}};

constexpr std::array kNumberAttributes{NumberAttribute{"visible_left", &Line::visible_left},
                                       NumberAttribute{"visible_right", &Line::visible_right}};

bool is_empty(const json& value) {
  return value.is_null() || (value.is_string() && value.get_ref<const std::string&>().empty());
}

/// A value that may be wrapped in text.
json unwrapped(const json& value) {
  if (!value.is_string()) return value;
  const std::string& text = value.get_ref<const std::string&>();
  if (!is_shallow_json(text)) return value;
  const json inner = json::parse(text, nullptr, false);
  return inner.is_discarded() ? value : inner;
}

[[noreturn]] void refuse(const std::string& where,
                         std::string_view name,
                         const json& value,
                         std::string_view rule) {
  throw IoError(where, fmt::format("{} = {}; must be {}", name, excerpt(value), rule));
}

double number_of(const json& value, std::string_view name, const std::string& where) {
  if (value.is_number()) return value.get<double>();
  if (value.is_string()) {
    const std::optional<double> number = to_double(value.get_ref<const std::string&>());
    if (number) return *number;
  }
  refuse(where, name, value, "a number");
}

int integer_of(const json& value, std::string_view name, const std::string& where) {
  const double number = number_of(value, name, where);
  const bool fits =
      std::floor(number) == number && std::abs(number) <= std::numeric_limits<int>::max();
  if (!fits) refuse(where, name, value, "an integer");
  return static_cast<int>(number);
}

void flatten(const json& value,
             std::string_view name,
             const std::string& where,
             std::vector<double>& numbers) {
  if (!value.is_array()) return numbers.push_back(number_of(value, name, where));
  for (const json& element : value) flatten(element, name, where, numbers);
}

std::vector<double> numbers_of(const json& value,
                               std::string_view name,
                               std::size_t count,
                               const std::string& where) {
  std::vector<double> numbers;
  flatten(unwrapped(value), name, where, numbers);
  if (numbers.size() != count) refuse(where, name, value, fmt::format("{} numbers", count));
  return numbers;
}

Matrix6d covariance_of(const json& value, const std::string& where) {
  const std::vector<double> numbers = numbers_of(value, "covariance", 36, where);
  return Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>>(numbers.data());
}

Matrix6d covariance_of_sigmas(const json& start, const json& end, const std::string& where) {
  Eigen::Matrix<double, 6, 1> sigma_m;
  const std::vector<double> first = numbers_of(start, "sigma_start_m", 3, where);
  const std::vector<double> second = numbers_of(end, "sigma_end_m", 3, where);
  sigma_m << first[0], first[1], first[2], second[0], second[1], second[2];
  return sigma_m.cwiseAbs2().asDiagonal();
}

std::vector<int> plane_ids_of(const json& value, const std::string& where) {
  const json ids = unwrapped(value);
  if (!ids.is_array()) return {integer_of(ids, "plane_ids", where)};
  std::vector<int> planes;
  for (const json& id : ids) planes.push_back(integer_of(id, "plane_ids", where));
  return planes;
}

Segment2 segment_of(const json& value, std::string_view name, const std::string& where) {
  const std::vector<double> ends = numbers_of(value, name, 4, where);
  return {{ends[0], ends[1]}, {ends[2], ends[3]}};
}

json with_lower_case_names(const json& properties) {
  json lower = json::object();
  for (const auto& [name, value] : properties.items()) {
    if (!is_empty(value)) lower[lower_case(name)] = value;
  }
  // The name that fits the ten characters of a Shapefile's column.
  if (lower.contains("epi_deg")) lower.emplace("epipolar_angle_deg", lower["epi_deg"]);
  return lower;
}

}  // namespace

std::span<const TextAttribute> text_attributes() { return kTextAttributes; }

std::span<const SegmentAttribute> segment_attributes() { return kSegmentAttributes; }

std::span<const NumberAttribute> number_attributes() { return kNumberAttributes; }

std::string segment_text(const Segment2& segment_px) {
  return fmt::format("[{:.4f},{:.4f},{:.4f},{:.4f}]", segment_px.start.x(), segment_px.start.y(),
                     segment_px.end.x(), segment_px.end.y());
}

std::string text_of(const json& value) {
  if (value.is_null()) return {};
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_number_float()) return json_text(value);
  const double number = value.get<double>();
  const bool integer = std::floor(number) == number && std::abs(number) < 1e15;
  return integer ? fmt::format("{:.0f}", number) : fmt::format("{}", number);
}

Line line_from_properties(const json& properties, const std::string& where) {
  Line line;
  if (!properties.is_object()) return line;
  const json values = with_lower_case_names(properties);
  for (const TextAttribute& attribute : kTextAttributes) {
    if (values.contains(attribute.name)) line.*attribute.member = text_of(values[attribute.name]);
  }
  if (const auto it = values.find("epipolar_angle_deg"); it != values.end()) {
    line.epipolar_angle_deg = number_of(*it, "epipolar_angle_deg", where);
  }
  if (const auto it = values.find("n_points"); it != values.end()) {
    line.n_points = integer_of(*it, "n_points", where);
  }
  if (const auto it = values.find("n_images"); it != values.end()) {
    line.n_images = integer_of(*it, "n_images", where);
  }
  if (const auto it = values.find("plane_ids"); it != values.end()) {
    line.plane_ids = plane_ids_of(*it, where);
  }
  for (const NumberAttribute& attribute : kNumberAttributes) {
    if (!values.contains(attribute.name)) continue;
    line.*attribute.member = number_of(values[attribute.name], attribute.name, where);
  }
  for (const SegmentAttribute& attribute : kSegmentAttributes) {
    if (!values.contains(attribute.name)) continue;
    line.*attribute.member = segment_of(values[attribute.name], attribute.name, where);
  }
  if (values.contains("covariance")) {
    line.covariance_m2 = covariance_of(values["covariance"], where);
  } else if (values.contains("sigma_start_m") && values.contains("sigma_end_m")) {
    line.covariance_m2 =
        covariance_of_sigmas(values["sigma_start_m"], values["sigma_end_m"], where);
  }
  return line;
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
