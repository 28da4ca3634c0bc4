// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace ridgeline::io {

/// A coordinate reference system as a file states it: a code ("EPSG:25832+7837",
/// "urn:ogc:def:crs:EPSG::25832"), WKT1, WKT2, PROJJSON or a PROJ string. A name is not accepted,
/// as PROJ would take the next one like it. An empty definition means that the file states none.
struct Crs {
  std::string definition;
  [[nodiscard]] bool known() const { return !definition.empty(); }
};

/// What PROJ says of a CRS, split into its horizontal and vertical part.
struct CrsFacts {
  std::string name;             ///< of the whole, for messages; "unknown" for an empty definition
  std::string horizontal_name;  ///< empty if unknown
  std::string vertical_name;    ///< empty if the CRS has no vertical part
  bool is_geographic = false;   ///< coordinates are degrees: refused for evaluation
  double horizontal_unit_m = 1.0;
  double vertical_unit_m = 1.0;  ///< unit of the vertical part; without one, the horizontal unit
  std::string horizontal_unit_name = "metre";
  std::string vertical_unit_name = "metre";
  /// Whether the CRS stands for none: programs that have no CRS write a plane that is nowhere
  /// ("Undefined SRS").
  [[nodiscard]] bool states_nothing() const {
    return name.starts_with("Undefined ") || horizontal_unit_m == 0.0;
  }
};

constexpr double kFoot_m = 0.3048;
constexpr double kSurveyFoot_m = 1200.0 / 3937.0;

/// Whether two units are equal but for rounding; the two feet are not.
bool same_unit(double a_m, double b_m);

/// A unit for messages: "US survey foot (0.304800609601 m)".
std::string unit_text(double unit_m);

/// Throws std::invalid_argument if PROJ does not find its data base. Without it PROJ understands
/// nothing, and a definition that could not be read may be right.
void require_proj_data();

/// Whether PROJ reads the definition as WKT, of any dialect.
bool is_wkt(const Crs& crs);

/// The facts of a CRS; metres are assumed for an unknown one. Throws std::invalid_argument if PROJ
/// cannot read the definition, or finds no data base of its own.
CrsFacts describe(const Crs& crs);

/// The CRS as WKT1 in GDAL's dialect, which LAS readers of every age understand.
/// Throws std::invalid_argument if PROJ cannot read the definition or has no such form of it.
std::string to_wkt(const Crs& crs);

/// The same compound CRS with heights in another unit; the CRS itself if it has no vertical part.
/// Throws std::invalid_argument if PROJ cannot read the definition.
Crs with_vertical_unit(const Crs& crs, double unit_m);

/// Verdict on using two data sets together.
struct CrsAgreement {
  bool compatible = true;
  std::string reason;   ///< why not, with both names; empty if compatible
  std::string warning;  ///< e.g. one vertical CRS is unknown: heights may differ by tens of metres
};

/// Compares horizontal and vertical parts apart, by PROJ's equivalence and never by text: an EPSG
/// code and its WKT1 and WKT2 agree, and the axis order of a geographic CRS is ignored. Known parts
/// that differ, also in their units, are incompatible; an unknown part gives a warning.
CrsAgreement compare(const Crs& a, const Crs& b);

}  // namespace ridgeline::io
