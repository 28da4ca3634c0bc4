// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/faces/ring.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ridgeline {

/// The kind of a face as stated by the model. Interior surfaces, openings and the like are kOther.
enum class FaceKind : std::uint8_t { kUnknown, kRoof, kWall, kGround, kOther };

/// A flat face of a building.
struct Face {
  std::vector<Ring> rings;  ///< the outer ring, then the holes
  FaceKind kind = FaceKind::kUnknown;
  std::size_t building = 0;  ///< index of its building
  std::string id;            ///< id of the surface in the file; may be empty
};

}  // namespace ridgeline
