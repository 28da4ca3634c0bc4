// SPDX-License-Identifier: BSD-3-Clause
#include "io/project/stated_crs.h"

#include <stdexcept>
#include <string>

namespace ridgeline::io {

Crs stated_crs(const YamlMap& file) {
  if (!file.has("crs")) return {};
  Crs crs{file.text("crs")};
  try {
    describe(crs);
  } catch (const std::invalid_argument& error) {
    file.fail("crs", std::string("crs: ") + error.what());
  }
  return crs;
}

}  // namespace ridgeline::io
