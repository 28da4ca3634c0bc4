// SPDX-License-Identifier: BSD-3-Clause
// The geometry of a reconstructed line that must have one: a test that reads it of a line without
// fails and says so.
#pragma once

#include "reconstruct/estimate/ok2011/reconstruct_lines.h"

#include <optional>
#include <stdexcept>
#include <string>

namespace ridgeline::test {

template <class Value>
const Value& value_of(const std::optional<Value>& value,
                      const reconstruct::ReconstructedLine& line) {
  if (!value) throw std::logic_error(std::string("a line without geometry: ") + status_name(line));
  return *value;
}

inline const Segment3& segment_of(const reconstruct::ReconstructedLine& line) {
  return value_of(line.segment_in_local, line);
}

inline const Segment3& right_segment_of(const reconstruct::ReconstructedLine& line) {
  return value_of(line.other_segment_in_local, line);
}

inline const Matrix6d& covariance_of(const reconstruct::ReconstructedLine& line) {
  return value_of(line.covariance_m2, line);
}

}  // namespace ridgeline::test
