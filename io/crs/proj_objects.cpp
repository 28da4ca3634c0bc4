// SPDX-License-Identifier: BSD-3-Clause
#include "io/crs/proj_objects.h"

#include "reconstruct/geometry/check.h"

#include <fmt/format.h>
#include <proj_experimental.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <string_view>
#include <utility>

namespace ridgeline::io::proj {
namespace {

bool is_code(std::string_view text) {
  const std::size_t colon = text.find(':');
  return colon != std::string_view::npos && colon > 0 && colon + 1 < text.size() &&
         std::ranges::all_of(text, [](char c) {
           return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                  std::string_view(":+._-/,").find(c) != std::string_view::npos;
         });
}

/// "EPSG:25832+7837" for "EPSG: 25832 + 7837"; other definitions unchanged.
std::string code_without_blanks(const std::string& definition) {
  std::string dense = definition;
  std::erase_if(dense, [](unsigned char c) { return std::isspace(c) != 0; });
  return is_code(dense) ? dense : definition;
}

/// Whether the definition is something other than a name. PROJ takes any other text for a name and
/// searches for a similar one: "foo" finds Amersfoort.
bool is_definite(PJ_CONTEXT* context, const std::string& definition) {
  const std::size_t first = definition.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return false;
  const std::string_view text = std::string_view(definition).substr(first);
  if (text.starts_with('{') || text.starts_with('+') || is_code(text)) return true;
  if (text.starts_with("proj=") || text.find(" +proj=") != std::string_view::npos) return true;
  return Object(proj_create_from_wkt(context, definition.c_str(), nullptr, nullptr, nullptr)) !=
         nullptr;
}

}  // namespace

Context make_context() {
  Context context(proj_context_create());
  proj_log_level(context.get(), PJ_LOG_NONE);
  // some errors are logged at any level
  proj_log_func(context.get(), nullptr, [](void*, int, const char*) {});
  proj_context_set_enable_network(context.get(), 0);
  return context;
}

void check_data(PJ_CONTEXT* context) {
  const char* const database = proj_context_get_database_path(context);
  const auto value_of = [](const char* variable) {
    const char* const value = std::getenv(variable);
    return value == nullptr ? std::string("not set") : fmt::format("\"{}\"", value);
  };
  check(database != nullptr && *database != '\0', "PROJ cannot find proj.db: PROJ_DATA is ",
        value_of("PROJ_DATA"), ", PROJ_LIB is ", value_of("PROJ_LIB"),
        "; unset them or set them to the folder of proj.db (package proj-data)");
}

Object create_crs(PJ_CONTEXT* context, const Crs& crs) {
  constexpr std::size_t kShown = 80;
  const std::string shown = crs.definition.substr(0, kShown);
  const std::string definition = code_without_blanks(crs.definition);
  if (!is_definite(context, definition)) {
    check_data(context);
    check(false, "crs = \"", shown,
          "\", must be a code (EPSG:25832, EPSG:25832+7837, urn:ogc:def:crs:...), WKT, PROJJSON or "
          "a PROJ string (+proj=... +type=crs)");
  }
  Object whole(proj_create(context, definition.c_str()));
  if (!whole) check_data(context);
  check(whole != nullptr, "crs = \"", shown, "\", must be a definition known to PROJ");
  return whole;
}

Object unbound(PJ_CONTEXT* context, Object crs) {
  while (crs && proj_get_type(crs.get()) == PJ_TYPE_BOUND_CRS) {
    crs.reset(proj_get_source_crs(context, crs.get()));
  }
  return crs;
}

Unit axis_unit(PJ_CONTEXT* context, const PJ* crs, int axis) {
  const Object system(proj_crs_get_coordinate_system(context, crs));
  Unit unit;
  if (!system || axis >= proj_cs_get_axis_count(context, system.get())) return unit;
  const char* name = nullptr;
  unit.found = proj_cs_get_axis_info(context, system.get(), axis, nullptr, nullptr, nullptr,
                                     &unit.size_m, &name, nullptr, nullptr) != 0;
  if (unit.found && name != nullptr) unit.name = name;
  return unit;
}

Parts split(PJ_CONTEXT* context, const Crs& crs) {
  Parts parts;
  if (!crs.known()) return parts;
  Object whole = unbound(context, create_crs(context, crs));
  check(whole != nullptr, "crs = \"", crs.definition, "\", must be a definition known to PROJ");
  check(proj_is_crs(whole.get()) != 0, "crs = \"", crs.definition,
        "\", must be a coordinate reference system (a PROJ string needs +type=crs)");
  parts.name = proj_get_name(whole.get());
  if (proj_get_type(whole.get()) == PJ_TYPE_COMPOUND_CRS) {
    parts.horizontal = unbound(context, Object(proj_crs_get_sub_crs(context, whole.get(), 0)));
    parts.vertical = unbound(context, Object(proj_crs_get_sub_crs(context, whole.get(), 1)));
  } else if (proj_get_type(whole.get()) == PJ_TYPE_VERTICAL_CRS) {
    parts.vertical = std::move(whole);
  } else {
    check(proj_get_type(whole.get()) != PJ_TYPE_GEOCENTRIC_CRS, "crs = \"", parts.name,
          "\", must be projected, not geocentric");
    parts.horizontal = std::move(whole);
  }
  if (!parts.horizontal) return parts;
  parts.ellipsoidal_height = axis_unit(context, parts.horizontal.get(), 2);
  if (parts.ellipsoidal_height.found) {
    parts.horizontal.reset(proj_crs_demote_to_2D(context, nullptr, parts.horizontal.get()));
  }
  return parts;
}

CrsFacts facts_of(PJ_CONTEXT* context, const Parts& parts) {
  CrsFacts facts;
  facts.name = parts.name;
  if (parts.horizontal) {
    const PJ* const horizontal = parts.horizontal.get();
    const PJ_TYPE type = proj_get_type(horizontal);
    facts.horizontal_name = proj_get_name(horizontal);
    facts.is_geographic = type == PJ_TYPE_GEOGRAPHIC_2D_CRS || type == PJ_TYPE_GEOGRAPHIC_3D_CRS;
    const Unit unit = axis_unit(context, horizontal, 0);
    facts.horizontal_unit_m = unit.size_m;
    facts.horizontal_unit_name = unit.name;
  }
  const Unit height =
      parts.vertical ? axis_unit(context, parts.vertical.get(), 0) : parts.ellipsoidal_height;
  if (parts.vertical) {
    facts.vertical_name = proj_get_name(parts.vertical.get());
  } else if (height.found) {
    facts.vertical_name = "ellipsoidal height of " + facts.horizontal_name;
  }
  facts.vertical_unit_m = height.found ? height.size_m : facts.horizontal_unit_m;
  facts.vertical_unit_name = height.found ? height.name : facts.horizontal_unit_name;
  return facts;
}

Object identified(PJ_CONTEXT* context, const PJ& crs) {
  constexpr int kEquivalentConfidence = 90;  // in PROJ: equal except for the name
  int* confidences = nullptr;
  const List candidates(proj_identify(context, &crs, "EPSG", nullptr, &confidences));
  const bool sure = candidates && proj_list_get_count(candidates.get()) > 0 &&
                    confidences[0] >= kEquivalentConfidence;
  proj_int_list_destroy(confidences);
  if (!sure) return Object(proj_clone(context, &crs));
  return Object(proj_list_get(context, candidates.get(), 0));
}

}  // namespace ridgeline::io::proj
