// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/line_format_options.h"

#include "io/lines/write_lines.h"

namespace ridgeline::apps {

std::vector<std::string> line_format_names() {
  std::vector<std::string> names;
  for (const io::LineFormatInfo& info : io::line_formats()) names.emplace_back(info.name);
  return names;
}

void add_local_origin_flag(CLI::App& app, bool& local_origin) {
  app.add_flag(
      "--local-origin", local_origin,
      "lines as OBJ and PLY relative to an origin that the file states, for programs that hold "
      "coordinates in 32 bits");
}

}  // namespace ridgeline::apps
