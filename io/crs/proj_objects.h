// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/crs/crs.h"

#include <proj.h>

#include <memory>
#include <string>

/// What the files that speak of reference systems share: PROJ's objects with their owners.
namespace ridgeline::io::proj {

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

/// Makes a context of PROJ. Each call needs its own, as contexts must not be shared between
/// threads.
Context make_context();

/// Throws std::invalid_argument if PROJ finds no data base. Without it PROJ knows no code and
/// cannot read WKT with a code.
void check_data(PJ_CONTEXT* context);

/// The reference system of a definition. Throws std::invalid_argument if PROJ cannot read it.
Object create_crs(PJ_CONTEXT* context, const Crs& crs);

/// A CRS without the datum shift that it may be bound to (TOWGS84 in WKT1).
Object unbound(PJ_CONTEXT* context, Object crs);

struct Unit {
  double size_m = 1.0;
  std::string name = "metre";
  bool found = false;
};

/// The unit of an axis, counted from 0; `found` is false if the system has fewer axes.
Unit axis_unit(PJ_CONTEXT* context, const PJ* crs, int axis);

/// A CRS taken apart. The horizontal part has two axes. Heights above the ellipsoid, which three
/// axes or a compound with the ellipsoid state, are kept as a unit and are no part of their own.
struct Parts {
  std::string name = "unknown";
  Object horizontal;
  Object vertical;
  Unit ellipsoidal_height;
};

/// Splits a CRS into its parts; an unknown CRS has none. Throws std::invalid_argument for what PROJ
/// cannot read, for what is no reference system, and for a geocentric one.
Parts split(PJ_CONTEXT* context, const Crs& crs);

CrsFacts facts_of(PJ_CONTEXT* context, const Parts& parts);

/// The registered CRS that `crs` means, if only names differ (ESRI's spelling, older datum names);
/// a copy of `crs` if PROJ is not nearly sure.
Object identified(PJ_CONTEXT* context, const PJ& crs);

}  // namespace ridgeline::io::proj
