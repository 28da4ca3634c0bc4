// SPDX-License-Identifier: BSD-3-Clause
#include "io/orientation/option_words.h"

#include <map>

namespace ridgeline::io {
namespace {

template <typename Value>
std::optional<Value> value_of(const std::map<std::string, Value>& values, const std::string& word) {
  const auto found = values.find(word);
  return found == values.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace

std::optional<AngleUnit> angle_unit_named(const std::string& word) {
  return value_of<AngleUnit>(
      {{"deg", AngleUnit::kDegree}, {"gon", AngleUnit::kGon}, {"rad", AngleUnit::kRadian}}, word);
}

std::optional<RotationOrder> rotation_order_named(const std::string& word) {
  return value_of<RotationOrder>(
      {{"opk", RotationOrder::kOmegaPhiKappa}, {"pok", RotationOrder::kPhiOmegaKappa}}, word);
}

std::optional<MatrixDirection> matrix_direction_named(const std::string& word) {
  return value_of<MatrixDirection>({{"world_from_camera", MatrixDirection::kWorldFromCamera},
                                    {"camera_from_world", MatrixDirection::kCameraFromWorld}},
                                   word);
}

}  // namespace ridgeline::io
