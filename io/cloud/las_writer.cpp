// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/las_writer.h"

#include "io/atomic_file.h"
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
constexpr std::size_t kRecordLength = 30;
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

/// What the header says of the points.
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
  if (statistics.raw_bounds.isEmpty()) return;  // zeros
  for (std::ptrdiff_t axis = 0; axis < 3; ++axis) {
    const double origin = frame.origin_m[axis];
    store(statistics.raw_bounds.max()[axis] * scale_m + origin, header + 179 + 16 * axis);
    store(statistics.raw_bounds.min()[axis] * scale_m + origin, header + 187 + 16 * axis);
  }
}

/// Source: LAS Specification 1.4 R15, table 3.
std::array<char, kHeaderSize> make_header(const Statistics& statistics,
                                          std::uint64_t n_points,
                                          const LocalFrame& frame,
                                          double scale_m,
                                          std::size_t wkt_record_size) {
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
  store(static_cast<std::uint32_t>(kHeaderSize + wkt_record_size), h + 96);
  store<std::uint32_t>(wkt_record_size > 0 ? 1 : 0, h + 100);
  h[104] = 6;
  store<std::uint16_t>(kRecordLength, h + 105);
  for (std::ptrdiff_t axis = 0; axis < 3; ++axis) {
    store(scale_m, h + 131 + 8 * axis);
    store(frame.origin_m[axis], h + 155 + 8 * axis);
  }
  store_bounds(statistics, frame, scale_m, h);
  store(n_points, h + 247);
  for (std::size_t i = 0; i < kMaxReturns; ++i) store(statistics.n_by_return[i], h + 255 + 8 * i);
  return header;
}

/// The WKT record with its header, empty if the CRS is unknown.
std::string make_wkt_record(const Crs& crs) {
  if (!crs.known()) return {};
  const std::string wkt = to_wkt(crs);
  check(wkt.size() < std::numeric_limits<std::uint16_t>::max(), "write_las: WKT of ", wkt.size(),
        " bytes, must be below 65535");
  std::string record(kVlrHeaderSize, '\0');
  store_text("LASF_Projection", record.data() + 2);
  store<std::uint16_t>(2112, record.data() + 18);
  store(static_cast<std::uint16_t>(wkt.size() + 1), record.data() + 20);
  store_text("OGC coordinate system WKT", record.data() + 22);
  return record + wkt + '\0';
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

void write_records(std::span<const CloudPoint> points, double scale_m, std::ostream& stream) {
  constexpr std::size_t kPointsAtOnce = 16384;
  std::vector<char> buffer(std::min(points.size(), kPointsAtOnce) * kRecordLength);
  while (!points.empty()) {
    const std::size_t count = std::min(points.size(), kPointsAtOnce);
    for (std::size_t i = 0; i < count; ++i) {
      store_record(points[i], scale_m, &buffer[i * kRecordLength]);
    }
    stream.write(buffer.data(), static_cast<std::streamsize>(count * kRecordLength));
    points = points.subspan(count);
  }
}

}  // namespace

void write_las(const std::string& path,
               std::span<const CloudPoint> points_in_local,
               const LocalFrame& frame,
               const Crs& crs,
               const LasWriteOptions& options) {
  check(std::isfinite(options.scale_m) && options.scale_m > 0.0,
        "write_las: scale_m = ", options.scale_m, ", must be positive and finite");
  check(frame.origin_m.allFinite(), "write_las: the origin of the frame must be finite");
  const Statistics statistics = summarise(points_in_local, options.scale_m);
  const std::string wkt_record = make_wkt_record(crs);
  const std::array<char, kHeaderSize> header =
      make_header(statistics, points_in_local.size(), frame, options.scale_m, wkt_record.size());

  AtomicFile file(path);
  file.stream().write(header.data(), header.size());
  file.stream() << wkt_record;
  write_records(points_in_local, options.scale_m, file.stream());
  file.commit();
}

}  // namespace ridgeline::io
