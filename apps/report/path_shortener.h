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
  /// `paths`: of files and folders, all in the form in which texts name them.
  explicit PathShortener(const std::vector<std::string>& paths);

  /// Each path in the folder of a known one loses that folder, wherever it stands in the text.
  void shorten(std::string& text) const;
  /// All texts within.
  void shorten(evaluate::Json& json) const;

 private:
  std::vector<std::string> folders_;  ///< with the closing slash, longest first
};

}  // namespace ridgeline::apps
