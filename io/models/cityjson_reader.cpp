// SPDX-License-Identifier: BSD-3-Clause
// CityJSON 1.0, 1.1 and 2.0 (https://www.cityjson.org/specs), one document or a sequence of
// features.
#include "io/error.h"
#include "io/gdal/json_columns.h"
#include "io/models/cityjson_text.h"
#include "io/models/lod.h"
#include "io/models/readers.h"
#include "io/models/srs_name.h"
#include "io/text/json_text.h"
#include "reconstruct/geometry/transformed.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace ridgeline::io {
namespace {

using nlohmann::json;

constexpr LeftOutKind kUnusableFace{"face without three vertices", "faces without three vertices"};
constexpr LeftOutKind kNoSurface{"geometry without surfaces", "geometries without surfaces"};
constexpr LeftOutKind kUnknownTemplate{"unknown geometry template", "unknown geometry templates"};

const json& member(const json& object, const char* name) {
  static const json nothing;
  const auto found = object.is_object() ? object.find(name) : object.end();
  return found == object.end() ? nothing : *found;
}

/// Empty if the member is missing or is neither text nor a number, or if `object` is not an object.
std::string text_member(const json& object, const char* name) {
  const json& value = member(object, name);
  if (value.is_string()) return value.get<std::string>();
  return value.is_number() ? json_text(value) : std::string();
}

double number_of(const json& value, const std::string& where) {
  if (!value.is_number()) throw IoError(where, excerpt(value) + " must be a number");
  return value.get<double>();
}

Eigen::Vector3d vector_of(const json& value, const std::string& where) {
  if (!value.is_array() || value.size() != 3)
    throw IoError(where, excerpt(value) + " must be three numbers");
  return {number_of(value[0], where), number_of(value[1], where), number_of(value[2], where)};
}

/// Coordinates of the file are scale * vertex + translation.
struct Transform {
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
};

Transform transform_of(const json& document, const std::string& where) {
  const json& stated = member(document, "transform");
  if (stated.is_null()) return {};
  return {vector_of(member(stated, "scale"), where + ": transform.scale"),
          vector_of(member(stated, "translate"), where + ": transform.translate")};
}

std::vector<Eigen::Vector3d> vertices_of(const json& list,
                                         const Transform& transform,
                                         const std::string& where) {
  if (!list.is_array()) throw IoError(where, "has no array \"vertices\"");
  std::vector<Eigen::Vector3d> vertices;
  vertices.reserve(list.size());
  for (const json& vertex : list) {
    const Eigen::Vector3d stated =
        vector_of(vertex, fmt::format("{}: vertex {}", where, vertices.size()));
    vertices.emplace_back(stated.cwiseProduct(transform.scale) + transform.translation);
  }
  return vertices;
}

FaceKind kind_of_surface(const std::string& type) {
  if (type == "RoofSurface") return FaceKind::kRoof;
  if (type == "WallSurface") return FaceKind::kWall;
  if (type == "GroundSurface") return FaceKind::kGround;
  return FaceKind::kOther;
}

/// The nesting depth of one face's list of rings in `boundaries`, 1 for "MultiSurface";
/// std::nullopt for a geometry without surfaces.
std::optional<int> depth_of_faces(const std::string& type) {
  static const std::map<std::string, int> depths{{"MultiSurface", 1},
                                                 {"CompositeSurface", 1},
                                                 {"Solid", 2},
                                                 {"MultiSolid", 3},
                                                 {"CompositeSolid", 3}};
  const auto found = depths.find(type);
  return found == depths.end() ? std::nullopt : std::optional(found->second);
}

/// Vertices of a geometry, and their placement.
struct PlacedGeometry {
  const std::vector<Eigen::Vector3d>* vertices;
  Eigen::Affine3d world_from_vertices = Eigen::Affine3d::Identity();
};

/// The city objects of a document, or of a feature, as faces of buildings.
class ObjectReader {
 public:
  ObjectReader(BuildingModel& model, const ReadModelOptions& options, std::size_t n_bytes)
      : model_(model), lods_(options.lod), vertices_left_(std::max(kMinVertices, n_bytes)) {}

  /// Templates are those of the document that the feature belongs to.
  void set_templates(const json& document) {
    const json& templates = member(document, "geometry-templates");
    if (templates.is_null()) return;
    templates_ = member(templates, "templates");
    const std::string where = model_.path + ": geometry-templates";
    template_vertices_ = vertices_of(member(templates, "vertices-templates"), {}, where);
  }

  [[nodiscard]] std::vector<std::string> lod_warnings() const { return lods_.warnings(); }

