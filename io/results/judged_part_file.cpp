// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/judged_part_file.h"

#include "io/files/atomic_file.h"
#include "io/files/sha256.h"
#include "io/files/text_file.h"
#include "reconstruct/geometry/check.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace ridgeline::results {
namespace {

template <typename T>
concept Number = std::is_arithmetic_v<T> || std::is_enum_v<T>;

/// Writes or reads a value: by the archive itself, or its fields one by one.
template <typename Archive, typename Value>
void each(Archive& archive, Value& value) {
  if constexpr (requires { archive(value); }) {
    archive(value);
  } else {
    fields(archive, value);
  }
}

class ByteWriter {
 public:
  template <Number T>
  void operator()(const T& number) {
    bytes_.append(reinterpret_cast<const char*>(&number), sizeof number);
  }
  void operator()(const std::string& text) {
    (*this)(std::uint64_t{text.size()});
    bytes_ += text;
  }
  template <int kRows, int kColumns>
  void operator()(const Eigen::Matrix<double, kRows, kColumns>& matrix) {
    for (Eigen::Index i = 0; i < matrix.size(); ++i) (*this)(matrix.data()[i]);
  }
  template <typename T>
  void operator()(const std::optional<T>& value) {
    (*this)(value.has_value());
    if (value) each(*this, *value);
  }
  template <typename T>
  void operator()(const std::vector<T>& values) {
    (*this)(std::uint64_t{values.size()});
    for (const T& value : values) each(*this, value);
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  template <Number T>
  void operator()(T& number) {
    std::memcpy(&number, take(sizeof number).data(), sizeof number);
  }
  void operator()(std::string& text) { text = take(count()); }
  template <int kRows, int kColumns>
  void operator()(Eigen::Matrix<double, kRows, kColumns>& matrix) {
    for (Eigen::Index i = 0; i < matrix.size(); ++i) (*this)(matrix.data()[i]);
  }
  template <typename T>
  void operator()(std::optional<T>& value) {
    std::uint8_t has_value = 0;
    (*this)(has_value);
    value.reset();
    if (has_value != 0) each(*this, value.emplace());
  }
  template <typename T>
  void operator()(std::vector<T>& values) {
    values.resize(count());
    for (T& value : values) each(*this, value);
  }
  [[nodiscard]] bool at_end() const { return bytes_.empty(); }

 private:
  /// The number of elements that follow. Each takes a byte at least, so that damage asks for no absurd memory.
  std::size_t count() {
    std::uint64_t n = 0;
    (*this)(n);
    check(n <= bytes_.size(), "judged part: ", n, " elements in ", bytes_.size(),
          " bytes; must be no more");
    return n;
  }
  std::string_view take(std::size_t n) {
    check(n <= bytes_.size(), "judged part: ", bytes_.size(), " bytes left, must be at least ", n);
    const std::string_view front = bytes_.substr(0, n);
    bytes_.remove_prefix(n);
    return front;
  }

  std::string_view bytes_;
};

/// The type `T`, to be written, or without const to be read.
template <typename Value, typename T>
concept Some = std::is_same_v<std::remove_const_t<Value>, T>;

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
  archive(result.inlier_keys);
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

/// What a file begins with. The number is written as it lies in memory: a computer with another order of bytes finds no
/// file of its own here.
std::string beginning(const std::string& key) {
  ByteWriter writer;
  writer(std::string("ridgeline judged part 1"));
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

}  // namespace

std::string to_bytes(const JudgedBatches& part) {
  ByteWriter writer;
  fields(writer, part);
  return writer.take();
}

JudgedBatches judged_part_of(std::string_view bytes) {
  ByteReader reader(bytes);
  JudgedBatches part;
  fields(reader, part);
  check(reader.at_end(), "judged part: bytes behind its end, must be none");
  return part;
}

void write_judged_part(const std::string& path, const std::string& key, const JudgedBatches& part) {
  std::string bytes = beginning(key) + to_bytes(part);
  bytes += hash_of(bytes);
  io::write_file(path, bytes);
}

bool is_judged_part(const std::string& path, const std::string& key) {
  return content_of(path, key).has_value();
}

std::optional<JudgedBatches> read_judged_part(const std::string& path, const std::string& key) {
  const std::optional<std::string> content = content_of(path, key);
  if (!content) return std::nullopt;
  return judged_part_of(std::string_view(*content).substr(beginning(key).size()));
}

}  // namespace ridgeline::results
