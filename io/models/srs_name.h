// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/crs/crs.h"

#include <string>
#include <string_view>

namespace ridgeline::io {

/// The meaning of a GML `srsName`.
struct SrsName {
  Crs crs;              ///< unknown if the name cannot be understood
  std::string warning;  ///< states what in the name is not understood; empty if nothing
  /// Whether the name is a URN or a URI. According to the standard, coordinates are then in the
  /// axis order of EPSG; with "EPSG:31467", east comes first, as everywhere in GIS.
  bool keeps_axis_order = false;
};

/// Understands EPSG codes in all forms that are in use ("EPSG:25832", "EPSG:25832+7837",
/// "urn:ogc:def:crs,crs:EPSG:6.12:25832,crs:EPSG::5783",
/// "http://www.opengis.net/def/crs/EPSG/0/7415"), the names of the German surveying offices
/// ("urn:adv:crs:ETRS89_UTM32*DE_DHHN2016_NH"), and whatever PROJ reads. A vertical part unknown to
/// PROJ is left out with a warning.
SrsName read_srs_name(std::string_view name);

}  // namespace ridgeline::io
