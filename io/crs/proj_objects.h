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

/// One a call: PROJ's contexts must not be shared between threads.
Context make_context();

/// Throws std::invalid_argument if PROJ finds no data base: it knows no code then and reads no WKT with one.
void check_data(PJ_CONTEXT* context);

/// Throws std::invalid_argument if PROJ cannot read the definition.
Object create_crs(PJ_CONTEXT* context, const Crs& crs);

/// A CRS without the datum shift that it may be bound to (TOWGS84 in WKT1).
Object unbound(PJ_CONTEXT* context, Object crs);

struct Unit {
  double size_m = 1.0;
  std::string name = "metre";
  bool found = false;
};

/// Of an axis, from 0; not found if the system has fewer.
Unit axis_unit(PJ_CONTEXT* context, const PJ* crs, int axis);

/// A CRS taken apart. The horizontal part has two axes; heights above the ellipsoid, which three axes
/// or a compound with the ellipsoid state, are a unit and no part of their own.
struct Parts {
  std::string name = "unknown";
  Object horizontal;
  Object vertical;
  Unit ellipsoidal_height;
};

/// No parts of an unknown CRS. Throws std::invalid_argument for what PROJ cannot read, for what is no reference system,
/// and for a geocentric one.
Parts split(PJ_CONTEXT* context, const Crs& crs);

CrsFacts facts_of(PJ_CONTEXT* context, const Parts& parts);

/// The registered CRS that `crs` means, where only names differ (ESRI's spelling, older datum
/// names); a copy if PROJ is not nearly sure.
Object identified(PJ_CONTEXT* context, const PJ& crs);

}  // namespace ridgeline::io::proj
