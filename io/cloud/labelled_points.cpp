// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/labelled_points.h"

#include "io/files/atomic_file.h"
#include "reconstruct/geometry/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string_view>

namespace ridgeline::io {
namespace {

constexpr std::string_view kPlyStart =
    "ply\nformat binary_little_endian 1.0\ncomment points of LIDAR planes\n";
constexpr std::string_view kPcdStart = "# .PCD v0.7 - points of LIDAR planes\n";

std::string extension_of(const std::string& path) {
  return std::filesystem::path(path).extension().string();
}

template <typename T>
void append(T value, std::string& bytes) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string one_line(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

void write_as_las(const std::string& path, const LabelledPoints& points) {
  std::vector<CloudPoint> records;
  records.reserve(points.x_in_local.size());
  for (const Eigen::Vector3d& x_m : points.x_in_local) {
    records.push_back(single_return(x_m.cwiseQuotient(points.unit_m)));
  }
  const LocalFrame frame{points.frame.origin_m.cwiseQuotient(points.unit_m)};
  write_las(path, records, frame, points.crs, {}, points.labels);
}

std::string ply_bytes(const LabelledPoints& points) {
  std::string bytes(kPlyStart);
  if (points.crs.known()) bytes += "comment crs " + one_line(points.crs.definition) + "\n";
  bytes += fmt::format(
      "element vertex {}\nproperty double x\nproperty double y\nproperty double z\nproperty uchar "
      "red\nproperty uchar green\nproperty uchar blue\nproperty uint plane_id\nproperty float "
      "distance_m\nend_header\n",
      points.x_in_local.size());
  for (std::size_t i = 0; i < points.x_in_local.size(); ++i) {
    const PointLabel& label = points.labels[i];
    const Eigen::Vector3d x =
        points.frame.world_from_local(points.x_in_local[i]).cwiseQuotient(points.unit_m);
    for (const double coordinate : x) append(coordinate, bytes);
    for (const std::uint8_t part : label.rgb) append(part, bytes);
    append(label.plane_id, bytes);
    append(label.distance_m, bytes);
  }
  return bytes;
}

std::string pcd_bytes(const LabelledPoints& points) {
  const Eigen::Vector3d& origin = points.frame.origin_m;
  std::string bytes(kPcdStart);
  if (points.crs.known()) bytes += "# crs " + one_line(points.crs.definition) + "\n";
  bytes += fmt::format(
      "# origin {:.0f} {:.0f} {:.0f} m, to be added to the coordinates\nVERSION 0.7\nFIELDS x y z "
      "rgb "
      "plane_id distance_m\nSIZE 4 4 4 4 4 4\nTYPE F F F U U F\nCOUNT 1 1 1 1 1 1\nWIDTH "
      "{}\nHEIGHT "
      "1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {}\nDATA binary\n",
      origin.x(), origin.y(), origin.z(), points.x_in_local.size(), points.x_in_local.size());
  for (std::size_t i = 0; i < points.x_in_local.size(); ++i) {
    const PointLabel& label = points.labels[i];
    for (const double coordinate : points.x_in_local[i])
      append(static_cast<float>(coordinate), bytes);
    append(static_cast<std::uint32_t>(label.rgb[0] << 16U | label.rgb[1] << 8U | label.rgb[2]),
           bytes);
    append(label.plane_id, bytes);
    append(label.distance_m, bytes);
  }
  return bytes;
}

}  // namespace

void require_point_format(const std::string& path) {
  const std::string extension = extension_of(path);
  check(extension == ".las" || extension == ".pcd" || extension == ".ply", "points file ", path,
        ", must end in .las, .pcd or .ply");
}

void write_labelled_points(const std::string& path, const LabelledPoints& points) {
  require_point_format(path);
  check(points.labels.size() == points.x_in_local.size(),
        "write_labelled_points: ", points.labels.size(), " labels for ", points.x_in_local.size(),
        " points");
  const std::string extension = extension_of(path);
  if (extension == ".las") return write_as_las(path, points);
  write_file(path, extension == ".ply" ? ply_bytes(points) : pcd_bytes(points));
}

}  // namespace ridgeline::io
