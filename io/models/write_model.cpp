// SPDX-License-Identifier: BSD-3-Clause
#include "io/models/write_model.h"

#include "io/crs/proj_objects.h"
#include "io/files/atomic_file.h"
#include "io/models/model_writers.h"
#include "reconstruct/geometry/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <utility>

namespace ridgeline::io {
namespace {

std::optional<std::string> code_at_epsg(const PJ* crs) {
  if (crs == nullptr) return std::nullopt;
  const char* const authority = proj_get_id_auth_name(crs, 0);
  const char* const code = proj_get_id_code(crs, 0);
  if (authority == nullptr || code == nullptr || std::string_view(authority) != "EPSG")
    return std::nullopt;
  return code;
}

void check_faces(const BuildingModel& model) {
  constexpr double kMaxCoordinate = 9e12;  // thousandths are exact in a double below it
  for (const Face& face : model.faces) {
    check(face.building < model.buildings.size(), "write_model: building = ", face.building,
          ", must be that of a building of the model");
    check(!face.rings.empty(), "write_model: a face has no ring");
    for (const Ring& ring : face.rings) {
      check(ring.size() >= 3, "write_model: a ring has ", ring.size(),
            " vertices, must have three");
      for (const Eigen::Vector3d& vertex : ring) {
        check(vertex.allFinite() && vertex.cwiseAbs().maxCoeff() < kMaxCoordinate,
              "write_model: vertex = ", vertex.transpose(), ", must be finite and below 9e12");
      }
    }
  }
}

/// The model with an id for each building. Throws std::invalid_argument if two share an id.
BuildingModel with_ids(BuildingModel model) {
  std::set<std::string> ids;
  for (std::size_t i = 0; i < model.buildings.size(); ++i) {
    std::string& id = model.buildings[i].id;
    if (id.empty()) id = fmt::format("building_{}", i);
    check(ids.insert(id).second, "write_model: id = ", id, ", must be that of one building");
  }
  std::ranges::stable_sort(model.faces, {}, &Face::building);
  model.attributes.rows.resize(model.buildings.size());
  return model;
}

}  // namespace

EpsgCodes epsg_codes_of(const Crs& crs) {
  if (!crs.known()) return {};
  const proj::Context context = proj::make_context();
  const proj::Object stated = proj::unbound(context.get(), proj::create_crs(context.get(), crs));
  const proj::Object whole = proj::identified(context.get(), *stated);
  const proj::Parts parts = proj::split(context.get(), crs);
  return {code_at_epsg(whole.get()), code_at_epsg(parts.horizontal.get()),
          code_at_epsg(parts.vertical.get())};
}

long long in_thousandths(double coordinate) { return std::llround(coordinate * 1000.0); }

bool are_closed(std::span<const Face> faces) {
  using Thousandths = std::array<long long, 3>;
  const auto corner = [](const Eigen::Vector3d& x) {
    return Thousandths{in_thousandths(x.x()), in_thousandths(x.y()), in_thousandths(x.z())};
  };
  std::map<std::pair<Thousandths, Thousandths>, int> uses;
  for (const Face& face : faces) {
    for (const Ring& ring : face.rings) {
      for (std::size_t i = 0; i < ring.size(); ++i)
        ++uses[{corner(ring[i]), corner(ring[(i + 1) % ring.size()])}];
    }
  }
  // each edge is the counterpart of another one, so this also counts its own uses
  return !uses.empty() && std::ranges::all_of(uses, [&](const auto& use) {
    const auto counterpart = uses.find({use.first.second, use.first.first});
    return counterpart != uses.end() && counterpart->second == 1;
  });
}

const char* surface_name(FaceKind kind) {
  switch (kind) {
    case FaceKind::kRoof:
      return "RoofSurface";
    case FaceKind::kWall:
      return "WallSurface";
    case FaceKind::kGround:
      return "GroundSurface";
    case FaceKind::kOther:
      return "ClosureSurface";
    case FaceKind::kUnknown:
      break;
  }
  return nullptr;
}

void write_model(const std::string& path, const BuildingModel& model, ModelFormat format) {
  check_faces(model);
  const BuildingModel written = with_ids(model);
  AtomicFile file(path);
  (format == ModelFormat::kCityJson ? write_cityjson : write_citygml)(written, file.stream());
  file.commit();
}

}  // namespace ridgeline::io
