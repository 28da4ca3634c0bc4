// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/crs/crs.h"

#include <proj.h>

#include <memory>
#include <string>

/// PROJ objects with owning pointers, shared by the sources that deal with reference systems.
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

/// Creates a PROJ context. Each call needs its own, because contexts must not be shared between
/// threads.
Context make_context();

/// Throws std::invalid_argument if PROJ finds no database. Without it, PROJ can resolve neither
/// codes nor WKT that contains a code.
void check_data(PJ_CONTEXT* context);

/// Creates the reference system from its definition. Throws std::invalid_argument if PROJ cannot
/// read it.
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

/// The parts of a CRS. The horizontal part has two axes. Heights above the ellipsoid, given by a
/// third axis or by a compound with the ellipsoid, are represented only by their unit, not by a
/// part of their own.
struct Parts {
  std::string name = "unknown";
  Object horizontal;
  Object vertical;
  Unit ellipsoidal_height;
};

/// Splits a CRS into its parts; an unknown CRS has none. Throws std::invalid_argument if PROJ
/// cannot read the definition, if it is not a reference system, and if it is a geocentric one.
Parts split(PJ_CONTEXT* context, const Crs& crs);

CrsFacts facts_of(PJ_CONTEXT* context, const Parts& parts);

/// The registered CRS that is equivalent to `crs` except for names (ESRI's spelling, older datum
/// names); a copy of `crs` if PROJ is not sufficiently confident.
Object identified(PJ_CONTEXT* context, const PJ& crs);

}  // namespace ridgeline::io::proj
