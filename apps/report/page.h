// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace ridgeline::apps {

/// A front end, as bundled from apps/report/web.
struct FrontEnd {
  std::string_view script, style;
};

FrontEnd run_front_end();    ///< of the report of a run
FrontEnd block_front_end();  ///< of the report of a block and of its patches' pages

/// JSON text that may stand in an HTML script element: every `<` is written \u003c, so that nothing
/// in it can close the element or open a comment. It reads back as the same value.
std::string script_safe(std::string_view json);

/// The whole page: one file that needs no network and, by its content security policy, can load
/// nothing. `data` is JSON; the front end builds everything that is shown from it.
std::string report_page(std::string_view title, std::string_view data, const FrontEnd& front_end);

}  // namespace ridgeline::apps
