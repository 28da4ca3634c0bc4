// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/command.h"
#include "apps/common/exit_code.h"
#include "apps/common/sample_data.h"
#include "apps/run/run_patches.h"

#include <memory>

namespace ridgeline::apps {
namespace {

int run_demo(const std::string& folder) {
  std::vector<std::string> patch_files;
  for (const std::filesystem::path& patch : sample_patches()) {
    patch_files.push_back((patch / "patch.yaml").string());
  }
  run_patches("demo", patch_files, RunOptions(), folder);
  return kDone;
}

}  // namespace

Run add_demo(CLI::App& subcommand) {
  auto out = std::make_shared<std::string>("ridgeline_demo");
  subcommand.add_option("--out", *out, "folder for the results")->capture_default_str();
  return [out] { return run_demo(*out); };
}

}  // namespace ridgeline::apps
