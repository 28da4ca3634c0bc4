// SPDX-License-Identifier: BSD-3-Clause
#include "io/crs.h"

#include "reconstruct/geometry/check.h"

#include <fmt/format.h>
#include <proj.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

namespace ridgeline::io {

namespace {

struct ContextDeleter {
  void operator()(PJ_CONTEXT* context) const { proj_context_destroy(context); }
};
struct ObjectDeleter {
  void operator()(PJ* object) const { proj_destroy(object); }
};
struct ListDeleter {
  void operator()(PJ_OBJ_LIST* list) const { proj_list_destroy(list); }
};
using Context = std::unique_ptr<PJ_CONTEXT, ContextDeleter>;
using Object = std::unique_ptr<PJ, ObjectDeleter>;
using List = std::unique_ptr<PJ_OBJ_LIST, ListDeleter>;

/// One a call: PROJ's contexts must not be shared between threads.
Context make_context() {
  Context context(proj_context_create());
  proj_log_level(context.get(), PJ_LOG_NONE);
  // some errors are logged at any level
  proj_log_func(context.get(), nullptr, [](void*, int, const char*) {});
  proj_context_set_enable_network(context.get(), 0);
  return context;
}

/// PROJ without its data knows no code and reads no WKT with one.
void check_proj_data(PJ_CONTEXT* context) {
  const char* const database = proj_context_get_database_path(context);
  const auto value_of = [](const char* variable) {
    const char* const value = std::getenv(variable);
    return value == nullptr ? std::string("not set") : fmt::format("\"{}\"", value);
  };
  check(database != nullptr && *database != '\0', "PROJ finds no proj.db: PROJ_DATA is ",
        value_of("PROJ_DATA"), ", PROJ_LIB is ", value_of("PROJ_LIB"),
        "; unset them or name the folder that holds proj.db (package proj-data)");
}

bool is_code(std::string_view text) {
  const std::size_t colon = text.find(':');
  return colon != std::string_view::npos && colon > 0 && colon + 1 < text.size() &&
         std::ranges::all_of(text, [](char c) {
           return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                  std::string_view(":+._-/,").find(c) != std::string_view::npos;
         });
}

/// PROJ takes any other text for a name and searches for one like it: "foo" finds Amersfoort.
bool is_definite(PJ_CONTEXT* context, const std::string& definition) {
  const std::size_t first = definition.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return false;
  const std::string_view text = std::string_view(definition).substr(first);
  if (text.starts_with('{') || text.starts_with('+') || is_code(text)) return true;
  if (text.starts_with("proj=") || text.find(" +proj=") != std::string_view::npos) return true;
  return Object(proj_create_from_wkt(context, definition.c_str(), nullptr, nullptr, nullptr)) !=
         nullptr;
}

Object create_crs(PJ_CONTEXT* context, const Crs& crs) {
  constexpr std::size_t kShown = 80;
  const std::string shown = crs.definition.substr(0, kShown);
  if (!is_definite(context, crs.definition)) {
    check_proj_data(context);
    check(false, "crs = \"", shown,
          "\", must be a code (EPSG:25832, EPSG:25832+7837, urn:ogc:def:crs:...), WKT, PROJJSON or "
          "a PROJ string (+proj=... +type=crs)");
  }
  Object whole(proj_create(context, crs.definition.c_str()));
  if (!whole) check_proj_data(context);
  check(whole != nullptr, "crs = \"", shown, "\", must be a definition that PROJ reads");
  return whole;
}

struct Parts {
  std::string name = "unknown";
  Object horizontal;
  Object vertical;
};

/// A CRS bound to a datum shift (TOWGS84 in WKT1) is compared without it.
Object unbound(PJ_CONTEXT* context, Object crs) {
  while (crs && proj_get_type(crs.get()) == PJ_TYPE_BOUND_CRS) {
    crs.reset(proj_get_source_crs(context, crs.get()));
  }
  return crs;
}

Parts split(PJ_CONTEXT* context, const Crs& crs) {
  Parts parts;
  if (!crs.known()) return parts;
  Object whole = unbound(context, create_crs(context, crs));
  check(whole != nullptr, "crs = \"", crs.definition, "\", must be a definition that PROJ reads");
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
  return parts;
}

struct Unit {
  double size_m = 1.0;
  std::string name = "metre";
  bool found = false;
};

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

/// False too if the CRS carries no EPSG-like identifier.
bool same_identifier(const PJ* a, const PJ* b) {
  const auto text = [](const char* value) { return std::string_view(value ? value : ""); };
  const std::string_view code = text(proj_get_id_code(a, 0));
  return !code.empty() && code == text(proj_get_id_code(b, 0)) &&
         text(proj_get_id_auth_name(a, 0)) == text(proj_get_id_auth_name(b, 0));
}

/// The registered CRS that `crs` means, where only names differ (ESRI's spelling, older datum
/// names); itself if PROJ is not nearly sure.
Object identified(PJ_CONTEXT* context, Object crs) {
  constexpr int kEquivalentConfidence = 90;  // PROJ: equal but for the name
  int* confidences = nullptr;
  const List candidates(proj_identify(context, crs.get(), "EPSG", nullptr, &confidences));
  const bool sure = candidates && proj_list_get_count(candidates.get()) > 0 &&
                    confidences[0] >= kEquivalentConfidence;
  proj_int_list_destroy(confidences);
  if (!sure) return crs;
  return Object(proj_list_get(context, candidates.get(), 0));
}

bool equivalent(PJ_CONTEXT* context, Object a, Object b) {
  const auto equal = [&] {
    return proj_is_equivalent_to_with_ctx(context, a.get(), b.get(),
                                          PJ_COMP_EQUIVALENT_EXCEPT_AXIS_ORDER_GEOGCRS) != 0;
  };
  if (equal()) return true;
  a = identified(context, std::move(a));
  b = identified(context, std::move(b));
  return same_identifier(a.get(), b.get()) || equal();
}

bool same_unit(double a_m, double b_m) {
  constexpr double kRelativeTolerance = 1e-7;  // the two feet differ by 2e-6
  return std::abs(a_m - b_m) <= kRelativeTolerance * a_m;
}

/// One part of a CRS as messages name it.
struct PartFacts {
  std::string name;
  std::string unit_name;
  double unit_m;
};

std::string disagreement(const char* part, const PartFacts& a, const PartFacts& b) {
  std::string reason =
      fmt::format("{} reference systems differ: \"{}\" and \"{}\"", part, a.name, b.name);
  if (!same_unit(a.unit_m, b.unit_m)) {
    reason += fmt::format("; units are {} ({:.10g} m) and {} ({:.10g} m)", a.unit_name, a.unit_m,
                          b.unit_name, b.unit_m);
  }
  return reason;
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
  const Unit height = parts.vertical     ? axis_unit(context, parts.vertical.get(), 0)
                      : parts.horizontal ? axis_unit(context, parts.horizontal.get(), 2)
                                         : Unit{};
  if (parts.vertical) {
    facts.vertical_name = proj_get_name(parts.vertical.get());
  } else if (height.found) {
    facts.vertical_name = "ellipsoidal height of " + facts.horizontal_name;
  }
  facts.vertical_unit_m = height.found ? height.size_m : facts.horizontal_unit_m;
  facts.vertical_unit_name = height.found ? height.name : facts.horizontal_unit_name;
  return facts;
}

void compare_horizontal(PJ_CONTEXT* context,
                        Parts& a,
                        Parts& b,
                        const CrsFacts& a_facts,
                        const CrsFacts& b_facts,
                        CrsAgreement& agreement) {
  if (!a.horizontal || !b.horizontal) {
    if (a.horizontal || b.horizontal) {
      agreement.warning = fmt::format(
          "one of \"{}\" and \"{}\" states no horizontal reference system; taken as equal", a.name,
          b.name);
    }
    return;
  }
  if (equivalent(context, std::move(a.horizontal), std::move(b.horizontal))) return;
  agreement.compatible = false;
  agreement.reason = disagreement(
      "horizontal",
      {a_facts.horizontal_name, a_facts.horizontal_unit_name, a_facts.horizontal_unit_m},
      {b_facts.horizontal_name, b_facts.horizontal_unit_name, b_facts.horizontal_unit_m});
}

/// Heights over the ellipsoid belong to the horizontal part's own CRS, so their names are compared;
/// two vertical CRS are compared by PROJ.
bool same_heights(PJ_CONTEXT* context, Parts& a, Parts& b, const CrsFacts& fa, const CrsFacts& fb) {
  if (a.vertical && b.vertical) {
    return equivalent(context, std::move(a.vertical), std::move(b.vertical));
  }
  return !a.vertical && !b.vertical && fa.vertical_name == fb.vertical_name;
}

void compare_vertical(PJ_CONTEXT* context,
                      Parts& a,
                      Parts& b,
                      const CrsFacts& a_facts,
                      const CrsFacts& b_facts,
                      CrsAgreement& agreement) {
  if (a_facts.vertical_name.empty() != b_facts.vertical_name.empty()) {
    const std::string& known =
        a_facts.vertical_name.empty() ? b_facts.vertical_name : a_facts.vertical_name;
    if (!agreement.warning.empty()) agreement.warning += "; ";
    agreement.warning += fmt::format(
        "only one of \"{}\" and \"{}\" states its vertical reference system (\"{}\"): heights may "
        "differ by tens of metres",
        a_facts.name, b_facts.name, known);
    return;
  }
  if (a_facts.vertical_name.empty() || same_heights(context, a, b, a_facts, b_facts)) return;
  agreement.compatible = false;
  agreement.reason = disagreement(
      "vertical", {a_facts.vertical_name, a_facts.vertical_unit_name, a_facts.vertical_unit_m},
      {b_facts.vertical_name, b_facts.vertical_unit_name, b_facts.vertical_unit_m});
}

/// What was found for the latest definitions: the tiles of a survey state one and the same, and PROJ
/// takes tens of milliseconds to read it.
template <typename Value>
class Memo {
 public:
  /// The value for a definition; `find` gives it the first time, and is asked again if it throws.
  template <typename Find>
  Value get(const std::string& definition, const Find& find) {
    constexpr std::size_t kMost = 64;
    {
      const std::scoped_lock lock(mutex_);
      if (const auto known = values_.find(definition); known != values_.end()) return known->second;
    }
    Value value = find();
    const std::scoped_lock lock(mutex_);
    if (values_.size() >= kMost) values_.clear();
    values_.emplace(definition, value);
    return value;
  }

