// SPDX-License-Identifier: BSD-3-Clause
#include "io/project/segments_file.h"

#include "io/error.h"
#include "io/files/atomic_file.h"
#include "io/files/csv_table.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>

namespace ridgeline::io {
namespace {

constexpr std::string_view kGuided = "guided";
constexpr std::string_view kScale = "scale_px";
constexpr std::array<std::string_view, 4> kEndNames{"x1", "y1", "x2", "y2"};

/// Visits the numbers of a segment with their column names. T: EdgeSegment or const EdgeSegment.
template <typename T, typename Visitor>
void for_each_geometry_column(T& s, Visitor&& visit) {
  visit("x1_px", s.line.segment.start.x());
  visit("y1_px", s.line.segment.start.y());
  visit("x2_px", s.line.segment.end.x());
  visit("y2_px", s.line.segment.end.y());
  visit("centroid_x_px", s.line.centroid_px.x());
  visit("centroid_y_px", s.line.centroid_px.y());
  visit("sigma_q_px", s.line.sigma_q_px);
  visit("sigma_phi_rad", s.line.sigma_phi_rad);
  visit("sigma_e_px", s.line.sigma_e_px);
}

template <typename Flank, typename Visitor>
void for_each_flank_column(Flank& flank, const std::string& side, Visitor&& visit) {
  for (std::size_t band = 0; band < flank.colour.size(); ++band) {
    visit(fmt::format("{}_{}", side, band + 1), flank.colour[band]);
  }
  visit(side + "_grey", flank.grey);
}

template <typename T, typename Visitor>
void for_each_appearance_column(T& s, Visitor&& visit) {
  visit("image_x1_px", s.in_image.start.x());
  visit("image_y1_px", s.in_image.start.y());
  visit("image_x2_px", s.in_image.end.x());
  visit("image_y2_px", s.in_image.end.y());
  visit("n_edge_pixels", s.n_edge_pixels);
  visit("rms_px", s.rms_px);
  visit("contrast", s.contrast);
  for_each_flank_column(s.left, "left", visit);
  for_each_flank_column(s.right, "right", visit);
}

/// Covariance of (x1, y1, x2, y2). Along the line, each end moves by its own e with variance
/// sigma_e^2. Across the line, an end at distance t from the centroid moves by q + t phi, where
/// both ends share q and phi.
Eigen::Matrix4d endpoint_covariance(const UncertainSegment2& s) {
  const Eigen::Vector2d u = (s.segment.end - s.segment.start).normalized();
  const Eigen::Vector2d n(-u.y(), u.x());
  Eigen::Matrix<double, 4, 2> along = Eigen::Matrix<double, 4, 2>::Zero();
  along.block<2, 1>(0, 0) = u;
  along.block<2, 1>(2, 1) = u;
  Eigen::Matrix<double, 4, 2> across;
  across << n, n * u.dot(s.segment.start - s.centroid_px), n,
      n * u.dot(s.segment.end - s.centroid_px);
  const Eigen::Vector2d variances(s.sigma_q_px * s.sigma_q_px, s.sigma_phi_rad * s.sigma_phi_rad);
  return s.sigma_e_px * s.sigma_e_px * along * along.transpose() +
         across * variances.asDiagonal() * across.transpose();
}

std::string header() {
  std::string text = "id";
  EdgeSegment any;
  const auto add = [&](const auto& column, const auto&) { text += fmt::format(",{}", column); };
  for_each_geometry_column(any, add);
  for (std::size_t i = 0; i < kEndNames.size(); ++i) {
    for (std::size_t k = i; k < kEndNames.size(); ++k) {
      text += fmt::format(",cov_{}_{}_px2", kEndNames[i], kEndNames[k]);
    }
  }
  for_each_appearance_column(any, add);
  return text + fmt::format(",{},{}\n", kGuided, kScale);
}

std::string row_of(std::size_t id, const EdgeSegment& segment) {
  std::string row = std::to_string(id);
  const auto add = [&](const auto&, const auto& value) { row += fmt::format(",{}", value); };
  for_each_geometry_column(segment, add);
  const Eigen::Matrix4d covariance = endpoint_covariance(segment.line);
  for (int i = 0; i < 4; ++i) {
    for (int k = i; k < 4; ++k) row += fmt::format(",{:.9g}", covariance(i, k));
  }
  for_each_appearance_column(segment, add);
  return row + fmt::format(",{},{}\n", segment.guided ? 1 : 0, segment.scale_px);
}

void check_segment(const EdgeSegment& segment, const std::string& where) {
  if (!(length(segment.line.segment) > 0.0)) throw IoError(where, "start and end are identical");
  const auto positive = [&](std::string_view name, double sigma) {
    if (sigma > 0.0) return;
    throw IoError(where, fmt::format("{} = {}, must be positive", name, sigma));
  };
  positive("sigma_q_px", segment.line.sigma_q_px);
  positive("sigma_phi_rad", segment.line.sigma_phi_rad);
  positive("sigma_e_px", segment.line.sigma_e_px);
  constexpr double kMaxScale_px = 8.0;
  const double scale_px = segment.scale_px;
  if (!(scale_px >= 1.0 && scale_px <= kMaxScale_px && scale_px == std::floor(scale_px))) {
    throw IoError(where, fmt::format("{} = {}, must be a whole number from 1 to {}", kScale,
                                     scale_px, kMaxScale_px));
  }
}

void check_id(const CsvTable& table, std::size_t row) {
  const double id = table.number(row, table.column("id"));
  if (id == static_cast<double>(row)) return;
  throw IoError(table.place_of(row), fmt::format("id = {}, must be {}: ids start at 0", id, row));
}

EdgeSegment segment_of(const CsvTable& table, std::size_t row) {
  check_id(table, row);
  EdgeSegment segment;
  const auto read = [&]<typename T>(const auto& column, T& value) {
    value = static_cast<T>(table.number(row, table.column(column)));
  };
  for_each_geometry_column(segment, read);
  for_each_appearance_column(segment, read);
  segment.guided = table.has(kGuided) && table.number(row, table.column(kGuided)) != 0.0;
  if (table.has(kScale)) segment.scale_px = table.number(row, table.column(kScale));
  check_segment(segment, table.place_of(row));
  return segment;
}

/// An end of a segment. `names`: the columns of its x and y.
Eigen::Vector2d end_of(const CsvTable& table,
                       std::size_t row,
                       const std::array<std::string, 2>& names,
                       const std::optional<Eigen::Vector2i>& size_px) {
  constexpr double kBeyond_px = 5.0;  // detectors extend edges beyond the border of the image
  Eigen::Vector2d end;
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    const std::string& name = names[static_cast<std::size_t>(axis)];
    end[axis] = table.number(row, table.column(name));
    if (!size_px) continue;
    const double most_px = (*size_px)[axis] - 1.0 + kBeyond_px;
    if (end[axis] >= -kBeyond_px && end[axis] <= most_px) continue;
    throw IoError(table.place_of(row),
                  fmt::format("{} = {}, must be in [{}, {}]: the image has {} x {} pixels", name,
                              end[axis], -kBeyond_px, most_px, size_px->x(), size_px->y()));
  }
  return end;
}

EdgeSegment own_segment_of(const CsvTable& table,
                           std::size_t row,
                           double sigma_px,
                           const std::optional<Eigen::Vector2i>& size_px) {
  check_id(table, row);
  const std::string prefix = table.has("image_x1_px") ? "image_" : "";
  const auto optional = [&](std::string_view name, double otherwise) {
    return table.has(name) ? table.number(row, table.column(name)) : otherwise;
  };
  EdgeSegment segment;
  segment.in_image = {end_of(table, row, {prefix + "x1_px", prefix + "y1_px"}, size_px),
                      end_of(table, row, {prefix + "x2_px", prefix + "y2_px"}, size_px)};
  const double sigma = optional("sigma_px", sigma_px);
  if (!(sigma > 0.0)) {
    throw IoError(table.place_of(row), fmt::format("sigma_px = {}, must be positive", sigma));
  }
  segment.line = line_of_ends(segment.in_image, sigma);
  if (!prefix.empty()) {  // a file of write_segments()
    segment.line.sigma_q_px = optional("sigma_q_px", segment.line.sigma_q_px);
    segment.line.sigma_phi_rad = optional("sigma_phi_rad", segment.line.sigma_phi_rad);
    segment.line.sigma_e_px = optional("sigma_e_px", segment.line.sigma_e_px);
  }
  segment.scale_px = optional(kScale, segment.scale_px);
  check_segment(segment, table.place_of(row));
  return segment;
}

}  // namespace

void write_segments(const std::string& path, const std::vector<EdgeSegment>& segments) {
  std::string text = header();
  for (std::size_t id = 0; id < segments.size(); ++id) text += row_of(id, segments[id]);
  write_file(path, text);
}

std::vector<EdgeSegment> read_segments(const std::string& path) {
  const CsvTable table(path, FileGroup::kSegments);
  std::vector<EdgeSegment> segments;
  segments.reserve(table.size());
  for (std::size_t row = 0; row < table.size(); ++row) {
    segments.push_back(segment_of(table, row));
  }
  return segments;
}

std::vector<EdgeSegment> read_own_segments(const std::string& path,
                                           double sigma_px,
                                           const std::optional<Eigen::Vector2i>& size_px) {
  const CsvTable table(path, FileGroup::kSegments);
  std::vector<EdgeSegment> segments;
  segments.reserve(table.size());
  for (std::size_t row = 0; row < table.size(); ++row)
    segments.push_back(own_segment_of(table, row, sigma_px, size_px));
  return segments;
}

}  // namespace ridgeline::io
