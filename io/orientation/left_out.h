// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ridgeline::io {

/// The content of an orientation file that a reader leaves out, by reason.
class LeftOut {
 public:
  /// `reason`: "images without a pose"; `item`: what identifies one of them in the file.
  void add(std::string_view reason, std::string item);

  /// One sentence per reason, in the order of their first items.
  [[nodiscard]] std::vector<std::string> sentences() const;

 private:
  std::vector<std::pair<std::string, std::vector<std::string>>> items_;
};

}  // namespace ridgeline::io
