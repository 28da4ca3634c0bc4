// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ridgeline::cli {

struct StepResult {
  std::string name;  ///< its `run` or `uses`
  int exit_code = 0;
  std::string output;
};

/// The only job of a GitHub Actions workflow, run as the runner does: `run` steps by bash in the
/// checkout, with GITHUB_PATH and GITHUB_STEP_SUMMARY; after a failure only those with
/// `if: always()`. Of the actions, checkout takes what the test has put into the folder, or with
/// `path` this source tree, built already, and upload-artifact asks whether its files are there.
class CiJob {
 public:
  CiJob(const std::string& workflow, std::filesystem::path checkout);

  [[nodiscard]] std::vector<StepResult> run() const { return run_from(""); }
  /// From the first `run` step that begins with `command`.
  [[nodiscard]] std::vector<StepResult> run_from(const std::string& command) const;
  [[nodiscard]] std::filesystem::path step_summary() const;

 private:
  struct Step {
    std::string run, uses, path;
    bool always = false;
  };
  [[nodiscard]] StepResult run_step(const Step& step) const;
  [[nodiscard]] StepResult run_script(const std::string& script) const;

  std::filesystem::path checkout_;
  std::vector<Step> steps_;
};

}  // namespace ridgeline::cli
