// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/mesh_buildings.h"

#include "io/lines/surface_words.h"
#include "reconstruct/geometry/box_index.h"
#include "reconstruct/geometry/disjoint_sets.h"
#include "reconstruct/geometry/faces/face_geometry.h"
#include "reconstruct/geometry/faces/face_seams.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace ridgeline::io {
namespace {

using Names = std::vector<std::string>;  ///< of each face; empty for a face without a name

bool is_steep(const Face& face) {
  const auto plane = plane_of(face);
  return plane && is_wall(*plane);
}

/// Gives the faces the kinds that their names state, if these are roofs and others and no face is
/// without one.
void state_kinds_by_name(const MeshNames& names, std::vector<Face>& faces) {
  const std::vector<FaceKind> of_names = transformed(names.all, [](const FaceNames& stated) {
    for (const std::string* const text : {&stated.group, &stated.object, &stated.material})
      if (const FaceKind kind = surface_kind_in(*text); kind != FaceKind::kUnknown) return kind;
    return FaceKind::kUnknown;
  });
  const auto kinds = transformed(names.of_face, [&](std::size_t i) { return of_names[i]; });
  const std::set<FaceKind> stated(kinds.begin(), kinds.end());
  if (stated.contains(FaceKind::kUnknown) || !stated.contains(FaceKind::kRoof)) return;
  if (stated.size() == 1) return;
  for (std::size_t i = 0; i < faces.size(); ++i) faces[i].kind = kinds[i];
}

/// The words that name buildings: their faces include walls and others.
std::set<std::string> building_words(const MeshNames& names, const std::vector<Face>& faces) {
  struct Surfaces {
    bool has_walls = false, has_others = false;
  };
  std::vector<Surfaces> of_names(names.all.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (!plane_of(faces[i])) continue;
    Surfaces& surfaces = of_names[names.of_face[i]];
    (is_steep(faces[i]) ? surfaces.has_walls : surfaces.has_others) = true;
  }
  std::map<std::string, Surfaces> of_words;
  for (std::size_t i = 0; i < names.all.size(); ++i) {
    for (const std::string* const text : {&names.all[i].group, &names.all[i].object}) {
      for (std::string& word : words_without_surfaces(*text)) {
        Surfaces& surfaces = of_words[std::move(word)];
        surfaces.has_walls = surfaces.has_walls || of_names[i].has_walls;
        surfaces.has_others = surfaces.has_others || of_names[i].has_others;
      }
    }
  }
  std::set<std::string> words;
  for (const auto& [word, surfaces] : of_words)
    if (surfaces.has_walls && surfaces.has_others) words.insert(word);
  return words;
}

/// The name of each face from those words of its group, or else of its object, that `is_taken`
/// accepts.
template <typename IsTaken>
Names names_from(const MeshNames& names, const IsTaken& is_taken) {
  const auto of_names = transformed(names.all, [&](const FaceNames& stated) {
    for (const std::string* const text : {&stated.group, &stated.object}) {
      std::vector<std::string> words = words_without_surfaces(*text);
      std::erase_if(words, [&](const std::string& word) { return !is_taken(word); });
      if (!words.empty()) return fmt::format("{}", fmt::join(words, " "));
    }
    return std::string();
  });
  return transformed(names.of_face, [&](std::size_t i) { return of_names[i]; });
}

/// Joins the faces of each name that are connected.
void join_connected(const std::vector<FaceSeam>& seams, const Names& names, DisjointSets& parts) {
  for (const FaceSeam& seam : seams) {
    std::map<std::string_view, std::size_t> first;
    for (const std::size_t face : seam.faces)
      parts.join(first.try_emplace(names[face], face).first->second, face);
  }
}

/// Joins the parts of a name that meet or cover each other in plan.
class PlanJoin {
 public:
  PlanJoin(const std::vector<Face>& faces, const Names& names, DisjointSets& parts)
      : faces_(faces), names_(names), parts_(parts) {
    std::map<std::string_view, std::set<std::size_t>> parts_of;
    for (std::size_t i = 0; i < faces.size(); ++i)
      if (!names[i].empty()) parts_of[names[i]].insert(parts.name_of(i));
    for (std::size_t i = 0; i < faces.size(); ++i) {
      if (names[i].empty() || parts_of.at(names[i]).size() == 1) continue;
      for (const Ring& ring : faces[i].rings) {
        for (std::size_t k = 0; k < ring.size(); ++k)
          add_edge({ring[k].head<2>(), ring[(k + 1) % ring.size()].head<2>()}, i);
      }
    }
    edge_index_ = BoxIndex2(edges_);
    face_index_ =
        BoxIndex2(transformed(faces, [](const Face& face) { return plan_box_of(face.rings[0]); }));
  }

