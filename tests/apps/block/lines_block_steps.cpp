// SPDX-License-Identifier: BSD-3-Clause
// Does one step of a block of lines, so that tests can run steps in processes of their own:
//   lines_block_steps BLOCK.yaml OUT plan|merge|task N [LIDAR_SIGMA_M]
#include "apps/block/lines_block.h"
#include "io/error.h"

#include <cstdio>
#include <exception>
#include <string>
#include <vector>

int main(int argc, char** argv) {
  using namespace ridgeline;
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  try {
    apps::LinesBlockOptions options;
    const bool is_task = arguments.at(2) == "task";
    const std::size_t at_sigma = is_task ? 4 : 3;
    if (arguments.size() > at_sigma) {
      options.parameters.lidar_sigma_m = std::stod(arguments[at_sigma]);
    }
    const auto block = apps::make_lines_block(arguments[0], arguments[1], options);
    if (arguments[2] == "plan") block->plan();
    if (is_task) block->run_task(std::stoul(arguments.at(3)));
    if (arguments[2] == "merge") return block->merge() == 0 ? 0 : 1;
    for (std::size_t i = 0; arguments[2] == "plan" && i < block->n_tasks(); ++i) {
      std::printf("%s\n", block->name_of(i).c_str());
    }
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
