// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::io {

/// Location of a variable-length record (VLR or, after the points, EVLR). The range is checked to
/// lie inside the file.
struct LasVlr {
  std::string user_id;
  std::uint16_t record_id = 0;
  std::uint64_t data_offset = 0;  ///< byte offset of the payload in the file
  std::uint64_t data_size = 0;
};

/// Public header block of LAS 1.0-1.5, point formats 0-10, compressed or not.
struct LasHeader {
  int version_minor = 0;  ///< the major version is 1
  std::uint16_t global_encoding = 0;
  std::uint64_t file_size = 0;
  std::uint16_t header_size = 0;
  /// Byte offset of the first record, or of the LAZ data if compressed.
  std::uint32_t point_offset = 0;
  std::uint8_t raw_point_format = 0;   ///< as stored: bits 6 and 7 mark LAZ
  std::uint8_t point_format = 0;       ///< 0..10
  std::uint16_t record_length = 0;     ///< bytes, at least the format's own size
  std::uint64_t n_points = 0;          ///< records in the file; if compressed, the number claimed
  std::uint64_t n_points_claimed = 0;  ///< differs from n_points only when salvaging
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
  Eigen::Vector3d stated_min = Eigen::Vector3d::Zero();  ///< often wrong: never filter by it
  Eigen::Vector3d stated_max = Eigen::Vector3d::Zero();
  std::vector<LasVlr> vlrs;           ///< VLRs, then EVLRs, in file order
  std::vector<std::string> warnings;  ///< without the path

  [[nodiscard]] bool is_compressed() const { return (raw_point_format & 0xC0U) != 0; }
  [[nodiscard]] bool crs_is_wkt() const { return (global_encoding & 0x10U) != 0; }
};

struct LasHeaderOptions {
  /// Read the records that are present if the file is shorter than it claims.
  bool salvage = false;
};

/// Size in bytes of a record of `point_format` 0..10 without extra bytes.
std::uint16_t las_record_size(std::uint8_t point_format);

/// Reads the header and record list of a LAS or LAZ file. Every offset and count is checked against
/// the file size; `path` is used only in messages.
/// Throws IoError, naming field, byte offset, value and rule, if the file is not LAS, is truncated,
/// was left incomplete by an interrupted writer, or has a version outside 1.0-1.5, an unknown point
/// format, short records, an unusable scale or offset, or fewer records than claimed (unless
/// salvaging).
/// Source: ASPRS LAS Specification 1.4 R15, section 2.4.
LasHeader parse_las_header(std::span<const std::byte> file,
                           const std::string& path,
                           const LasHeaderOptions& options = {});

/// Reads the header of a file on disk, see parse_las_header().
LasHeader read_las_header(const std::string& path, const LasHeaderOptions& options = {});

/// The first record with this user and record id, if any.
std::optional<LasVlr> find_vlr(const LasHeader& header,
                               std::string_view user_id,
                               std::uint16_t record_id);

}  // namespace ridgeline::io
