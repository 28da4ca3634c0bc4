// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::io {

/// The keys of the outermost mapping of a text, which may be cut off.
struct TopKeys {
  std::vector<std::string> names;
  std::string type;  ///< the value of the key `type`, if it is a string

  [[nodiscard]] bool has(std::string_view name) const;
};

/// The outermost keys of JSON, or of YAML in either style. Nothing is checked: the text may be cut
/// off or in another format.
TopKeys top_keys(std::string_view text);

}  // namespace ridgeline::io