  void join() {
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const std::size_t face = face_of_edge_[i];
      for (const std::size_t k : edge_index_.near(edges_[i], kNear)) {
        const std::size_t other = face_of_edge_[k];
        if (are_parts_of_one(face, other) && distance(edges_[i], edges_[k]) <= kNear)
          parts_.join(face, other);
      }
    }
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      if (!names_[i].empty() && parts_.name_of(i) == i) join_covering(i);
    }
  }

 private:
  static constexpr double kNear = 0.05, kSame = 0.01;  // units of the file
  using PlanCell = std::pair<double, double>;

  /// Adds an edge in plan, or joins its face to that of an earlier edge at the same place.
  void add_edge(const Segment2& edge, std::size_t face) {
    if (!edge.start.allFinite() || !edge.end.allFinite()) return;
    const auto cell = [](const Eigen::Vector2d& x) {
      return std::pair(std::round(x.x() / kSame), std::round(x.y() / kSame));
    };
    const std::pair<PlanCell, PlanCell> ends = std::minmax(cell(edge.start), cell(edge.end));
    const auto [entry, is_new] = known_.try_emplace({names_[face], ends}, face);
    if (!is_new) return parts_.join(entry->second, face);
    edges_.push_back(edge);
    face_of_edge_.push_back(face);
  }

  [[nodiscard]] bool are_parts_of_one(std::size_t a, std::size_t b) {
    return names_[a] == names_[b] && parts_.name_of(a) != parts_.name_of(b);
  }

  /// Joins a part to those whose faces cover one of its vertices; their edges are apart.
  void join_covering(std::size_t face) {
    const Eigen::Vector2d x = faces_[face].rings[0][0].head<2>();
    for (const std::size_t other : face_index_.near(Eigen::AlignedBox2d(x), 0.0)) {
      if (!are_parts_of_one(face, other)) continue;
      const auto plane = plane_of(faces_[other]);
      if (!plane || is_wall(*plane)) continue;
      if (is_on_face(faces_[other], *plane, {x.x(), x.y(), height_at(*plane, x)}))
        parts_.join(face, other);
    }
  }

  const std::vector<Face>& faces_;
  const Names& names_;
  DisjointSets& parts_;
  std::vector<Segment2> edges_;
  std::vector<std::size_t> face_of_edge_;
  std::map<std::pair<std::string_view, std::pair<PlanCell, PlanCell>>, std::size_t> known_;
  BoxIndex2 edge_index_, face_index_;
};

/// Joins each part without a name to the part with a name that it is connected to, if there is only
/// one.
void join_unnamed(const std::vector<FaceSeam>& seams, const Names& names, DisjointSets& parts) {
  std::map<std::size_t, std::set<std::size_t>> neighbours;
  for (const FaceSeam& seam : seams) {
    std::set<std::size_t> named;
    for (const std::size_t face : seam.faces)
      if (!names[face].empty()) named.insert(parts.name_of(face));
    if (named.empty()) continue;
    for (const std::size_t face : seam.faces)
      if (names[face].empty()) neighbours[parts.name_of(face)].insert(named.begin(), named.end());
  }
  for (const auto& [part, named] : neighbours)
    if (named.size() == 1) parts.join(part, *named.begin());
}

/// The name that all faces of each part share; empty if there is none.
std::map<std::size_t, std::string> common_names(const Names& names, DisjointSets& parts) {
  std::map<std::size_t, std::string> common;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto [entry, is_new] = common.try_emplace(parts.name_of(i), names[i]);
    if (!is_new && entry->second != names[i]) entry->second.clear();
  }
  return common;
}

}  // namespace

void divide_into_buildings(const MeshNames& stated, BuildingModel& model) {
  std::vector<Face>& faces = model.faces;
  Names names(faces.size());
  Names labels(faces.size());
  if (!stated.of_face.empty()) {
    state_kinds_by_name(stated, faces);
    const std::set<std::string> words = building_words(stated, faces);
    names = names_from(stated, [&](const std::string& word) { return words.contains(word); });
    labels = names_from(stated, [](const std::string&) { return true; });
  }
  DisjointSets parts(faces.size());
  const std::vector<FaceSeam> seams = seams_of(faces);
  join_connected(seams, names, parts);
  if (!stated.of_face.empty()) PlanJoin(faces, names, parts).join();
  join_unnamed(seams, names, parts);

  const std::map<std::size_t, std::string> common = common_names(labels, parts);
  std::map<std::size_t, std::size_t> numbers;
  std::size_t n_unnamed = 0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const std::size_t part = parts.name_of(i);
    const auto [entry, is_new] = numbers.try_emplace(part, model.buildings.size());
    faces[i].building = entry->second;
    if (is_new) model.buildings.push_back({common.at(part), ""});
    if (!names[i].empty()) model.buildings[entry->second].id = names[i];
  }
  for (Building& building : model.buildings)
    if (building.id.empty()) building.id = std::to_string(++n_unnamed);
  model.attributes.rows.resize(model.buildings.size());
}

}  // namespace ridgeline::io
