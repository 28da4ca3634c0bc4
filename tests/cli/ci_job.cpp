// SPDX-License-Identifier: BSD-3-Clause
#include "tests/cli/ci_job.h"

#include "tests/cli/cli_fixture.h"

#include <yaml-cpp/yaml.h>

#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace ridgeline::cli {
namespace fs = std::filesystem;
namespace {

/// A build tree that has finished: its target `ridgeline` is the program that is tested. The one of
/// this test would link it anew under the feet of other tests where a source has changed.
void make_build_tree(const fs::path& folder) {
  write(folder / "CMakeCache.txt",
        "CMAKE_PROJECT_NAME:STATIC=ridgeline\nCMAKE_GENERATOR:INTERNAL=Ninja\n"
        "CMAKE_MAKE_PROGRAM:FILEPATH=ninja\n");
  write(folder / "build.ninja", "build ridgeline: phony\n");
  fs::create_directory_symlink(fs::path(RIDGELINE_BINARY).parent_path(), folder / "apps");
}

/// A checkout of this source tree, built.
void check_out_source(const fs::path& folder) {
  if (fs::exists(folder)) return;
  fs::create_directories(folder);
  for (const auto& entry : fs::directory_iterator(RIDGELINE_SOURCE_DIR)) {
    const fs::path name = entry.path().filename();
    if (name == "build" || name == "out" || name == ".git") continue;
    fs::create_symlink(entry.path(), folder / name);
  }
  make_build_tree(folder / "build/release");
}

std::string text_of(const YAML::Node& node) { return node ? node.Scalar() : ""; }

}  // namespace

CiJob::CiJob(const std::string& workflow, fs::path checkout) : checkout_(std::move(checkout)) {
  const YAML::Node jobs = YAML::Load(workflow)["jobs"];
  if (jobs.size() != 1) throw std::runtime_error("the workflow must have one job");
  for (const YAML::Node& node : jobs.begin()->second["steps"]) {
    Step step;
    step.run = text_of(node["run"]);
    step.uses = text_of(node["uses"]);
    if (node["with"]) step.path = text_of(node["with"]["path"]);
    step.always = text_of(node["if"]) == "always()";
    steps_.push_back(std::move(step));
  }
}

fs::path CiJob::step_summary() const { return checkout_.parent_path() / "github_step_summary"; }

std::vector<StepResult> CiJob::run_from(const std::string& command) const {
  std::vector<StepResult> results;
  bool has_begun = command.empty();
  bool has_failed = false;
  for (const Step& step : steps_) {
    has_begun = has_begun || step.run.starts_with(command);
    if (!has_begun || (has_failed && !step.always)) continue;
    results.push_back(run_step(step));
    has_failed = has_failed || results.back().exit_code != 0;
  }
  return results;
}

StepResult CiJob::run_step(const Step& step) const {
  if (!step.run.empty()) return run_script(step.run);
  if (step.uses.starts_with("actions/checkout@")) {
    if (!step.path.empty()) check_out_source(checkout_ / step.path);
    return {step.uses, 0, ""};
  }
  if (step.uses.starts_with("actions/upload-artifact@")) {
    std::istringstream files(step.path);
    for (std::string file; std::getline(files, file);) {
      if (!fs::exists(checkout_ / file)) return {step.uses, 1, file + " does not exist"};
    }
    return {step.uses, 0, ""};
  }
  return {step.uses, 1, "an action that this test does not know"};
}

StepResult CiJob::run_script(const std::string& script) const {
  const fs::path github_path = checkout_.parent_path() / "github_path";
  std::string search_path = std::getenv("PATH");
  if (fs::exists(github_path)) {
    std::istringstream folders(read(github_path));
    for (std::string folder; std::getline(folders, folder);) {
      search_path.insert(0, folder + ":");
    }
  }
  const fs::path file = checkout_.parent_path() / "step.sh";
  write(file, script);
  const ProgramResult result =
      test::run_program("/bin/bash", {"-e", file.string()}, checkout_,
                        {"PATH=" + search_path, "GITHUB_PATH=" + github_path.string(),
                         "GITHUB_ACTIONS=true", "GITHUB_STEP_SUMMARY=" + step_summary().string()});
  return {script, result.exit_code, result.out + result.err};
}

}  // namespace ridgeline::cli
