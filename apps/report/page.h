// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace ridgeline::apps {

/// A front end, as bundled from apps/report/web.
struct FrontEnd {
  std::string_view script, style;
};

FrontEnd run_front_end();    ///< for the report of a run
FrontEnd block_front_end();  ///< for the report of a block and the pages of its patches
FrontEnd edges_front_end();  ///< for the page of the edges of a point cloud

/// Makes JSON text safe inside an HTML script element: every `<` is written as \u003c, so that
/// nothing in it can close the element or open a comment. The text still parses to the same value.
std::string script_safe(std::string_view json);

/// Returns the whole page: one file that needs no network and whose content security policy
/// prevents it from loading anything. `data` is JSON, from which the front end builds everything
/// that is shown. `elsewhere`: a sentence for readers without JavaScript.
std::string report_page(
    std::string_view title,
    std::string_view data,
    const FrontEnd& front_end,
    std::string_view elsewhere =
        "The tables next to it, starting with table2.md, have the same figures.");

}  // namespace ridgeline::apps
