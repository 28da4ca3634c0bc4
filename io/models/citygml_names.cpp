// SPDX-License-Identifier: BSD-3-Clause
#include "io/models/citygml_names.h"

#include "io/models/gml_surfaces.h"
#include "io/text/text.h"

#include <algorithm>
#include <array>

namespace ridgeline::io::citygml {
namespace {

constexpr std::string_view kSpace = "http://www.opengis.net/citygml/";

struct NamedProperty {
  std::string_view local;
  Property property;
};

constexpr std::array kNamed{
    NamedProperty{"boundedBy", Property::kSurface},
    NamedProperty{"boundary", Property::kSurface},
    NamedProperty{"opening", Property::kOpening},
    NamedProperty{"fillingSurface", Property::kOpening},
    NamedProperty{"consistsOfBuildingPart", Property::kPart},
    NamedProperty{"buildingPart", Property::kPart},
    NamedProperty{"outerBuildingInstallation", Property::kInstallation},
    NamedProperty{"buildingInstallation", Property::kInstallation},
    NamedProperty{"interiorBuildingInstallation", Property::kInside},
    NamedProperty{"interiorRoom", Property::kInside},
    NamedProperty{"buildingRoom", Property::kInside},
    NamedProperty{"buildingFurniture", Property::kInside},
    NamedProperty{"buildingConstructiveElement", Property::kInside},
    NamedProperty{"buildingSubdivision", Property::kInside},
    NamedProperty{"address", Property::kAddress},
    NamedProperty{"genericAttribute", Property::kAttributes},
    NamedProperty{"genericAttributeSet", Property::kAttributes},
    NamedProperty{"GenericAttributeSet", Property::kAttributes},
};

Property property_with_lod(std::string_view name) {
  constexpr std::array<std::string_view, 6> kGeometries{
      "Solid", "MultiSurface", "CompositeSurface", "Geometry", "FootPrint", "RoofEdge"};
  if (name.find("Implicit") != std::string_view::npos) return Property::kImplicit;
  if (std::ranges::find(kGeometries, name) != kGeometries.end()) return Property::kGeometry;
  return Property::kCurve;
}

bool is_generic_attribute(std::string_view local) {
  constexpr std::array<std::string_view, 7> kTypes{"string", "int",     "double", "date",
                                                   "uri",    "measure", "code"};
  const std::string lower = lower_case(local);
  return std::ranges::any_of(
      kTypes, [&](std::string_view type) { return lower == std::string(type) + "attribute"; });
}

}  // namespace

Property property_of(const XmlName& name) {
  if (name.space.starts_with(kGmlSpace))
    return name.local == "boundedBy" ? Property::kBounds : Property::kSimple;
  if (!name.space.starts_with(kSpace)) return Property::kForeign;
  if (lod_of(name.local)) return property_with_lod(name.local.substr(4));
  const auto named = std::ranges::find(kNamed, name.local, &NamedProperty::local);
  if (named != kNamed.end()) return named->property;
  return is_generic_attribute(name.local) ? Property::kAttribute : Property::kSimple;
}

std::optional<int> lod_of(std::string_view local) {
  if (!local.starts_with("lod") || local.size() < 5 || local[3] < '0' || local[3] > '4')
    return std::nullopt;
  return local[3] - '0';
}

FaceKind kind_of_geometry(std::string_view local) {
  if (local.ends_with("FootPrint")) return FaceKind::kGround;
  if (local.ends_with("RoofEdge")) return FaceKind::kOther;  // a level outline at the eaves
  return FaceKind::kUnknown;
}

FaceKind kind_of_surface(std::string_view local) {
  if (local == "RoofSurface") return FaceKind::kRoof;
  if (local == "WallSurface") return FaceKind::kWall;
  if (local == "GroundSurface") return FaceKind::kGround;
  return FaceKind::kOther;
}

ColumnType type_of_attribute(std::string_view local) {
  const std::string lower = lower_case(local);
  if (lower.starts_with("int")) return ColumnType::kInteger64;
  if (lower.starts_with("double") || lower.starts_with("measure")) return ColumnType::kReal;
  return ColumnType::kText;
}

bool is_building(const XmlName& name) {
  return name.space.starts_with(kSpace) &&
         (name.local == "Building" || name.local == "BuildingPart");
}

std::string_view version_of(std::string_view space) {
  if (!space.starts_with(kSpace)) return {};
  return space.substr(space.rfind('/') + 1);
}

}  // namespace ridgeline::io::citygml
