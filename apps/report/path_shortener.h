// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/tables/summary_json.h"

#include <string>
#include <vector>

namespace ridgeline::apps {

/// Takes the folders of known files out of texts that are passed on: where the data lies is the
/// sender's own business.
class PathShortener {
 public:
  /// `paths` are files and folders, in the form in which texts name them.
  explicit PathShortener(const std::vector<std::string>& paths);

  /// Removes the folders of the known paths from the text, wherever a path in one of them stands.
  void shorten(std::string& text) const;
  /// Shortens all texts within `json`.
  void shorten(evaluate::Json& json) const;

 private:
  std::vector<std::string> folders_;  ///< with the closing slash, longest first
};

}  // namespace ridgeline::apps
