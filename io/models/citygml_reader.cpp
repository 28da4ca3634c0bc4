// SPDX-License-Identifier: BSD-3-Clause
#include "io/error.h"
#include "io/models/axis_order.h"
#include "io/models/building_attributes.h"
#include "io/models/building_faces.h"
#include "io/models/citygml_names.h"
#include "io/models/gml_surfaces.h"
#include "io/models/readers.h"
#include "io/models/srs_name.h"
#include "io/models/xml_stream.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace ridgeline::io {
namespace {

using citygml::Property;

constexpr LeftOutKind kImplicitGeometry{"implicit geometry", "implicit geometries"};
constexpr LeftOutKind kCurveOfBuilding{"building curve", "building curves"};
constexpr LeftOutKind kAddressPoint{"address point", "address points"};

/// The role of an element for the reader, which follows from its name and the role of its parent.
enum class ElementRole : std::uint8_t {
  kDocument,
  kModel,
  kMembers,    ///< contains top-level objects
  kBuilding,   ///< also a part or an installation
  kSurface,    ///< RoofSurface, Window, ...
  kToSurface,  ///< a property that contains a surface; the others likewise
  kToOpening,
  kToPart,
  kToInstallation,
  kToInside,
  kGeometry,  ///< a geometry property and all elements in it
  kBounds,
  kAddress,
  kAttributes,
  kAttribute,
  kAttributeName,
  kWord,  ///< contains text: a simple attribute, or the value of a generic one
  kSkipped,
};

struct Element {
  ElementRole role = ElementRole::kSkipped;
  std::string name;
  std::string surface_id;              ///< of a surface
  FaceKind kind = FaceKind::kUnknown;  ///< of the faces in it
  bool is_top = false;                 ///< the building itself, not a part or an installation
  bool is_thematic = false;            ///< see GeometryProperty
  bool is_extra = false;               ///< see GeometryProperty
  bool is_property = false;            ///< the geometry property itself
  std::size_t part = 0;
};

/// The generic attribute being read.
struct ReadAttribute {
  std::string name, word;
};

class CityGmlReader {
 public:
  CityGmlReader(const std::string& path, const ReadModelOptions& options)
      : options_(options),
        lods_(options.lod),
        stream_(path,
                {.start = [this](const XmlName& name,
                                 const XmlAttributes& attributes) { start(name, attributes); },
                 .text = [this](std::string_view piece) { text(piece); },
                 .end = [this] { end(); }}),
        surfaces_(stream_, model_.left_out),
        attributes_(model_.attributes) {
    model_.path = path;
    elements_.emplace_back().role = ElementRole::kDocument;
  }

  BuildingModel read() {
    stream_.read();
    if (model_.format.empty()) throw IoError(model_.path, "has no CityGML objects");
    resolve(open_, model_);
    settle_crs();
    settle_types(model_.attributes);
    std::ranges::move(lods_.warnings(), std::back_inserter(model_.warnings));
    if (!options_.lod.empty() && model_.faces.empty() && !model_.buildings.empty()) {
      model_.warnings.push_back(fmt::format(
          "no building has faces of LoD {}; CityGML has the levels 1, 2 and 3", options_.lod));
    }
    return std::move(model_);
  }

 private:
  void start(const XmlName& name, const XmlAttributes& attributes) {
    const ElementRole parent = elements_.back().role;
    if (parent == ElementRole::kGeometry || parent == ElementRole::kSkipped) {
      elements_.emplace_back().role = parent;  // most elements of a file
    } else {
      Element element = inherited(elements_.back());
      element.name = name.local;
      element.role = role_in(elements_.back(), element, name, attributes);
      elements_.push_back(std::move(element));
    }
    const ElementRole role = elements_.back().role;
    if (role == ElementRole::kGeometry) surfaces_.start(name, attributes);
    if (role == ElementRole::kGeometry || role == ElementRole::kBounds) {
      note_srs_name(attributes.value("srsName"));
    }
  }

  static Element inherited(const Element& parent) {
    Element element = parent;
    element.is_property = false;
    return element;
  }

  ElementRole role_in(const Element& parent,
                      Element& element,
                      const XmlName& name,
                      const XmlAttributes& attributes) {
    using enum ElementRole;
    switch (parent.role) {
      case kDocument:
        return begin_document(name);
      case kModel:
        return role_in_model(name);
      case kMembers:
        return begin_top_object(element, name, attributes);
      case kBuilding:
      case kSurface:
        return begin_property(parent, element, name, attributes);
      case kToSurface:
        return begin_surface(element, attributes, citygml::kind_of_surface(name.local));
      case kToOpening:
        element.is_extra = true;
        return begin_surface(element, attributes, FaceKind::kOther);
      case kToPart:
        return begin_part(element, attributes);
      case kToInstallation:
        element.is_extra = true;
        element.kind = FaceKind::kOther;
        return begin_part(element, attributes);
      case kToInside:
        return skip_object(name);
      case kBounds:
        return kBounds;
      case kAddress:
        if (name.local == "Point") model_.left_out.add(kAddressPoint);
        return kAddress;
      case kAttributes:
      case kAttribute:
        return role_in_attributes(parent, name, attributes);
      default:
        return kSkipped;
    }
  }

