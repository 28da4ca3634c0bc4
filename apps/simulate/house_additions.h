// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/houses.h"
#include "apps/simulate/random.h"

#include <Eigen/Core>

#include <vector>

namespace ridgeline::simulate {

/// Adds up to three small dormers, 1.2 to 2.5 m wide, to the +v side of a gabled or hipped house;
/// adds none if its roof is too flat.
void add_small_dormers(const HouseShape& shape,
                       double ridge_length_m,
                       Random& random,
                       std::vector<RoofPart>& parts);

/// A site for an annex, in the frame of its house.
struct AnnexSite {
  Eigen::Vector2d centre_m = Eigen::Vector2d::Zero();  ///< of the main body
  PlanFunction ground;
  bool back_is_free = true;  ///< no other part on the +v side
  double reach_m = 0.0;      ///< largest distance from the origin
};

/// Adds a lean-to or flat annex, 2 to 4 m deep and 2.3 to 3.5 m high, to a wall of the main body
/// parts[0], below its eave; adds none if there is no suitable place.
void add_annex(const HouseShape& shape,
               const AnnexSite& site,
               Random& random,
               std::vector<RoofPart>& parts);

}  // namespace ridgeline::simulate
