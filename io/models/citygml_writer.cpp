// SPDX-License-Identifier: BSD-3-Clause
#include "io/models/model_writers.h"
#include "io/text/utf8.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <variant>

namespace ridgeline::io {
namespace {

constexpr const char* kHead =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<core:CityModel xmlns:core=\"http://www.opengis.net/citygml/2.0\" "
    "xmlns:bldg=\"http://www.opengis.net/citygml/building/2.0\" "
    "xmlns:gen=\"http://www.opengis.net/citygml/generics/2.0\" "
    "xmlns:gml=\"http://www.opengis.net/gml\">\n";

/// Text for XML, which allows no control characters except whitespace.
std::string xml_text(std::string_view text) {
  std::string result;
  for (const char c : as_utf8(text)) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else if (c == '"') {
      result += "&quot;";
    } else if (code < 0x20U) {
      result += c == '\t' || c == '\n' || c == '\r' ? fmt::format("&#{};", code) : "?";
    } else {
      result += c;
    }
  }
  return result;
}

/// An id that is valid in XML: it begins with a letter or "_" and has no blanks or colons.
std::string xml_id(const std::string& id) {
  const auto is_letter = [](char c) {
    return c == '_' || std::isalpha(static_cast<unsigned char>(c)) != 0;
  };
  const auto is_inner = [&](char c) {
    return is_letter(c) || std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '-' ||
           c == '.' || static_cast<unsigned char>(c) >= 0x80U;
  };
  const bool is_name = is_letter(id.front()) && std::ranges::all_of(id, is_inner);
  if (is_name) return as_utf8(id);
  std::string made = "id_";
  for (const char c : as_utf8(id)) made += is_inner(c) ? c : '_';
  return made;
}

/// A coordinate written from its whole thousandths, so that formatting cannot round it again.
std::string thousandths_text(double coordinate) {
  const long long n = in_thousandths(coordinate);
  const auto size = static_cast<unsigned long long>(n < 0 ? -n : n);
  return fmt::format("{}{}.{:03}", n < 0 ? "-" : "", size / 1000U, size % 1000U);
}

std::string ring_text(const Ring& ring, const char* role) {
  std::string positions;
  for (std::size_t i = 0; i <= ring.size(); ++i) {  // the first vertex closes the ring
    const Eigen::Vector3d& x = ring[i % ring.size()];
    positions += fmt::format("{}{} {} {}", i == 0 ? "" : " ", thousandths_text(x.x()),
                             thousandths_text(x.y()), thousandths_text(x.z()));
  }
  return fmt::format(
      "<gml:{0}><gml:LinearRing><gml:posList "
      "srsDimension=\"3\">{1}</gml:posList></gml:LinearRing></gml:{0}>",
      role, positions);
}

std::string member_text(const Face& face) {
  const std::string id = face.id.empty() ? "" : fmt::format(" gml:id=\"{}\"", face.id);
  std::string rings;
  for (std::size_t i = 0; i < face.rings.size(); ++i)
    rings += ring_text(face.rings[i], i == 0 ? "exterior" : "interior");
  return fmt::format("<gml:surfaceMember><gml:Polygon{}>{}</gml:Polygon></gml:surfaceMember>", id,
                     rings);
}

std::string multi_surface_text(int lod, const std::string& members) {
  return fmt::format(
      "<bldg:lod{0}MultiSurface><gml:MultiSurface>{1}</gml:MultiSurface></bldg:lod{0}MultiSurface>",
      lod, members);
}

/// The level of detail of a building's faces; thematic surfaces begin with LoD 2.
int lod_of_building(const Building& building, std::span<const Face> faces) {
  const bool has_digit = !building.lod.empty() && building.lod[0] >= '1' && building.lod[0] <= '4';
  const int lod = has_digit ? building.lod[0] - '0' : 2;
  const bool is_thematic =
      std::ranges::any_of(faces, [](const Face& face) { return face.kind != FaceKind::kUnknown; });
  return is_thematic ? std::max(lod, 2) : lod;
}

std::string faces_text(const Building& building, std::span<const Face> faces) {
  const int lod = lod_of_building(building, faces);
  std::string members;
  for (const Face& face : faces) {
    if (face.kind == FaceKind::kUnknown) members += member_text(face);
  }
  std::string text;
  if (!members.empty()) text += multi_surface_text(lod, members) + "\n";
  for (const Face& face : faces) {
    if (face.kind == FaceKind::kUnknown) continue;
    text += fmt::format("<bldg:boundedBy><bldg:{0}>{1}</bldg:{0}></bldg:boundedBy>\n",
                        surface_name(face.kind), multi_surface_text(lod, member_text(face)));
  }
  return text;
}

std::string attribute_text(const std::string& name, const Value& value) {
  const auto text_of = [&](const char* type, const std::string& word) {
    return fmt::format(
        "<gen:{0}Attribute name=\"{1}\"><gen:value>{2}</gen:value></gen:{0}Attribute>\n", type,
        xml_text(name), word);
  };
  if (const auto* const n = std::get_if<std::int64_t>(&value))
    return text_of("int", fmt::format("{}", *n));
  if (const auto* const x = std::get_if<double>(&value))
    return text_of("double", fmt::format("{}", *x));
  if (const auto* const text = std::get_if<std::string>(&value))
    return text_of("string", xml_text(*text));
  return "";
}

std::string srs_name(const Crs& crs) {
  const EpsgCodes codes = epsg_codes_of(crs);
  if (codes.whole) return "urn:ogc:def:crs:EPSG::" + *codes.whole;
  if (codes.plane && codes.heights)
    return fmt::format("urn:ogc:def:crs,crs:EPSG::{},crs:EPSG::{}", *codes.plane, *codes.heights);
  return codes.plane ? "urn:ogc:def:crs:EPSG::" + *codes.plane : "";
}

/// The box of all faces, with the CRS if it has a name; empty without faces.
std::string envelope_text(const BuildingModel& model) {
  if (model.faces.empty()) return "";
  Eigen::Vector3d low = model.faces[0].rings[0][0];
  Eigen::Vector3d high = low;
  for (const Face& face : model.faces) {
    for (const Eigen::Vector3d& vertex : face.rings[0]) {
      low = low.cwiseMin(vertex);
      high = high.cwiseMax(vertex);
    }
  }
  const auto corner = [](const Eigen::Vector3d& x) {
    return fmt::format("{} {} {}", thousandths_text(x.x()), thousandths_text(x.y()),
                       thousandths_text(x.z()));
  };
  const std::string name = srs_name(model.crs);
  return fmt::format(
      "<gml:boundedBy><gml:Envelope{} "
      "srsDimension=\"3\"><gml:lowerCorner>{}</gml:lowerCorner><gml:upperCorner>{}</"
      "gml:upperCorner></gml:Envelope></gml:boundedBy>\n",
      name.empty() ? "" : fmt::format(" srsName=\"{}\"", name), corner(low), corner(high));
}

/// The model with ids that are valid in XML and unique in the document. A face whose id is already
/// taken gets none.
BuildingModel with_xml_ids(BuildingModel model) {
  std::set<std::string> taken;
  for (Building& building : model.buildings) {
    const std::string id = xml_id(building.id);
    building.id = id;
    for (int n = 1; !taken.insert(building.id).second; ++n)
      building.id = fmt::format("{}_{}", id, n);
  }
  for (Face& face : model.faces) {
    if (face.id.empty()) continue;
    face.id = xml_id(face.id);
    if (!taken.insert(face.id).second) face.id.clear();
  }
  return model;
}

}  // namespace

void write_citygml(const BuildingModel& stated, std::ostream& stream) {
  const BuildingModel model = with_xml_ids(stated);
  stream << kHead << envelope_text(model);
  std::size_t first = 0;
  for (std::size_t i = 0; i < model.buildings.size(); ++i) {
    std::size_t end = first;
    while (end < model.faces.size() && model.faces[end].building == i) ++end;
    stream << fmt::format("<core:cityObjectMember><bldg:Building gml:id=\"{}\">\n",
                          model.buildings[i].id);
    for (const auto& [column, value] : model.attributes.rows[i])
      stream << attribute_text(model.attributes.columns[column].name, value);
    stream << faces_text(model.buildings[i], {model.faces.data() + first, end - first})
           << "</bldg:Building></core:cityObjectMember>\n";
    first = end;
  }
  stream << "</core:CityModel>\n";
}

}  // namespace ridgeline::io