  ElementRole begin_document(const XmlName& name) {
    const std::string_view version = citygml::version_of(name.space);
    const bool is_answer = name.local == "FeatureCollection";  // from a WFS
    if (!is_answer && (name.local != "CityModel" || version.empty())) {
      throw IoError(stream_.place(), fmt::format("is not CityGML: its root is <{}> of \"{}\"",
                                                 name.local, name.space));
    }
    note_version(version);
    return ElementRole::kModel;
  }

  void note_version(std::string_view version) {
    if (model_.format.empty() && !version.empty())
      model_.format = fmt::format("CityGML {}", version);
  }

  static ElementRole role_in_model(const XmlName& name) {
    constexpr std::array<std::string_view, 5> kMembers{"cityObjectMember", "featureMember",
                                                       "featureMembers", "member", "members"};
    if (name.local == "boundedBy") return ElementRole::kBounds;
    const bool holds_objects = std::ranges::find(kMembers, name.local) != kMembers.end();
    return holds_objects ? ElementRole::kMembers : ElementRole::kSkipped;
  }

  ElementRole begin_top_object(Element& element,
                               const XmlName& name,
                               const XmlAttributes& attributes) {
    if (name.local == "FeatureCollection" || name.local == "CityModel") return ElementRole::kModel;
    if (name.local == "Appearance") return ElementRole::kSkipped;  // textures
    if (!citygml::is_building(name)) return skip_object(name);
    note_version(citygml::version_of(name.space));
    model_.buildings.push_back({std::string(attributes.value("id", kGmlSpace)), {}});
    attributes_.begin_row();
    part_ids_ = {model_.buildings.back().id};
    element.is_top = true;
    return ElementRole::kBuilding;
  }

  ElementRole skip_object(const XmlName& name) {
    const std::string one = fmt::format("{} object", name.local);
    const std::string several = one + "s";
    model_.left_out.add({one, several});
    return ElementRole::kSkipped;
  }

  ElementRole begin_surface(Element& element, const XmlAttributes& attributes, FaceKind kind) {
    element.kind = kind;
    element.surface_id = attributes.value("id", kGmlSpace);
    element.is_thematic = true;
    return ElementRole::kSurface;
  }

  ElementRole begin_part(Element& element, const XmlAttributes& attributes) {
    element.part = part_ids_.size();
    part_ids_.emplace_back(attributes.value("id", kGmlSpace));
    element.is_top = false;
    return ElementRole::kBuilding;
  }

  ElementRole begin_property(const Element& owner,
                             Element& element,
                             const XmlName& name,
                             const XmlAttributes& attributes) {
    using enum ElementRole;
    switch (citygml::property_of(name)) {
      case Property::kGeometry:
        return begin_geometry(owner, element);
      case Property::kImplicit:
        model_.left_out.add(kImplicitGeometry);
        return kSkipped;
      case Property::kCurve:
        model_.left_out.add(kCurveOfBuilding);
        return kSkipped;
      case Property::kBounds:
        return kBounds;
      case Property::kSurface:
        return owner.role == kBuilding ? kToSurface : kSkipped;
      case Property::kOpening:
        return kToOpening;
      case Property::kPart:
        return kToPart;
      case Property::kInstallation:
        return kToInstallation;
      case Property::kInside:
        return kToInside;
      case Property::kAddress:
        return kAddress;
      case Property::kAttributes:
        return owner.is_top && owner.role == kBuilding ? kAttributes : kSkipped;
      case Property::kAttribute:
        return begin_attribute(owner, attributes);
      case Property::kSimple:
        return owner.is_top && owner.role == kBuilding ? begin_word() : kSkipped;
      case Property::kForeign:
        return kSkipped;
    }
    return kSkipped;
  }

  ElementRole begin_geometry(const Element& owner, Element& element) {
    element.is_property = true;
    if (!owner.is_thematic && owner.kind == FaceKind::kUnknown)
      element.kind = citygml::kind_of_geometry(element.name);
    GeometryProperty property;
    property.lod = citygml::lod_of(element.name).value_or(0);
    property.kind = element.kind;
    property.surface_id = element.surface_id;
    property.is_thematic = element.is_thematic;
    property.is_extra = element.is_extra;
    property.part = element.part;
    property.surfaces.first = surfaces_.surfaces().size();
    properties_.push_back(std::move(property));
    return ElementRole::kGeometry;
  }

