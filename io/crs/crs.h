// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace ridgeline::io {

/// A coordinate reference system as a file states it: a code ("EPSG:25832+7837",
/// "urn:ogc:def:crs:EPSG::25832"), WKT1, WKT2, PROJJSON or a PROJ string; no name, as PROJ would take
/// the next one like it. An empty definition means that the file states none.
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
  double vertical_unit_m = 1.0;  ///< of the vertical part, else the horizontal unit
  std::string horizontal_unit_name = "metre";
  std::string vertical_unit_name = "metre";
  /// Programs write a plane that is nowhere ("Undefined SRS") where they have none.
  [[nodiscard]] bool states_nothing() const {
    return name.starts_with("Undefined ") || horizontal_unit_m == 0.0;
  }
};

constexpr double kFoot_m = 0.3048;
constexpr double kSurveyFoot_m = 1200.0 / 3937.0;

/// Equal but for rounding: the two feet differ.
bool same_unit(double a_m, double b_m);

/// "US survey foot (0.304800609601 m)".
std::string unit_text(double unit_m);

/// Throws std::invalid_argument if PROJ does not find its data base, without which it understands
/// nothing: what could not be read may be right.
void require_proj_data();

/// Whether PROJ reads the definition as WKT, of any dialect.
bool is_wkt(const Crs& crs);

/// Throws std::invalid_argument if PROJ cannot read the definition, or finds no data base of its own.
/// An unknown CRS: metres assumed.
CrsFacts describe(const Crs& crs);

/// WKT1 in GDAL's dialect, which LAS readers of every age understand.
/// Throws std::invalid_argument if PROJ cannot read the definition or has no such form of it.
std::string to_wkt(const Crs& crs);

/// The same compound CRS with heights in another unit; the CRS itself without a vertical part.
/// Throws std::invalid_argument if PROJ cannot read the definition.
Crs with_vertical_unit(const Crs& crs, double unit_m);

/// Verdict on using two data sets together.
struct CrsAgreement {
  bool compatible = true;
  std::string reason;   ///< why not, with both names; empty if compatible
  std::string warning;  ///< e.g. one vertical CRS is unknown: heights may differ by tens of metres
};

/// Horizontal and vertical parts are compared apart, by PROJ's equivalence (an EPSG code and its
/// WKT1 and WKT2 agree; axis order of geographic CRS ignored), never by text. Known parts that
/// differ are incompatible, units included; an unknown part gives a warning.
CrsAgreement compare(const Crs& a, const Crs& b);

}  // namespace ridgeline::io
