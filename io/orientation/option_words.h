// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/orientation/conventions.h"

#include <optional>
#include <string>

namespace ridgeline::io {

// The words with which users resolve ambiguities of an orientation. The functions return
// std::nullopt for any other word.

std::optional<AngleUnit> angle_unit_named(const std::string& word);          ///< deg | gon | rad
std::optional<RotationOrder> rotation_order_named(const std::string& word);  ///< opk | pok
std::optional<MatrixDirection> matrix_direction_named(
    const std::string& word);  ///< world_from_camera | camera_from_world

}  // namespace ridgeline::io
