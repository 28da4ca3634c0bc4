// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/orientation/xml_tree.h"

#include <initializer_list>
#include <map>
#include <string>
#include <string_view>

namespace ridgeline::io {

/// Elements of cameras and poses that a reader does not know: they may change what a pixel means,
/// as fiducial marks and the motion during a rolling shutter do.
class UnreadElements {
 public:
  /// Notes the children of `element` that are not in `known`, except those that are off: "false",
  /// zero, or without content. The elements `property` are identified by their attribute `name`.
  void note(const XmlElement& element, std::initializer_list<std::string_view> known);

  /// Describes them for a warning: "elements that are not read: rolling_shutter in sensor (2)";
  /// empty if there are none.
  [[nodiscard]] std::string sentence() const;

 private:
  std::map<std::string, int> counts_;  ///< by "rolling_shutter in sensor"
};

}  // namespace ridgeline::io
