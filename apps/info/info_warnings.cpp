// SPDX-License-Identifier: BSD-3-Clause
#include "apps/info/info_warnings.h"

#include "apps/common/say.h"
#include "io/files/shared_warnings.h"

#include <fmt/format.h>

namespace ridgeline::apps {

void InfoWarnings::add(const std::string& path, const std::string& warning) {
  if (is_single_) return answer(fmt::format("  warning     {}\n", warning));
  const std::string prefix = path + ": ";
  collected_.push_back(warning.starts_with(prefix) ? warning : prefix + warning);
}

void InfoWarnings::print() const {
  for (const std::string& warning : io::shared_warnings(collected_))
    answer(fmt::format("warning: {}\n", warning));
}

}  // namespace ridgeline::apps
