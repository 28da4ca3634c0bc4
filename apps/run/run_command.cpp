// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/command.h"
#include "apps/run/run_options.h"
#include "apps/run/run_patches.h"

#include <memory>

namespace ridgeline::apps {

Run add_run(CLI::App& subcommand) {
  struct Arguments {
    std::vector<std::string> patches;
    std::string out;
    RunFlags flags;
  };
  auto a = std::make_shared<Arguments>();
  subcommand.add_option("patches", a->patches, "patch files (YAML): images, cameras, LIDAR")
      ->required();
  subcommand.add_option("--out", a->out, "folder for the results")->required();
  add_run_flags(subcommand, a->flags);
  return [a] {
    run_patches("run", a->patches, run_options(a->flags), a->out);
    return static_cast<int>(kDone);
  };
}

}  // namespace ridgeline::apps
