// SPDX-License-Identifier: BSD-3-Clause
#include "io/crs/crs.h"

#include "io/crs/proj_objects.h"
#include "reconstruct/geometry/check.h"

#include <fmt/format.h>
#include <proj_experimental.h>

#include <cmath>
#include <map>
#include <mutex>
#include <stdexcept>
#include <string>

namespace ridgeline::io {
namespace {

/// Caches results for the latest definitions. All tiles of a survey state the same definition, and
/// PROJ takes tens of milliseconds to read it.
template <typename Value>
class Memo {
 public:
  /// The value for a definition. `find` computes it the first time, and again if it threw.
  template <typename Find>
  Value get(const std::string& definition, const Find& find) {
    constexpr std::size_t kMaxValues = 64;
    {
      const std::scoped_lock lock(mutex_);
      if (const auto known = values_.find(definition); known != values_.end()) return known->second;
    }
    Value value = find();
    const std::scoped_lock lock(mutex_);
    if (values_.size() >= kMaxValues) values_.clear();
    values_.emplace(definition, value);
    return value;
  }

 private:
  std::mutex mutex_;
  std::map<std::string, Value> values_;
};

/// EPSG's name and code for a unit of this size; "unknown" if it has none.
struct NamedUnit {
  const char* name = "unknown";
  const char* code = nullptr;
};

NamedUnit named_unit(double size_m) {
  if (same_unit(size_m, 1.0)) return {"metre", "9001"};
  if (same_unit(size_m, kFoot_m)) return {"foot", "9002"};
  if (same_unit(size_m, kSurveyFoot_m)) return {"US survey foot", "9003"};
  return {};
}

std::string text_of(PJ_CONTEXT* context, const PJ* crs, PJ_WKT_TYPE type) {
  const char* const options[] = {"MULTILINE=NO", "ALLOW_ELLIPSOIDAL_HEIGHT_AS_VERTICAL_CRS=YES",
                                 nullptr};
  const char* const wkt = proj_as_wkt(context, crs, type, options);
  return wkt == nullptr ? "" : wkt;
}

}  // namespace

bool same_unit(double a_m, double b_m) {
  constexpr double kRelativeTolerance = 1e-7;  // the two kinds of foot differ by 2e-6
  return std::abs(a_m - b_m) <= kRelativeTolerance * a_m;
}

void require_proj_data() {
  const proj::Context context = proj::make_context();
  proj::check_data(context.get());
}

bool is_wkt(const Crs& crs) {
  static Memo<bool> memo;
  return memo.get(crs.definition, [&] {
    const proj::Context context = proj::make_context();
    return proj::Object(proj_create_from_wkt(context.get(), crs.definition.c_str(), nullptr,
                                             nullptr, nullptr)) != nullptr;
  });
}

CrsFacts describe(const Crs& crs) {
  static Memo<CrsFacts> memo;
  return memo.get(crs.definition, [&] {
    const proj::Context context = proj::make_context();
    return proj::facts_of(context.get(), proj::split(context.get(), crs));
  });
}

bool states_geocentric(const Crs& crs) {
  if (!crs.known()) return false;
  const proj::Context context = proj::make_context();
  try {
    const proj::Object whole = proj::create_crs(context.get(), crs);
    return proj_get_type(whole.get()) == PJ_TYPE_GEOCENTRIC_CRS;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

std::string to_wkt(const Crs& crs) {
  const proj::Context context = proj::make_context();
  const proj::Object whole = proj::create_crs(context.get(), crs);
  std::string wkt = text_of(context.get(), whole.get(), PJ_WKT1_GDAL);
  check(!wkt.empty(), "crs = \"", crs.definition, "\", must have a WKT1 form");
  return wkt;
}

Crs with_vertical_unit(const Crs& crs, double unit_m) {
  const proj::Context context = proj::make_context();
  const proj::Parts parts = proj::split(context.get(), crs);
  if (!parts.horizontal || !parts.vertical) return crs;
  const NamedUnit unit = named_unit(unit_m);
  const proj::Object vertical(
      proj_crs_alter_cs_linear_unit(context.get(), parts.vertical.get(), unit.name, unit_m,
                                    unit.code == nullptr ? nullptr : "EPSG", unit.code));
  const proj::Object whole(proj_create_compound_crs(context.get(), parts.name.c_str(),
                                                    parts.horizontal.get(), vertical.get()));
  return {text_of(context.get(), whole.get(), PJ_WKT2_2019)};
}

std::string unit_text(double unit_m) {
  const NamedUnit unit = named_unit(unit_m);
  return fmt::format("{} ({:.12g} m)", unit.code == nullptr ? "unit" : unit.name, unit_m);
}

}  // namespace ridgeline::io