  void read(const json& objects, const std::vector<Eigen::Vector3d>& vertices) {
    if (!objects.is_object()) throw IoError(model_.path, "has no object \"CityObjects\"");
    for (const auto& [id, members] : buildings_of(objects)) read_building(id, members, vertices);
  }

 private:
  struct Member {
    std::string id;
    const json* object = nullptr;
  };
  using Members = std::vector<Member>;  ///< a building and its parts

  /// Buildings by id, with their parts; all other objects are counted.
  std::map<std::string, Members> buildings_of(const json& objects) {
    std::map<std::string, Members> buildings;
    for (const auto& [id, object] : objects.items()) {
      const std::string type = text_member(object, "type");
      if (type != "Building" && type != "BuildingPart") {
        model_.left_out.add(LeftOutKind{type, type});
        continue;
      }
      Members& members = buildings[root_of(id, objects)];
      members.insert(type == "Building" ? members.begin() : members.end(), {id, &object});
    }
    return buildings;
  }

  /// The building to which an object belongs, through any number of parts; the object itself if it
  /// is not a part.
  static std::string root_of(const std::string& id, const json& objects) {
    constexpr int kMaxDepth = 16;  // parts that are parts of themselves have no root
    std::string root = id;
    for (int depth = 0; depth < kMaxDepth; ++depth) {
      const json& parents = member(member(objects, root.c_str()), "parents");
      const auto parent = std::ranges::find_if(parents, [&](const json& id_of_parent) {
        if (!id_of_parent.is_string()) return false;
        const std::string type =
            text_member(member(objects, id_of_parent.get<std::string>().c_str()), "type");
        return type == "Building" || type == "BuildingPart";  // not a group of buildings
      });
      if (parent == parents.end()) break;
      root = parent->get<std::string>();
    }
    return root;
  }

  void read_building(const std::string& id,
                     const Members& members,
                     const std::vector<Eigen::Vector3d>& vertices) {
    const std::size_t number = model_.buildings.size();
    const auto lods = lods_.choose(transformed(members, [&](const Member& of) {
      return LodObject{of.id, lods_of(*of.object)};
    }));
    const auto highest = std::ranges::max_element(lods);
    model_.buildings.push_back({id, highest->value_or("")});
    model_.attributes.rows.push_back(
        columns_.row_of(member(*members.front().object, "attributes"), model_.attributes));
    where_ = fmt::format("{}: building {}", model_.path, id);
    for (std::size_t i = 0; i < members.size(); ++i) {
      for (const json& geometry : member(*members[i].object, "geometry")) {
        if (text_member(geometry, "type") == "GeometryInstance") {
          read_instance(geometry, lods[i], vertices, number);
        } else {
          read_geometry(geometry, lods[i], {&vertices}, number);
        }
      }
    }
  }

  std::set<std::string> lods_of(const json& object) const {
    std::set<std::string> lods;
    for (const json& geometry : member(object, "geometry")) {
      const bool is_instance = text_member(geometry, "type") == "GeometryInstance";
      const json* const source = is_instance ? template_of(geometry) : &geometry;
      if (source != nullptr && depth_of_faces(text_member(*source, "type")))
        lods.insert(text_member(*source, "lod"));
    }
    return lods;
  }

  const json* template_of(const json& instance) const {
    const json& number = member(instance, "template");
    if (!number.is_number_unsigned() || !templates_.is_array()) return nullptr;
    const auto i = number.get<std::size_t>();
    return i < templates_.size() ? &templates_[i] : nullptr;
  }

  /// A template is placed at a vertex of the file by a 4 x 4 matrix, stored by rows.
  void read_instance(const json& instance,
                     const std::optional<std::string>& lod,
                     const std::vector<Eigen::Vector3d>& vertices,
                     std::size_t building) {
    const json* const geometry = template_of(instance);
    const json& at = member(instance, "boundaries");
    const json& numbers = member(instance, "transformationMatrix");
    const bool is_whole =
        geometry != nullptr && at.is_array() && at.size() == 1 && at[0].is_number_unsigned() &&
        at[0].get<std::size_t>() < vertices.size() && numbers.is_array() && numbers.size() == 16;
    if (!is_whole) return model_.left_out.add(kUnknownTemplate);
    Eigen::Matrix4d matrix;
    for (int i = 0; i < 16; ++i)
      matrix(i / 4, i % 4) =
          number_of(numbers[static_cast<std::size_t>(i)], where_ + ": transformationMatrix");
    PlacedGeometry placed{&template_vertices_};
    placed.world_from_vertices.matrix() = matrix;
    placed.world_from_vertices.pretranslate(vertices[at[0].get<std::size_t>()]);
    read_geometry(*geometry, lod, placed, building);
  }

