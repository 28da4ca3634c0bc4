// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/las_crs.h"

#include "io/cloud/bytes.h"
#include "io/cloud/geotiff_keys.h"

#include <fmt/format.h>

#include <optional>
#include <stdexcept>

namespace ridgeline::io {

namespace {

constexpr std::uint16_t kWktRecord = 2112;
constexpr std::uint16_t kGeoTiffRecord = 34735;
constexpr std::uint64_t kMaxWkt_bytes = 1U << 20U;  // bytes; an EVLR may claim the rest of the file

std::optional<std::string> read_wkt(std::span<const std::byte> file, const LasHeader& header) {
  for (const char* const user : {"LASF_Projection", "liblas"}) {
    const std::optional<LasVlr> record = find_vlr(header, user, kWktRecord);
    if (!record || record->data_size > kMaxWkt_bytes) continue;
    std::string text = load_text(file.subspan(record->data_offset, record->data_size));
    if (text.find_first_not_of(" \t\r\n") != std::string::npos) return text;
  }
  return std::nullopt;
}

/// The CRS of a WKT record; unknown, with a warning, if PROJ cannot read it.
Crs checked_wkt(const std::string& wkt, std::vector<std::string>& warnings) {
  Crs crs{wkt};
  try {
    if (is_wkt(crs)) return describe(crs).states_nothing() ? Crs{} : crs;
  } catch (const std::invalid_argument&) {
  }
  require_proj_data();
  warnings.push_back(fmt::format(
      "WKT record of {} bytes is not a reference system known to PROJ; ignored", wkt.size()));
  return {};
}

/// Replaces the units of some axes with the one stated by the keys, with a warning if the reference
/// system states another.
void apply_stated_unit(
    double stated_m, const char* what, int first_axis, int n_axes, LasCrs& result) {
  auto units = result.unit_m.segment(first_axis, n_axes);
  const double of_crs_m = units[0];
  if (same_unit(of_crs_m, stated_m)) return;
  units.setConstant(stated_m);
  if (!result.crs.known()) return;
  if (first_axis == 2) result.crs = with_vertical_unit(result.crs, stated_m);
  result.warnings.push_back(
      fmt::format("{} unit is {:.10g} m in the GeoTIFF keys but {:.10g} m in the reference system; "
                  "using the keys",
                  what, stated_m, of_crs_m));
}

/// Applies the units of the keys. Heights without a unit of their own use that of the plan, as in a
/// registered system.
void apply_stated_units(const GeoTiffCrs& keys, bool has_vertical_crs, LasCrs& result) {
  if (keys.horizontal_unit_m) {
    apply_stated_unit(*keys.horizontal_unit_m, "horizontal", 0, 2, result);
  }
  if (keys.vertical_unit_m) {
    apply_stated_unit(*keys.vertical_unit_m, "vertical", 2, 1, result);
  } else if (!has_vertical_crs) {
    result.unit_m.z() = result.unit_m.x();
  }
}

/// The units of a file without a reference system.
std::string units_text(const GeoTiffCrs& keys, const Eigen::Vector3d& unit_m) {
  const std::string heights =
      !keys.vertical_unit_m ? "and so are its heights, which have no unit of their own"
      : same_unit(unit_m.x(), unit_m.z()) ? "and so are its heights"
                                          : "and its heights in " + unit_text(unit_m.z());
  return fmt::format("according to the GeoTIFF keys, its coordinates are in {} {}",
                     unit_text(unit_m.x()), heights);
}

/// Chooses the WKT or the keys by the rule of read_las_crs(). Returns whether the WKT was chosen.
bool choose(const LasHeader& header, const Crs& wkt, const Crs& keys, LasCrs& result) {
  const bool wkt_wins = header.crs_is_wkt() || header.version_minor >= 5;
  const bool both = wkt.known() && keys.known();
  const bool use_keys = both ? !wkt_wins : keys.known();
  if (both && !compare(wkt, keys).compatible) {
    result.warnings.push_back(fmt::format(
        "the WKT record has \"{}\" but the GeoTIFF keys have \"{}\"; {}", describe(wkt).name,
        describe(keys).name, use_keys ? "using the keys" : "using the WKT"));
  }
  result.crs = use_keys ? keys : wkt;
  return !use_keys && result.crs.known();
}

}  // namespace

LasCrs read_las_crs(std::span<const std::byte> file, const LasHeader& header) {
  LasCrs result;
  Crs wkt;
  if (const std::optional<std::string> text = read_wkt(file, header)) {
    wkt = checked_wkt(*text, result.warnings);
  }
  GeoTiffCrs keys;
  if (const auto record = find_vlr(header, "LASF_Projection", kGeoTiffRecord)) {
    keys = parse_geotiff_keys(file.subspan(record->data_offset, record->data_size));
    if (!wkt.known()) std::ranges::move(keys.warnings, std::back_inserter(result.warnings));
    if (header.point_format >= 6 && !wkt.known()) {
      result.warnings.push_back(
          fmt::format("point format {} requires a WKT reference system; using the GeoTIFF keys",
                      header.point_format));
    }
  }
  const bool used_wkt = choose(header, wkt, keys.crs, result);
  const CrsFacts facts = describe(result.crs);
  result.is_geographic = facts.is_geographic;
  if (facts.is_geographic) return result;
  result.unit_m = {facts.horizontal_unit_m, facts.horizontal_unit_m, facts.vertical_unit_m};
  if (!used_wkt) apply_stated_units(keys, !facts.vertical_name.empty(), result);
  const bool states_unit_alone = !result.crs.known() && result.unit_m != Eigen::Vector3d::Ones();
  if (states_unit_alone) result.warnings.push_back(units_text(keys, result.unit_m));
  return result;
}

}  // namespace ridgeline::io