  ElementRole begin_attribute(const Element& owner, const XmlAttributes& attributes) {
    if (!owner.is_top || owner.role == ElementRole::kSurface) return ElementRole::kSkipped;
    attribute_ = {std::string(attributes.value("name")), {}};
    return ElementRole::kAttribute;
  }

  ElementRole role_in_attributes(const Element& parent,
                                 const XmlName& name,
                                 const XmlAttributes& attributes) {
    if (parent.role == ElementRole::kAttributes) {
      const Property property = citygml::property_of(name);
      if (property == Property::kAttributes) return ElementRole::kAttributes;
      return property == Property::kAttribute ? begin_attribute(parent, attributes)
                                              : ElementRole::kSkipped;
    }
    if (name.local != "name" && name.local != "value") return ElementRole::kSkipped;
    begin_word();
    return name.local == "name" ? ElementRole::kAttributeName : ElementRole::kWord;
  }

  ElementRole begin_word() {
    word_.clear();
    return ElementRole::kWord;
  }

  void text(std::string_view piece) {
    constexpr std::size_t kMaxWord_bytes = 1U << 20U;
    const ElementRole role = elements_.back().role;
    if (role == ElementRole::kGeometry) surfaces_.text(piece);
    if (role != ElementRole::kWord && role != ElementRole::kAttributeName) return;
    word_ += piece;
    if (word_.size() > kMaxWord_bytes) {
      throw IoError(stream_.place(),
                    fmt::format("<{}> has more than 1 MiB of text", elements_.back().name));
    }
  }

  void end() {
    const Element element = std::move(elements_.back());
    elements_.pop_back();
    switch (element.role) {
      case ElementRole::kGeometry:
        surfaces_.end();
        if (element.is_property) properties_.back().surfaces.end = surfaces_.surfaces().size();
        break;
      case ElementRole::kAttributeName:
        attribute_.name = std::move(word_);
        break;
      case ElementRole::kWord:
        end_word(element);
        break;
      case ElementRole::kAttribute:
        attributes_.add(attribute_.name, attribute_.word, citygml::type_of_attribute(element.name));
        break;
      case ElementRole::kBuilding:
        if (element.is_top) end_building();
        break;
      default:
        break;
    }
  }

  void end_word(const Element& element) {
    if (elements_.back().role == ElementRole::kAttribute) {
      attribute_.word = std::exchange(word_, {});
    } else {
      attributes_.add(element.name, word_, type_of_word(word_));
      word_.clear();
    }
  }

  void end_building() {
    append_faces(surfaces_, properties_, part_ids_, lods_, model_, open_);
    surfaces_.clear();
    properties_.clear();
  }

  void note_srs_name(std::string_view name) {
    constexpr std::size_t kMaxNames = 8;
    if (name.empty() || std::ranges::find(srs_names_, name) != srs_names_.end()) return;
    if (srs_names_.size() < kMaxNames) srs_names_.emplace_back(name);
  }

  /// All names must refer to one CRS; that of the first name is used, or that of the first with
  /// heights.
  void settle_crs() {
    bool keeps_axis_order = false;
    for (const std::string& name : srs_names_) {
      const SrsName srs = read_srs_name(name);
      if (!srs.warning.empty()) model_.warnings.push_back(srs.warning);
      if (!srs.crs.known()) continue;
      const CrsAgreement agreement = compare(model_.crs, srs.crs);
      if (model_.crs.known() && !agreement.compatible) {
        throw IoError(model_.path, "has two reference systems: " + agreement.reason);
      }
      const bool adds_heights = model_.crs.known() && describe(model_.crs).vertical_name.empty() &&
                                !describe(srs.crs).vertical_name.empty();
      if (!model_.crs.known()) keeps_axis_order = srs.keeps_axis_order;
      if (!model_.crs.known() || adds_heights) model_.crs = srs.crs;
    }
    if (srs_names_.empty()) {
      model_.warnings.push_back("has no reference system (srsName): assuming that of the cloud");
    }
    settle_axis_order(keeps_axis_order, model_);
  }

  ReadModelOptions options_;
  LodChoice lods_;
  BuildingModel model_;
  XmlStream stream_;
  GmlSurfaces surfaces_;  ///< of the building being read
  BuildingAttributes attributes_;
  std::vector<Element> elements_;  ///< from the document to the element being read
  std::vector<GeometryProperty> properties_;
  std::vector<OpenReference> open_;
  std::vector<std::string> srs_names_;
  ReadAttribute attribute_;
  std::string word_;
  std::vector<std::string> part_ids_;  ///< of the building, its parts and installations
};

}  // namespace

BuildingModel read_citygml(const std::string& path, const ReadModelOptions& options) {
  return CityGmlReader(path, options).read();
}

}  // namespace ridgeline::io