  void read_geometry(const json& geometry,
                     const std::optional<std::string>& lod,
                     const PlacedGeometry& placed,
                     std::size_t building) {
    const std::optional<int> depth = depth_of_faces(text_member(geometry, "type"));
    if (!depth) return model_.left_out.add(kNoSurface);
    if (text_member(geometry, "lod") != lod) return;
    const json& semantics = member(geometry, "semantics");
    surfaces_ = &member(semantics, "surfaces");
    read_faces(member(geometry, "boundaries"), &member(semantics, "values"), *depth, placed,
               building);
  }

  /// `values` has the shape of `boundaries` down to the faces; null applies to everything below it.
  void read_faces(const json& boundaries,
                  const json* values,
                  int depth,
                  const PlacedGeometry& placed,
                  std::size_t building) {
    if (!boundaries.is_array()) throw IoError(where_, "\"boundaries\" must be nested arrays");
    for (std::size_t i = 0; i < boundaries.size(); ++i) {
      const bool has_value = values->is_array() && i < values->size();
      const json* const value = has_value ? &(*values)[i] : &member(json(), "");
      if (depth > 1) {
        read_faces(boundaries[i], value, depth - 1, placed, building);
      } else {
        add_face(boundaries[i], *value, placed, building);
      }
    }
  }

  void add_face(const json& rings,
                const json& value,
                const PlacedGeometry& placed,
                std::size_t building) {
    Face face;
    face.building = building;
    if (value.is_number_unsigned() && surfaces_->is_array() &&
        value.get<std::size_t>() < surfaces_->size()) {
      const json& surface = (*surfaces_)[value.get<std::size_t>()];
      face.kind = kind_of_surface(text_member(surface, "type"));
      face.id = text_member(surface, "id");
    }
    if (!rings.is_array()) throw IoError(where_, "a face must be an array of rings");
    for (const json& ring : rings) {
      if (std::optional<Ring> read = ring_of(ring, placed)) face.rings.push_back(std::move(*read));
      // Without the outer ring, a hole would be taken for it.
      else if (face.rings.empty())
        return model_.left_out.add(kUnusableFace);
    }
    if (face.rings.empty()) return model_.left_out.add(kUnusableFace);
    model_.faces.push_back(std::move(face));
  }

  /// Returns std::nullopt for fewer than three vertices or if a vertex does not exist.
  std::optional<Ring> ring_of(const json& indices, const PlacedGeometry& placed) {
    if (!indices.is_array() || indices.size() < 3) return std::nullopt;
    if (indices.size() > vertices_left_)
      throw IoError(where_, "the file repeats its vertices or templates over and over");
    vertices_left_ -= indices.size();
    Ring ring;
    for (const json& index : indices) {
      if (!index.is_number_unsigned() || index.get<std::size_t>() >= placed.vertices->size())
        return std::nullopt;
      ring.push_back(placed.world_from_vertices * (*placed.vertices)[index.get<std::size_t>()]);
    }
    return ring;
  }

  static constexpr std::size_t kMinVertices = 1'000'000;

  BuildingModel& model_;
  LodChoice lods_;
  std::size_t vertices_left_;  ///< that faces may still have; small files can repeat them endlessly
  JsonColumns columns_;
  json templates_;
  std::vector<Eigen::Vector3d> template_vertices_;
  std::string where_;
  const json* surfaces_ = nullptr;
};

/// The header of a document or of a sequence.
BuildingModel model_of(const json& document, const std::string& path) {
  const std::string version = text_member(document, "version");
  BuildingModel model;
  model.path = path;
  model.format = "CityJSON " + version;
  const SrsName srs = read_srs_name(text_member(member(document, "metadata"), "referenceSystem"));
  model.crs = srs.crs;
  if (!srs.warning.empty()) model.warnings.push_back(srs.warning);
  if (!version.starts_with("1.") && !version.starts_with("2."))
    model.warnings.push_back(
        fmt::format("version \"{}\" is read as CityJSON 2.0; supported are 1.0 to 2.0", version));
  return model;
}

}  // namespace

BuildingModel read_cityjson(const std::string& path,
                            std::string_view content,
                            const ReadModelOptions& options) {
  BuildingModel model;
  Transform transform;
  std::optional<ObjectReader> reader;
  for_each_cityjson(path, content, [&](const json& document, const std::string& where) {
    if (!reader) {
      model = model_of(document, path);
      transform = transform_of(document, path);
      reader.emplace(model, options, content.size());
      reader->set_templates(document);
    }
    reader->read(member(document, "CityObjects"),
                 vertices_of(member(document, "vertices"), transform, where));
  });
  if (reader) std::ranges::move(reader->lod_warnings(), std::back_inserter(model.warnings));
  if (is_cityjson_sequence(content)) model.format += " in lines";
  settle_types(model.attributes);
  return model;
}

}  // namespace ridgeline::io
