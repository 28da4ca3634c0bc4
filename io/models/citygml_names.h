// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/gdal/attribute_table.h"
#include "io/models/building_model.h"
#include "io/models/xml_stream.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// The meaning of element names in CityGML 1.0 to 3.0.
namespace ridgeline::io::citygml {

/// The kind of property (of a building, part, installation or surface) that an element is.
enum class Property : std::uint8_t {
  kGeometry,      ///< lod2Solid, lod0FootPrint, ...
  kImplicit,      ///< lod2ImplicitRepresentation
  kCurve,         ///< lod2TerrainIntersection, lod2MultiCurve, ...
  kBounds,        ///< gml:boundedBy
  kSurface,       ///< boundedBy, boundary
  kOpening,       ///< opening, fillingSurface
  kPart,          ///< consistsOfBuildingPart, buildingPart
  kInstallation,  ///< outerBuildingInstallation, buildingInstallation
  kInside,        ///< interiorRoom, buildingConstructiveElement, ...
  kAddress,
  kAttributes,  ///< genericAttribute, genericAttributeSet: holds generic attributes
  kAttribute,   ///< stringAttribute, gen:IntAttribute, ...
  kSimple,      ///< of CityGML or GML itself, such as measuredHeight
  kForeign,     ///< of another schema
};

Property property_of(const XmlName& name);

/// The level of detail stated in a name: 2 for "lod2Solid".
std::optional<int> lod_of(std::string_view local);

/// The kind of a building's geometry according to its property: ground for a footprint.
FaceKind kind_of_geometry(std::string_view local);

/// The kind of a thematic surface: kRoof for "RoofSurface", kOther for those that are neither roof,
/// wall nor ground.
FaceKind kind_of_surface(std::string_view local);

/// The type of the value of a generic attribute: "intAttribute" and "IntAttribute" are integers.
ColumnType type_of_attribute(std::string_view local);

bool is_building(const XmlName& name);

/// "2.0" for the namespace of CityGML 2.0 or of one of its modules; empty for others.
std::string_view version_of(std::string_view space);

}  // namespace ridgeline::io::citygml
