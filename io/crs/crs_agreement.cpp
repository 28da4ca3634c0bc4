// SPDX-License-Identifier: BSD-3-Clause
#include "io/crs/crs.h"
#include "io/crs/proj_objects.h"

#include <fmt/format.h>
#include <proj.h>
#include <proj_experimental.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::io {
namespace {

using proj::Object;
using proj::Parts;

/// Whether both have the same EPSG-like identifier; false if one has none.
bool same_identifier(const PJ* a, const PJ* b) {
  const auto text = [](const char* value) { return std::string_view(value ? value : ""); };
  const std::string_view code = text(proj_get_id_code(a, 0));
  return !code.empty() && code == text(proj_get_id_code(b, 0)) &&
         text(proj_get_id_auth_name(a, 0)) == text(proj_get_id_auth_name(b, 0));
}

bool equal(PJ_CONTEXT* context, const PJ* a, const PJ* b) {
  return proj_is_equivalent_to_with_ctx(context, a, b,
                                        PJ_COMP_EQUIVALENT_EXCEPT_AXIS_ORDER_GEOGCRS) != 0;
}

bool equivalent(PJ_CONTEXT* context, const PJ& a, const PJ& b) {
  if (equal(context, &a, &b)) return true;
  const Object known_a = proj::identified(context, a);
  const Object known_b = proj::identified(context, b);
  return same_identifier(known_a.get(), known_b.get()) ||
         equal(context, known_a.get(), known_b.get());
}

std::string datum_name(PJ_CONTEXT* context, const PJ* crs) {
  const Object datum(proj_crs_get_datum_forced(context, crs));
  const char* const name = datum ? proj_get_name(datum.get()) : nullptr;
  return name == nullptr ? "" : name;
}

/// The components of a CRS, one per string: its datum and the parameters of its PROJ string.
std::vector<std::string> ingredients(PJ_CONTEXT* context, const PJ* crs) {
  std::vector<std::string> words{fmt::format("datum \"{}\"", datum_name(context, crs))};
  const char* const text = proj_as_proj_string(context, crs, PJ_PROJ_4, nullptr);
  std::istringstream rest(text == nullptr ? "" : text);
  for (std::string word; rest >> word;) words.push_back(word);
  return words;
}

/// The words missing from `others`; "none of these" if it has all of them.
std::string only_in(const std::vector<std::string>& words, const std::vector<std::string>& others) {
  std::string text;
  for (const std::string& word : words) {
    if (std::ranges::find(others, word) == others.end()) text += (text.empty() ? "" : " ") + word;
  }
  return text.empty() ? "none of these" : text;
}

/// One part of a CRS, as named in messages.
struct PartFacts {
  std::string name;
  std::string unit_name;
  double unit_m;
  std::vector<std::string> ingredients;
};

std::string disagreement(const char* part, const PartFacts& a, const PartFacts& b) {
  std::string reason = fmt::format("{} reference systems differ: ", part);
  if (a.name != b.name) {
    reason += fmt::format("\"{}\" and \"{}\"", a.name, b.name);
  } else {
    reason +=
        fmt::format("both are called \"{}\", but one has {} and the other has {}", a.name,
                    only_in(a.ingredients, b.ingredients), only_in(b.ingredients, a.ingredients));
  }
  if (!same_unit(a.unit_m, b.unit_m)) {
    reason += fmt::format("; units are {} ({:.10g} m) and {} ({:.10g} m)", a.unit_name, a.unit_m,
                          b.unit_name, b.unit_m);
  }
  return reason;
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
          "one of \"{}\" and \"{}\" has no horizontal reference system; assuming that they are the "
          "same",
          a.name, b.name);
    }
    return;
  }
  if (equivalent(context, *a.horizontal, *b.horizontal)) return;
  const auto part = [&](const Parts& parts, const CrsFacts& facts) {
    return PartFacts{facts.horizontal_name, facts.horizontal_unit_name, facts.horizontal_unit_m,
                     ingredients(context, parts.horizontal.get())};
  };
  agreement.compatible = false;
  agreement.reason = disagreement("horizontal", part(a, a_facts), part(b, b_facts));
}

/// The warning for two files of which only one states a vertical reference system.
std::string one_without_heights(const CrsFacts& a, const CrsFacts& b) {
  const std::string who = a.name == b.name
                              ? fmt::format("only one of two files in \"{}\"", a.name)
                              : fmt::format("only one of \"{}\" and \"{}\"", a.name, b.name);
  return fmt::format(
      "{} has a vertical reference system (\"{}\"): heights may differ by tens of metres", who,
      a.vertical_name.empty() ? b.vertical_name : a.vertical_name);
}

/// Whether the heights of two systems with compatible plans agree. Heights above the ellipsoid of
/// one datum can differ only in their unit.
bool same_heights(PJ_CONTEXT* context, Parts& a, Parts& b) {
  if (a.vertical && b.vertical) return equivalent(context, *a.vertical, *b.vertical);
  return !a.vertical && !b.vertical &&
         same_unit(a.ellipsoidal_height.size_m, b.ellipsoidal_height.size_m);
}

void compare_vertical(PJ_CONTEXT* context,
                      Parts& a,
                      Parts& b,
                      const CrsFacts& a_facts,
                      const CrsFacts& b_facts,
                      CrsAgreement& agreement) {
  if (a_facts.vertical_name.empty() != b_facts.vertical_name.empty()) {
    if (!agreement.warning.empty()) agreement.warning += "; ";
    agreement.warning += one_without_heights(a_facts, b_facts);
    return;
  }
  if (a_facts.vertical_name.empty() || same_heights(context, a, b)) return;
  const auto part = [&](const Parts& parts, const CrsFacts& facts) {
    const PJ* const crs = parts.vertical ? parts.vertical.get() : parts.horizontal.get();
    return PartFacts{facts.vertical_name, facts.vertical_unit_name, facts.vertical_unit_m,
                     ingredients(context, crs)};
  };
  agreement.compatible = false;
  agreement.reason = disagreement("vertical", part(a, a_facts), part(b, b_facts));
}

}  // namespace

CrsAgreement compare(const Crs& a, const Crs& b) {
  const proj::Context context = proj::make_context();
  Parts a_parts = proj::split(context.get(), a);
  Parts b_parts = proj::split(context.get(), b);
  const CrsFacts a_facts = proj::facts_of(context.get(), a_parts);
  const CrsFacts b_facts = proj::facts_of(context.get(), b_parts);
  CrsAgreement agreement;
  compare_horizontal(context.get(), a_parts, b_parts, a_facts, b_facts, agreement);
  if (agreement.compatible) {
    compare_vertical(context.get(), a_parts, b_parts, a_facts, b_facts, agreement);
  }
  return agreement;
}

}  // namespace ridgeline::io
