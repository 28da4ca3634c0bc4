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

// The fields of each struct. The bindings name all of them, so that a field that is added does not
// compile until it is written, too.

void fields(auto& archive, Some<Segment2> auto& segment) {
  auto& [start, end] = segment;
  all(archive, start, end);
}

void fields(auto& archive, Some<Segment3> auto& segment) {
  auto& [start, end] = segment;
  all(archive, start, end);
}

void fields(auto& archive, Some<LocalFrame> auto& frame) {
  auto& [origin_m] = frame;
  all(archive, origin_m);
}

void fields(auto& archive, Some<SegmentPlaneDistance> auto& distance) {
  auto& [start, end, mean_abs, mean, rms, max_abs] = distance;
  all(archive, start, end, mean_abs, mean, rms, max_abs);
}

void fields(auto& archive, Some<evaluate::JudgingPlane> auto& judging) {
  auto& [plane, n_inliers, rms_m, coverage, extrapolation_m, sigma_m, sigma_random_m, distance, id,
         sample] = judging;
  all(archive, plane.coeffs(), n_inliers, rms_m, coverage, extrapolation_m, sigma_m, sigma_random_m,
      distance, id, sample);
}

void fields(auto& archive, Some<evaluate::RidgeDisplacement> auto& displacement) {
  auto& [horizontal_m, vertical_m, covariance_m2] = displacement;
  all(archive, horizontal_m, vertical_m, covariance_m2);
}

void fields(auto& archive, Some<evaluate::LineEvaluation> auto& line) {
  auto& [id, line_class, building, status, reason, kind, flags, planes, surface, surface_other,
         surface_probability, decided_by, length_m, epipolar_angle_deg, n_images, class_base,
         segment, mean_distance_m, max_distance_m, signed_mean_m, sigma_plane_m, sigma_line_m, z,
         intersection_distance_m, intersection_angle_deg, displacement, height_if_vertical_m] =
      line;
  all(archive, id, line_class, building, status, reason, kind, flags, planes, surface,
      surface_other, surface_probability, decided_by, length_m, epipolar_angle_deg, n_images,
      class_base, segment, mean_distance_m, max_distance_m, signed_mean_m, sigma_plane_m,
      sigma_line_m, z, intersection_distance_m, intersection_angle_deg, displacement,
      height_if_vertical_m);
}

void fields(auto& archive, Some<evaluate::JudgedResult> auto& result) {
  auto& [evaluation, inliers, inlier_keys, inlier_points, hulls] = result;
  all(archive, evaluation, inliers);
  archive.key_lists(inlier_keys);
  all(archive, inlier_points, hulls);
}

void fields(auto& archive, Some<io::Crs> auto& crs) {
  auto& [definition] = crs;
  all(archive, definition);
}

/// The points are left out: readings have none.
void fields(auto& archive, Some<io::PointCloud> auto& cloud) {
  auto& [frame, crs, points, warnings, horizontal_unit_m, vertical_unit_m, n_read, n_dropped_class,
         n_dropped_withheld, n_dropped_return, n_dropped_bounds, n_dropped_non_finite,
         n_dropped_share] = cloud;
  all(archive, frame, crs, warnings, horizontal_unit_m, vertical_unit_m, n_read, n_dropped_class,
      n_dropped_withheld, n_dropped_return, n_dropped_bounds, n_dropped_non_finite,
      n_dropped_share);
}

void fields(auto& archive, Some<CloudReadings> auto& readings) {
  auto& [n_batches, n_kept, cloud, read_places] = readings;
  all(archive, n_batches, n_kept, cloud, read_places);
}

void fields(auto& archive, Some<JudgedBatches> auto& part) {
  auto& [results, readings, decoys] = part;  // parts have no decoys
  all(archive, results, readings);
}

void fields(auto& archive, Some<evaluate::ImageObservation> auto& observation) {
  auto& [image_from_local, px] = observation;
  all(archive, image_from_local, px);
}

void fields(auto& archive, Some<evaluate::ImageEvidence> auto& images) {
  all(archive, images.observations, images.height_range_m);
}

void fields(auto& archive, Some<evaluate::JudgedLine> auto& line) {
  auto& [id, segment, line_class, class_base, building, epipolar_angle_deg, covariance_m2, inside,
         images, reconstructed, confirmed, repeats_id, n_images] = line;
  all(archive, id, segment, line_class, class_base, building, epipolar_angle_deg, covariance_m2,
      inside, images, reconstructed, confirmed, repeats_id, n_images);
}

void fields(auto& archive, Some<LinesPart> auto& part) {
  auto& [frame, plan_scale, lines] = part;
  all(archive, frame, plan_scale, lines);
}

namespace {

/// What a file begins with. The number is written as it lies in memory: a computer with another
/// order of bytes finds no file of its own here.
std::string beginning(const std::string& key) {
  ByteWriter writer;
  writer(std::string("ridgeline part 3"));
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
