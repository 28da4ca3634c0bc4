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

/// The keys whose values are stored in the directory itself; empty if the directory is damaged.
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

/// The EPSG code of a vertical datum to which GeoTIFF 1.0 assigns its own code; 0 for any other
/// code. Key 4099 states the unit of such heights.
std::uint16_t epsg_code_of_datum(std::uint16_t code) {
  switch (code) {
    case 5101:
      return 5701;  // Ordnance Datum Newlyn
    case 5102:
      return 5702;  // NGVD29
    case 5103:
      return 5703;  // NAVD88
    case 5104:
      return 5736;  // Yellow Sea 1956
    case 5105:
      return 5705;  // Baltic
    case 5106:
      return 5706;  // Caspian
    default:
      return 0;
  }
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
      warnings.push_back(
          fmt::format("GeoTIFF key {} is unit {}; supported are 9001 (metre), 9002 (foot) and 9003 "
                      "(US survey foot)",
                      key, code));
      return std::nullopt;
  }
}

/// PROJ's description of a reference system.
std::optional<CrsFacts> known_facts(const Crs& crs) {
  try {
    return describe(crs);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

bool is_horizontal(const Crs& crs) {
  const std::optional<CrsFacts> facts = known_facts(crs);
  return facts && !facts->horizontal_name.empty();
}

/// Whether a system defines only heights. A three-dimensional system defines heights too, but
/// cannot be part of a compound system.
bool is_vertical_alone(const Crs& crs) {
  const std::optional<CrsFacts> facts = known_facts(crs);
  return facts && facts->horizontal_name.empty() && !facts->vertical_name.empty();
}

/// Combines the horizontal system and that of key 4096 into a compound system. A datum has no unit:
/// its heights are in the unit of key 4099, otherwise in that of the plan.
void add_heights(const ShortKeys& keys, GeoTiffCrs& result) {
  const std::uint16_t stated = epsg_code(keys, kVerticalCrs);
  if (stated == 0) return;
  const std::uint16_t of_datum = epsg_code_of_datum(stated);
  const std::uint16_t code = of_datum != 0 ? of_datum : stated;
  const Crs vertical{fmt::format("EPSG:{}", code)};
  if (!is_vertical_alone(vertical)) {
    result.warnings.push_back(
        fmt::format("GeoTIFF key 4096 is {}, which is not a vertical reference system known to "
                    "PROJ; the height system is unknown",
                    stated));
    return;
  }
  if (!result.crs.known()) {
    if (of_datum == 0 && !result.vertical_unit_m) {
      result.vertical_unit_m = describe(vertical).vertical_unit_m;
    }
    return;
  }
  const double plan_unit_m =
      result.horizontal_unit_m.value_or(describe(result.crs).horizontal_unit_m);
  const Crs compound{fmt::format("{}+{}", result.crs.definition, code)};
  if (!known_facts(compound)) {
    result.warnings.push_back(
        fmt::format("GeoTIFF key 4096 is {}, which {} cannot be combined with; the key is ignored",
                    stated, result.crs.definition));
    return;
  }
  result.crs = compound;
  if (of_datum == 0) return;
  const double unit_m = result.vertical_unit_m.value_or(plan_unit_m);
  if (same_unit(unit_m, describe(result.crs).vertical_unit_m)) return;
  result.crs = with_vertical_unit(result.crs, unit_m);
  if (result.vertical_unit_m) return;
  result.warnings.push_back(
      fmt::format("GeoTIFF key 4096 names a vertical datum but key 4099 has no height unit; "
                  "assuming that of the plan, {}",
                  unit_text(unit_m)));
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
  if (user_defined || horizontal == 0 || !is_horizontal(horizontal_crs)) {
    result.warnings.emplace_back(
        keys.empty() ? "GeoTIFF keys are empty or damaged; reference system unknown"
        : user_defined || horizontal == 0
            ? "GeoTIFF keys do not name a registered reference system; reference system unknown"
            : fmt::format("GeoTIFF keys name {}, which is not a horizontal reference system known "
                          "to PROJ; reference system unknown",
                          horizontal_crs.definition));
    add_heights(keys, result);
    return result;
  }
  result.crs = horizontal_crs;
  add_heights(keys, result);
  return result;
}

}  // namespace ridgeline::io
