// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/tables/summary_json.h"

#include <string>
#include <vector>

namespace ridgeline::apps {

/// Removes the folders of known files from texts that are passed on, because the location of the
/// data concerns only the sender.
class PathShortener {
 public:
  /// `paths`: files and folders, written as in the texts.
  explicit PathShortener(const std::vector<std::string>& paths);

  /// Removes the folders of the known paths wherever the text contains a path in one of them.
  void shorten(std::string& text) const;
  /// Shortens all strings in `json`.
  void shorten(evaluate::Json& json) const;

 private:
  std::vector<std::string> folders_;  ///< with a trailing slash, longest first
};

}  // namespace ridgeline::apps
