// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/part_files.h"

#include "io/files/atomic_file.h"
#include "io/files/sha256.h"
#include "io/files/text_file.h"
#include "io/results/byte_archive.h"
#include "reconstruct/geometry/check.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <type_traits>
#include <vector>

namespace ridgeline::results {

// The fields of each struct, in the order in which they are written and read.

void fields(auto& archive, Some<Segment3> auto& segment) {
  archive(segment.start);
  archive(segment.end);
}

void fields(auto& archive, Some<SegmentPlaneDistance> auto& distance) {
  archive(distance.start);
  archive(distance.end);
  archive(distance.mean_abs);
  archive(distance.mean);
  archive(distance.rms);
  archive(distance.max_abs);
}

void fields(auto& archive, Some<evaluate::JudgingPlane> auto& plane) {
  archive(plane.plane.coeffs());
  archive(plane.n_inliers);
  archive(plane.rms_m);
  archive(plane.coverage);
  archive(plane.extrapolation_m);
  archive(plane.sigma_m);
  archive(plane.sigma_random_m);
  fields(archive, plane.distance);
  archive(plane.id);
}

void fields(auto& archive, Some<evaluate::RidgeDisplacement> auto& displacement) {
  archive(displacement.horizontal_m);
  archive(displacement.vertical_m);
  archive(displacement.covariance_m2);
}

void fields(auto& archive, Some<evaluate::LineEvaluation> auto& line) {
  archive(line.id);
  archive(line.line_class);
  archive(line.building);
  archive(line.status);
  archive(line.reason);
  archive(line.kind);
  archive(line.flags);
  archive(line.planes);
  archive(line.length_m);
  archive(line.epipolar_angle_deg);
  archive(line.n_images);
  archive(line.class_base);
  archive(line.segment);
  archive(line.mean_distance_m);
  archive(line.max_distance_m);
  archive(line.signed_mean_m);
  archive(line.sigma_plane_m);
  archive(line.sigma_line_m);
  archive(line.z);
  archive(line.intersection_distance_m);
  archive(line.intersection_angle_deg);
  archive(line.displacement);
  archive(line.height_if_vertical_m);
}

void fields(auto& archive, Some<evaluate::JudgedResult> auto& result) {
  fields(archive, result.evaluation);
  archive(result.inliers);
  archive.key_lists(result.inlier_keys);
  archive(result.inlier_points);
  archive(result.hulls);
}

void fields(auto& archive, Some<CloudReadings> auto& readings) {
  archive(readings.n_batches);
  archive(readings.n_kept);
  auto& cloud = readings.cloud;
  archive(cloud.frame.origin_m);
  archive(cloud.crs.definition);
  archive(cloud.warnings);
  archive(cloud.horizontal_unit_m);
  archive(cloud.vertical_unit_m);
  archive(cloud.n_read);
  archive(cloud.n_dropped_class);
  archive(cloud.n_dropped_withheld);
  archive(cloud.n_dropped_return);
  archive(cloud.n_dropped_bounds);
  archive(cloud.n_dropped_non_finite);
  archive(cloud.n_dropped_share);
  archive(readings.read_places);
}

void fields(auto& archive, Some<JudgedBatches> auto& part) {
  archive(part.results);
  fields(archive, part.readings);
}

void fields(auto& archive, Some<Segment2> auto& segment) {
  archive(segment.start);
  archive(segment.end);
}

void fields(auto& archive, Some<evaluate::ImageEvidence> auto& images) {
  archive(images.image_from_local);
  archive(images.segments_px);
  archive(images.height_range_m);
}

void fields(auto& archive, Some<evaluate::JudgedLine> auto& line) {
  archive(line.id);
  fields(archive, line.segment);
  archive(line.line_class);
  archive(line.class_base);
  archive(line.building);
  archive(line.epipolar_angle_deg);
  archive(line.covariance_m2);
  archive(line.images);
  archive(line.reconstructed);
  archive(line.confirmed);
  archive(line.n_images);
}

void fields(auto& archive, Some<LinesPart> auto& part) {
  archive(part.frame.origin_m);
  archive(part.plan_scale);
  archive(part.lines);
}

namespace {

/// What a file begins with. The number is written as it lies in memory: a computer with another order of bytes finds no
/// file of its own here.
std::string beginning(const std::string& key) {
  ByteWriter writer;
  writer(std::string("ridgeline part 1"));
  writer(std::uint32_t{0x01020304});
  writer(key);
  return writer.take();
}

constexpr std::size_t kHash_bytes = 64;

std::string hash_of(std::string_view bytes) {
  io::Sha256 digest;
  digest.update(std::as_bytes(std::span(bytes)));
  return digest.hex_digest();
}

/// The content of the file; nothing unless it is whole and of the key.
std::optional<std::string> content_of(const std::string& path, const std::string& key) {
  if (!std::filesystem::is_regular_file(path)) return std::nullopt;
  std::string bytes = io::read_text_file(path);
  const std::string start = beginning(key);
  if (bytes.size() < start.size() + kHash_bytes || !bytes.starts_with(start)) return std::nullopt;
  const std::string hash = bytes.substr(bytes.size() - kHash_bytes);
  bytes.resize(bytes.size() - kHash_bytes);
  if (hash_of(bytes) != hash) return std::nullopt;
  return bytes;
}

template <typename Part>
std::string bytes_of(const Part& part) {
  ByteWriter writer;
  fields(writer, part);
  return writer.take();
}

template <typename Part>
Part part_of(std::string_view bytes) {
  ByteReader reader(bytes);
  Part part;
  fields(reader, part);
  check(reader.at_end(), "part: bytes behind its end, must be none");
  return part;
}

void write_bytes(const std::string& path, const std::string& key, const std::string& part) {
  std::string bytes = beginning(key) + part;
  bytes += hash_of(bytes);
  io::write_file(path, bytes);
}

template <typename Part>
std::optional<Part> read_part(const std::string& path, const std::string& key) {
  const std::optional<std::string> content = content_of(path, key);
  if (!content) return std::nullopt;
  return part_of<Part>(std::string_view(*content).substr(beginning(key).size()));
}

}  // namespace

std::string to_bytes(const LinesPart& part) { return bytes_of(part); }
std::string to_bytes(const JudgedBatches& part) { return bytes_of(part); }
LinesPart lines_part_of(std::string_view bytes) { return part_of<LinesPart>(bytes); }
JudgedBatches judged_part_of(std::string_view bytes) { return part_of<JudgedBatches>(bytes); }

void write_part(const std::string& path, const std::string& key, const LinesPart& part) {
  write_bytes(path, key, to_bytes(part));
}

void write_part(const std::string& path, const std::string& key, const JudgedBatches& part) {
  write_bytes(path, key, to_bytes(part));
}

bool is_part(const std::string& path, const std::string& key) {
  return content_of(path, key).has_value();
}

std::optional<LinesPart> read_lines_part(const std::string& path, const std::string& key) {
  return read_part<LinesPart>(path, key);
}

std::optional<JudgedBatches> read_judged_part(const std::string& path, const std::string& key) {
  return read_part<JudgedBatches>(path, key);
}

}  // namespace ridgeline::results
