// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/command.h"
#include "apps/common/say.h"
#include "apps/common/shared_options.h"

#include <memory>

namespace ridgeline::apps {

Run add_config(CLI::App& subcommand) {
  auto preset = std::make_shared<std::string>("default");
  add_preset_option(subcommand, *preset);
  return [preset] {
    say("{}", to_yaml(preset_parameters(*preset)));
    return static_cast<int>(kDone);
  };
}

}  // namespace ridgeline::apps
