// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/geotiff_keys.h"

#include "io/cloud/bytes.h"

#include <fmt/format.h>

#include <cstdint>
#include <map>
#include <stdexcept>

namespace ridgeline::io {

namespace {

constexpr std::uint16_t kGeographicCrs = 2048;
constexpr std::uint16_t kProjectedCrs = 3072;
constexpr std::uint16_t kLinearUnit = 3076;
constexpr std::uint16_t kVerticalCrs = 4096;
constexpr std::uint16_t kVerticalUnit = 4099;
constexpr std::uint16_t kUserDefined = 32767;

using ShortKeys = std::map<std::uint16_t, std::uint16_t>;

/// The keys whose value lies in the directory itself; empty if the directory is damaged.
ShortKeys read_short_keys(std::span<const std::byte> directory) {
  constexpr std::size_t kEntrySize = 8;
  ShortKeys keys;
  if (directory.size() < kEntrySize) return keys;
  const std::size_t count = load<std::uint16_t>(&directory[6]);
  if (count * kEntrySize > directory.size() - kEntrySize) return keys;
  for (std::size_t i = 1; i <= count; ++i) {
    const std::byte* const entry = &directory[i * kEntrySize];
    const auto location = load<std::uint16_t>(entry + 2);
    if (location == 0) keys[load<std::uint16_t>(entry)] = load<std::uint16_t>(entry + 6);
  }
  return keys;
}

/// 0 stands for an absent, undefined or user-defined code.
std::uint16_t epsg_code(const ShortKeys& keys, std::uint16_t key) {
  const auto found = keys.find(key);
  return found == keys.end() || found->second >= kUserDefined ? std::uint16_t{0} : found->second;
}

/// GeoTIFF 1.0 had its own codes for vertical systems; of these one is common in LAS.
std::uint16_t vertical_epsg_code(const ShortKeys& keys) {
  constexpr std::uint16_t kGeoTiff10Navd88 = 5103;
  constexpr std::uint16_t kEpsgNavd88 = 5703;
  const std::uint16_t code = epsg_code(keys, kVerticalCrs);
  return code == kGeoTiff10Navd88 ? kEpsgNavd88 : code;
}

std::optional<double> stated_unit_m(const ShortKeys& keys,
                                    std::uint16_t key,
                                    std::vector<std::string>& warnings) {
  switch (const std::uint16_t code = epsg_code(keys, key)) {
    case 0:
      return std::nullopt;
    case 9001:
      return 1.0;
    case 9002:
      return 0.3048;
    case 9003:
      return 1200.0 / 3937.0;
    default:
      warnings.push_back(fmt::format(
          "GeoTIFF key {} is unit {}; known are 9001 metre, 9002 foot, 9003 US survey foot", key,
          code));
      return std::nullopt;
  }
}

bool proj_knows(const Crs& crs) {
  try {
    describe(crs);
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

}  // namespace

GeoTiffCrs parse_geotiff_keys(std::span<const std::byte> directory) {
  GeoTiffCrs result;
  const ShortKeys keys = read_short_keys(directory);
  result.horizontal_unit_m = stated_unit_m(keys, kLinearUnit, result.warnings);
  result.vertical_unit_m = stated_unit_m(keys, kVerticalUnit, result.warnings);
  const std::uint16_t projected = epsg_code(keys, kProjectedCrs);
  const std::uint16_t horizontal = projected != 0 ? projected : epsg_code(keys, kGeographicCrs);
  // A user-defined projection on a registered geographic CRS is not that geographic CRS.
  const bool user_defined = projected == 0 && keys.contains(kProjectedCrs);
  const Crs horizontal_crs{fmt::format("EPSG:{}", horizontal)};
  if (user_defined || horizontal == 0 || !proj_knows(horizontal_crs)) {
    result.warnings.emplace_back(
        keys.empty() ? "GeoTIFF keys are empty or damaged; reference system unknown"
        : user_defined || horizontal == 0
            ? "GeoTIFF keys name no registered reference system; reference system unknown"
            : fmt::format(
                  "GeoTIFF keys name {}, which PROJ does not know; reference system unknown",
                  horizontal_crs.definition));
    return result;
  }
  result.crs = horizontal_crs;
  if (const std::uint16_t vertical = vertical_epsg_code(keys); vertical != 0) {
    const Crs compound{fmt::format("EPSG:{}+{}", horizontal, vertical)};
    if (proj_knows(compound)) {
      result.crs = compound;
    } else {
      result.warnings.push_back(
          fmt::format("GeoTIFF key 4096 is {}, no vertical reference system that PROJ knows; "
                      "heights taken as unknown",
                      vertical));
    }
  }
  return result;
}

}  // namespace ridgeline::io
