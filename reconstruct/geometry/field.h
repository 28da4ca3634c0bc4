// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/check.h"

#include <string_view>
#include <tuple>

namespace ridgeline {

/// One option of an options struct: the single definition of its command-line flag, its range check
/// and its entry in run.json. A struct lists its fields as `static constexpr auto fields()`.
template <typename Options, typename T>
struct Field {
  std::string_view name;  ///< snake_case with the unit as suffix
  T Options::*member;
  T lowest;
  T highest;
  std::string_view help;
};
template <typename Options, typename T>
Field(const char*, T Options::*, T, T, const char*) -> Field<Options, T>;

/// Calls `visit(field)` for every field of an options struct.
template <typename Options, typename Visitor>
void for_each_field(Visitor&& visit) {
  std::apply([&](const auto&... field) { (visit(field), ...); }, Options::fields());
}

/// Throws std::invalid_argument naming the first field whose value is out of range or NaN.
template <typename Options>
void validate(const Options& options) {
  for_each_field<Options>([&](const auto& field) {
    const auto value = options.*field.member;
    check(value >= field.lowest && value <= field.highest, field.name, " = ", value,
          ", must be in [", field.lowest, ", ", field.highest, "]");
  });
}

}  // namespace ridgeline
