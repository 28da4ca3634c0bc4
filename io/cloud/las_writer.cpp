// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/las_writer.h"

#include "io/files/atomic_file.h"
#include "reconstruct/geometry/check.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>
#include <vector>

namespace ridgeline::io {

namespace {

constexpr std::size_t kHeaderSize = 375;
constexpr std::size_t kVlrHeaderSize = 54;
/// Records of point format 6, or of format 7 with the extra bytes of a label.
struct RecordLayout {
  char format = 6;
  std::size_t length = 30;
};
constexpr RecordLayout kPlain{};
constexpr RecordLayout kLabelled{.format = 7, .length = 36 + 8};
constexpr std::size_t kMaxReturns = 15;

template <typename T>
void store(T value, char* target) {
  std::memcpy(target, &value, sizeof(T));
}

void store_text(std::string_view text, char* target) { std::ranges::copy(text, target); }

using RawPosition = std::array<std::int32_t, 3>;

RawPosition quantise(const CloudPoint& point, double scale_m) {
  constexpr double kLimit = std::numeric_limits<std::int32_t>::max();
  RawPosition raw{};
  const std::array<double, 3> position{point.x, point.y, point.z};
  for (std::size_t axis = 0; axis < raw.size(); ++axis) {
    const double steps = std::round(position[axis] / scale_m);
    check(std::abs(steps) <= kLimit, "write_las: coordinate = ", position[axis],
          " m, must be within 2^31 steps of ", scale_m, " m");
    raw[axis] = static_cast<std::int32_t>(steps);
  }
  return raw;
}

/// Statistics of the points for the header.
struct Statistics {
  Eigen::AlignedBox<std::int32_t, 3> raw_bounds;
  std::array<std::uint64_t, kMaxReturns> n_by_return{};
};

Statistics summarise(std::span<const CloudPoint> points, double scale_m) {
  Statistics statistics;
  for (const CloudPoint& point : points) {
    const RawPosition raw = quantise(point, scale_m);
    statistics.raw_bounds.extend(Eigen::Vector3i(raw[0], raw[1], raw[2]));
    check(point.return_number <= kMaxReturns && point.number_of_returns <= kMaxReturns,
          "write_las: return ", +point.return_number, " of ", +point.number_of_returns,
          ", must be at most ", kMaxReturns);
    if (point.return_number > 0) ++statistics.n_by_return[point.return_number - 1U];
  }
  return statistics;
}

void store_bounds(const Statistics& statistics,
                  const LocalFrame& frame,
                  double scale_m,
                  char* header) {
  if (statistics.raw_bounds.isEmpty()) return;  // the bounds of a file without points stay 0
  for (std::ptrdiff_t axis = 0; axis < 3; ++axis) {
    const double origin = frame.origin_m[axis];
    store(statistics.raw_bounds.max()[axis] * scale_m + origin, header + 179 + 16 * axis);
    store(statistics.raw_bounds.min()[axis] * scale_m + origin, header + 187 + 16 * axis);
  }
}

struct VariableRecords {
  std::string bytes;
  std::uint32_t n = 0;
};

/// Source: LAS Specification 1.4 R15, table 3.
std::array<char, kHeaderSize> make_header(const Statistics& statistics,
                                          std::uint64_t n_points,
                                          const LocalFrame& frame,
                                          double scale_m,
                                          const RecordLayout& layout,
                                          const VariableRecords& records) {
  constexpr std::uint16_t kCrsIsWkt = 0x10;
  constexpr std::uint16_t kCreationYear = 2000;  // fixed, for reproducible bytes
  std::array<char, kHeaderSize> header{};
  char* const h = header.data();
  store_text("LASF", h);
  store(kCrsIsWkt, h + 6);
  h[24] = 1;
  h[25] = 4;
  store_text("ridgeline", h + 26);
  store_text("ridgeline", h + 58);
  store<std::uint16_t>(1, h + 90);  // day of the year
  store(kCreationYear, h + 92);
  store<std::uint16_t>(kHeaderSize, h + 94);
  store(static_cast<std::uint32_t>(kHeaderSize + records.bytes.size()), h + 96);
  store(records.n, h + 100);
  h[104] = layout.format;
  store(static_cast<std::uint16_t>(layout.length), h + 105);
  for (std::ptrdiff_t axis = 0; axis < 3; ++axis) {
    store(scale_m, h + 131 + 8 * axis);
    store(frame.origin_m[axis], h + 155 + 8 * axis);
  }
  store_bounds(statistics, frame, scale_m, h);
  store(n_points, h + 247);
  for (std::size_t i = 0; i < kMaxReturns; ++i) store(statistics.n_by_return[i], h + 255 + 8 * i);
  return header;
}

std::string record_header(std::string_view user,
                          std::uint16_t id,
                          std::size_t n_bytes,
                          std::string_view description) {
  std::string record(kVlrHeaderSize, '\0');
  store_text(user, record.data() + 2);
  store(id, record.data() + 18);
  store(static_cast<std::uint16_t>(n_bytes), record.data() + 20);
  store_text(description, record.data() + 22);
  return record;
}

void add_wkt(const Crs& crs, VariableRecords& records) {
  if (!crs.known()) return;
  const std::string wkt = to_wkt(crs);
  check(wkt.size() < std::numeric_limits<std::uint16_t>::max(), "write_las: WKT of ", wkt.size(),
        " bytes, must be below 65535");
  records.bytes +=
      record_header("LASF_Projection", 2112, wkt.size() + 1, "OGC coordinate system WKT") + wkt +
      '\0';
  ++records.n;
}

/// Source: LAS Specification 1.4 R15, tables 24 and 25.
void add_extra_bytes(VariableRecords& records) {
  constexpr std::size_t kDescriptorSize = 192;
  struct Extra {
    char type;
    std::string_view name, description;
  };
  constexpr std::array kExtras{Extra{5, "plane_id", "number of the plane"},
                               Extra{9, "distance_m", "from the plane"}};
  std::string descriptors(kExtras.size() * kDescriptorSize, '\0');
  for (std::size_t i = 0; i < kExtras.size(); ++i) {
    char* const d = descriptors.data() + i * kDescriptorSize;
    d[2] = kExtras[i].type;
    store_text(kExtras[i].name, d + 4);
    store_text(kExtras[i].description, d + 160);
  }
  records.bytes += record_header("LASF_Spec", 4, descriptors.size(), "extra bytes") + descriptors;
  ++records.n;
}

/// Stores a label after a record of point format 6.
void store_label(const PointLabel& label, char* record) {
  for (std::size_t i = 0; i < 3; ++i) {
    store(static_cast<std::uint16_t>(label.rgb[i] << 8U), record + 30 + 2 * i);
  }
  store(label.plane_id, record + 36);
  store(label.distance_m, record + 40);
}

void store_record(const CloudPoint& point, double scale_m, char* record) {
  const RawPosition raw = quantise(point, scale_m);
  std::memcpy(record, raw.data(), sizeof(raw));
  store(point.intensity, record + 12);
  record[14] = static_cast<char>(point.return_number | point.number_of_returns << 4U);
  record[15] = static_cast<char>(point.flags & 0x0FU);
  record[16] = static_cast<char>(point.classification);
  store(point.source_id, record + 20);
}

void write_records(std::span<const CloudPoint> points,
                   std::span<const PointLabel> labels,
                   double scale_m,
                   std::ostream& stream) {
  constexpr std::size_t kPointsAtOnce = 16384;
  const std::size_t length = labels.empty() ? kPlain.length : kLabelled.length;
  std::vector<char> buffer(std::min(points.size(), kPointsAtOnce) * length);
  for (std::size_t first = 0; first < points.size(); first += kPointsAtOnce) {
    const std::size_t count = std::min(points.size() - first, kPointsAtOnce);
    for (std::size_t i = 0; i < count; ++i) {
      store_record(points[first + i], scale_m, &buffer[i * length]);
      if (!labels.empty()) store_label(labels[first + i], &buffer[i * length]);
    }
    stream.write(buffer.data(), static_cast<std::streamsize>(count * length));
  }
}

}  // namespace

void write_las(const std::string& path,
               std::span<const CloudPoint> points_in_local,
               const LocalFrame& frame,
               const Crs& crs,
               const LasWriteOptions& options,
               std::span<const PointLabel> labels) {
  check(std::isfinite(options.scale_m) && options.scale_m > 0.0,
        "write_las: scale_m = ", options.scale_m, ", must be positive and finite");
  check(frame.origin_m.allFinite(), "write_las: the origin of the frame must be finite");
  const Statistics statistics = summarise(points_in_local, options.scale_m);
  check(labels.empty() || labels.size() == points_in_local.size(), "write_las: ", labels.size(),
        " labels for ", points_in_local.size(), " points");
  VariableRecords records;
  add_wkt(crs, records);
  if (!labels.empty()) add_extra_bytes(records);
  const std::array<char, kHeaderSize> header =
      make_header(statistics, points_in_local.size(), frame, options.scale_m,
                  labels.empty() ? kPlain : kLabelled, records);

  AtomicFile file(path);
  file.stream().write(header.data(), header.size());
  file.stream() << records.bytes;
  write_records(points_in_local, labels, options.scale_m, file.stream());
  file.commit();
}

}  // namespace ridgeline::io
