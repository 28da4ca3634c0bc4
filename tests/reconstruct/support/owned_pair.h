// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/scene/scene.h"

#include <array>

namespace ridgeline::test {

/// A pair that holds its views.
struct OwnedPair {
  std::array<reconstruct::View, 2> views{};
  std::array<double, 2> height_range_in_local_m{};

  // NOLINTNEXTLINE(google-explicit-constructor): what borrows a pair takes this one
  operator reconstruct::StereoPair() const {
    return {{views.data(), views.data() + 1}, height_range_in_local_m};
  }
  [[nodiscard]] std::array<ProjectionMatrix, 2> cameras() const {
    return reconstruct::StereoPair(*this).cameras();
  }
};

}  // namespace ridgeline::test