 private:
  std::mutex mutex_;
  std::map<std::string, Value> values_;
};

}  // namespace

void require_proj_data() {
  const Context context = make_context();
  check_proj_data(context.get());
}

bool is_wkt(const Crs& crs) {
  static Memo<bool> memo;
  return memo.get(crs.definition, [&] {
    const Context context = make_context();
    return Object(proj_create_from_wkt(context.get(), crs.definition.c_str(), nullptr, nullptr,
                                       nullptr)) != nullptr;
  });
}

CrsFacts describe(const Crs& crs) {
  static Memo<CrsFacts> memo;
  return memo.get(crs.definition, [&] {
    const Context context = make_context();
    return facts_of(context.get(), split(context.get(), crs));
  });
}

std::string to_wkt(const Crs& crs) {
  const Context context = make_context();
  const Object whole = create_crs(context.get(), crs);
  const char* const options[] = {"MULTILINE=NO", nullptr};
  const char* const wkt = proj_as_wkt(context.get(), whole.get(), PJ_WKT1_GDAL, options);
  check(wkt != nullptr, "crs = \"", crs.definition, "\", must have a WKT1 form");
  return wkt;
}

CrsAgreement compare(const Crs& a, const Crs& b) {
  const Context context = make_context();
  Parts a_parts = split(context.get(), a);
  Parts b_parts = split(context.get(), b);
  const CrsFacts a_facts = facts_of(context.get(), a_parts);
  const CrsFacts b_facts = facts_of(context.get(), b_parts);
  CrsAgreement agreement;
  compare_horizontal(context.get(), a_parts, b_parts, a_facts, b_facts, agreement);
  if (agreement.compatible) {
    compare_vertical(context.get(), a_parts, b_parts, a_facts, b_facts, agreement);
  }
  return agreement;
}

}  // namespace ridgeline::io
