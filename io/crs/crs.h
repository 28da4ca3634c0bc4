// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace ridgeline::io {

/// A coordinate reference system as a file states it: a code ("EPSG:25832+7837",
/// "urn:ogc:def:crs:EPSG::25832"), WKT1, WKT2, PROJJSON or a PROJ string. A name is not accepted,
/// because PROJ would pick the most similar one. An empty definition means that the file states
/// none.
struct Crs {
  std::string definition;
  [[nodiscard]] bool known() const { return !definition.empty(); }
};

/// Properties of a CRS according to PROJ, split into its horizontal and vertical part.
struct CrsFacts {
  std::string name;  ///< of the whole CRS, for messages; "unknown" for an empty definition
  std::string horizontal_name;  ///< empty if unknown
  std::string vertical_name;    ///< empty if the CRS has no vertical part
  bool is_geographic = false;   ///< coordinates are in degrees: refused for evaluation
  double horizontal_unit_m = 1.0;
  double vertical_unit_m = 1.0;  ///< unit of the vertical part; without one, the horizontal unit
  std::string horizontal_unit_name = "metre";
  std::string vertical_unit_name = "metre";
  /// Whether the CRS is a placeholder: programs without a CRS write a plane without a location
  /// ("Undefined SRS").
  [[nodiscard]] bool states_nothing() const {
    return name.starts_with("Undefined ") || horizontal_unit_m == 0.0;
  }
};

constexpr double kFoot_m = 0.3048;
constexpr double kSurveyFoot_m = 1200.0 / 3937.0;

/// Whether two units are equal apart from rounding; the two kinds of foot are not.
bool same_unit(double a_m, double b_m);

/// A unit for messages: "US survey foot (0.304800609601 m)".
std::string unit_text(double unit_m);

/// Throws std::invalid_argument if PROJ does not find its database. Without it PROJ cannot
/// interpret definitions, so failing to read one does not mean that it is wrong.
void require_proj_data();

/// Whether PROJ can read the definition as WKT of any dialect.
bool is_wkt(const Crs& crs);

/// The properties of a CRS; metres are assumed for an unknown one. Throws std::invalid_argument if
/// PROJ cannot read the definition or does not find its database.
CrsFacts describe(const Crs& crs);

/// Whether the definition is that of geocentric coordinates, which describe() refuses; false if it
/// is empty or PROJ cannot read it.
bool states_geocentric(const Crs& crs);

/// The CRS as WKT1 in GDAL's dialect, which LAS readers of every age understand.
/// Throws std::invalid_argument if PROJ cannot read the definition or cannot express it in this
/// form.
std::string to_wkt(const Crs& crs);

/// The same compound CRS with heights in another unit; the CRS itself if it has no vertical part.
/// Throws std::invalid_argument if PROJ cannot read the definition.
Crs with_vertical_unit(const Crs& crs, double unit_m);

/// Whether two data sets can be used together.
struct CrsAgreement {
  bool compatible = true;
  std::string reason;   ///< why not, naming both; empty if compatible
  std::string warning;  ///< e.g. one vertical CRS is unknown: heights may differ by tens of metres
};

/// Compares horizontal and vertical parts separately, by PROJ's equivalence and never as text: an
/// EPSG code agrees with its WKT1 and WKT2, and the axis order of a geographic CRS is ignored.
/// Known parts that differ, even if only in units, are incompatible; an unknown part gives a
/// warning.
CrsAgreement compare(const Crs& a, const Crs& b);

}  // namespace ridgeline::io
