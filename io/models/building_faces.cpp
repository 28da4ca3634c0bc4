// SPDX-License-Identifier: BSD-3-Clause
#include "io/models/building_faces.h"

#include "io/error.h"
#include "io/models/lod.h"
#include "reconstruct/geometry/faces/face_geometry.h"
#include "reconstruct/geometry/transformed.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

namespace ridgeline::io {
namespace {

constexpr LeftOutKind kOpenReference{"reference to a missing surface",
                                     "references to missing surfaces"};

/// The levels of detail in which the building, its parts and installations have faces of their own.
std::vector<LodObject> lod_objects(const std::vector<GeometryProperty>& properties,
                                   const std::vector<std::string>& ids) {
  std::vector<LodObject> objects = transformed(ids, [](const std::string& id) {
    return LodObject{id, {}};
  });
  for (const GeometryProperty& property : properties) {
    const bool is_empty = property.surfaces.first == property.surfaces.end;
    if (!is_empty && !property.is_extra)
      objects[property.part].lods.insert(std::to_string(property.lod));
  }
  return objects;
}

/// Chooses the polygons of one building that become faces.
class FaceChoice {
 public:
  struct Chosen {
    std::size_t surface = 0;
    bool is_reversed = false;
    const GeometryProperty* property = nullptr;
  };

  FaceChoice(const GmlSurfaces& surfaces, std::size_t building, std::vector<OpenReference>& open)
      : surfaces_(surfaces),
        building_(building),
        open_(open),
        is_taken_(surfaces.surfaces().size(), 0) {}

  void add(const GeometryProperty& property) {
    push(property.surfaces, false);
    while (!todo_.empty()) {
      const auto [place, is_turned] = todo_.back();
      todo_.pop_back();
      visit(place, is_turned, property);
    }
  }

  /// In the order of the file.
  std::vector<Chosen> take() {
    std::ranges::sort(chosen_, {}, &Chosen::surface);
    return std::move(chosen_);
  }

 private:
  struct Visit {
    std::size_t place = 0;
    bool is_turned = false;
  };

  void push(const SurfaceRange& range, bool is_turned) {
    for (std::size_t i = range.end; i > range.first; --i) todo_.push_back({i - 1, is_turned});
  }

  /// Each surface and each reference is taken once, so circular references end.
  void visit(std::size_t place, bool is_turned, const GeometryProperty& property) {
    if (std::exchange(is_taken_[place], 1) != 0) return;
    const GmlSurface& surface = surfaces_.surfaces()[place];
    const bool is_reversed = surface.is_reversed != is_turned;
    if (surface.reference.empty()) {
      if (property.is_thematic || !repeats_face(surface, property.part)) {
        chosen_.push_back({place, is_reversed, &property});
      }
    } else if (const SurfaceRange* const named = surfaces_.with_id(surface.reference)) {
      push(*named, is_reversed);
    } else {
      open_.push_back({surface.reference, building_, property.kind});
    }
  }

  bool repeats_face(const GmlSurface& surface, std::size_t part) {
    for (; n_outlined_ < chosen_.size(); ++n_outlined_) {
      const Chosen& chosen = chosen_[n_outlined_];
      outlines_.emplace(chosen.property->part,
                        outline_of(surfaces_.surfaces()[chosen.surface].rings[0]));
    }
    return outlines_.contains({part, outline_of(surface.rings[0])});
  }

  const GmlSurfaces& surfaces_;
  std::size_t building_;
  std::vector<OpenReference>& open_;
  std::vector<char> is_taken_;
  std::vector<Visit> todo_;
  std::vector<Chosen> chosen_;
  std::size_t n_outlined_ = 0;                          ///< number of `chosen_` in `outlines_`
  std::set<std::pair<std::size_t, Outline>> outlines_;  ///< with the part that they belong to
};

std::size_t num_vertices(const Face& face) {
  std::size_t n = 0;
  for (const Ring& ring : face.rings) n += ring.size();
  return n;
}

void reverse_rings(Face& face) {
  for (Ring& ring : face.rings) std::ranges::reverse(ring);
}

}  // namespace

void append_faces(const GmlSurfaces& surfaces,
                  const std::vector<GeometryProperty>& properties,
                  const std::vector<std::string>& ids,
                  LodChoice& choice_of_lods,
                  BuildingModel& model,
                  std::vector<OpenReference>& open) {
  const auto lods = choice_of_lods.choose(lod_objects(properties, ids));
  const std::optional<std::string> highest = std::ranges::max(lods);
  if (!highest) return;
  model.buildings.back().lod = *highest;
  const std::size_t building = model.buildings.size() - 1;
  FaceChoice choice(surfaces, building, open);
  for (const bool thematic : {true, false}) {
    for (const GeometryProperty& property : properties) {
      const std::string& lod = lods[property.part] ? *lods[property.part] : *highest;
      const bool is_left_out = !lods[property.part] && !property.is_extra;
      if (is_left_out || std::to_string(property.lod) != lod) continue;
      if (property.is_thematic == thematic) choice.add(property);
    }
  }
  for (const FaceChoice::Chosen& chosen : choice.take()) {
    const GmlSurface& surface = surfaces.surfaces()[chosen.surface];
    const GeometryProperty& property = *chosen.property;
    Face face{surface.rings, property.kind, building,
              surface.id.empty() ? property.surface_id : surface.id};
    if (chosen.is_reversed) reverse_rings(face);
    model.faces.push_back(std::move(face));
  }
}

void resolve(const std::vector<OpenReference>& open, BuildingModel& model) {
  if (open.empty()) return;
  std::unordered_map<std::string, std::size_t> by_id;
  std::size_t n_vertices_left = 0;
  for (std::size_t i = 0; i < model.faces.size(); ++i) {
    by_id.emplace(model.faces[i].id, i);
    n_vertices_left += num_vertices(model.faces[i]);
  }
  for (const OpenReference& reference : open) {
    const auto found = by_id.find(reference.id);
    if (found == by_id.end()) {
      model.left_out.add(kOpenReference);
      continue;
    }
    Face face = model.faces[found->second];
    const std::size_t n_vertices = num_vertices(face);
    // at most two buildings share a face, so copies have no more vertices than the file
    if (n_vertices > n_vertices_left) {
      throw IoError(model.path, "its buildings refer to the faces of others over and over");
    }
    n_vertices_left -= n_vertices;
    face.building = reference.building;
    if (reference.kind != FaceKind::kUnknown) face.kind = reference.kind;
    model.faces.push_back(std::move(face));
  }
  std::ranges::stable_sort(model.faces, {}, &Face::building);
}

}  // namespace ridgeline::io
