// SPDX-License-Identifier: BSD-3-Clause
#include "apps/block/cluster_files.h"
#include "apps/block/frames_block.h"
#include "apps/common/command.h"
#include "apps/common/say.h"
#include "apps/common/shared_options.h"
#include "apps/report/write_report.h"
#include "apps/run/run_options.h"
#include "io/error.h"
#include "io/text/text.h"
#include "reconstruct/geometry/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ridgeline::apps {
namespace {

struct BlockArguments {
  std::string file, out, task;
  bool plan = false, merge = false, slurm = false;
  RunFlags flags;
};

/// The first and last task, numbered from 0.
std::pair<std::size_t, std::size_t> tasks_of(const std::string& text, std::size_t n) {
  const std::size_t dash = text.find('-');
  const auto first = io::to_double(text.substr(0, dash));
  const auto last = dash == std::string::npos ? first : io::to_double(text.substr(dash + 1));
  const bool are_numbers =
      first && last && *first == std::floor(*first) && *last == std::floor(*last);
  check(are_numbers && *first >= 1.0 && *first <= *last && *last <= static_cast<double>(n),
        "--task ", text, ": the tasks of this block are 1 to ", n,
        "; give one number or FIRST-LAST");
  return {static_cast<std::size_t>(*first) - 1, static_cast<std::size_t>(*last) - 1};
}

std::string duration_text(double seconds) {
  if (seconds < 100.0) return fmt::format("{:.0f} s", seconds);
  if (seconds < 6000.0) return fmt::format("{:.0f} min", seconds / 60.0);
  return fmt::format("{:.1f} h", seconds / 3600.0);
}

/// Runs tasks one after another and prints the estimated remaining time after each. Failures are
/// reported, and the remaining tasks still run.
/// @return the number of tasks that failed
std::size_t run_tasks(FramesBlock& block, std::size_t first, std::size_t last) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  std::size_t n_failed = 0;
  for (std::size_t i = first; i <= last; ++i) {
    const auto begin = Clock::now();
    try {
      block.run_task(i);
    } catch (const io::IoError& error) {
      ++n_failed;
      spdlog::error("{}: {}", block.name_of(i), error.what());
    } catch (const std::exception& error) {
      ++n_failed;
      spdlog::error("{}: internal error: {}", block.name_of(i), error.what());
    }
    const std::chrono::duration<double> task = Clock::now() - begin, all = Clock::now() - start;
    const double left_s =
        all.count() / static_cast<double>(i - first + 1) * static_cast<double>(last - i);
    spdlog::info("{} of {}: {}, {}; {} left", i + 1, block.n_tasks(), block.name_of(i),
                 duration_text(task.count()), duration_text(left_s));
  }
  return n_failed;
}

/// "120 tasks; estimated: 96 min of processor time in all, 900 MiB for the largest".
std::string estimate_text(const FramesBlock& block) {
  TaskEstimate all;
  for (std::size_t i = 0; i < block.n_tasks(); ++i) {
    const TaskEstimate task = block.estimate_of_task(i);
    all.seconds += task.seconds;
    all.memory_mib = std::max(all.memory_mib, task.memory_mib);
  }
  return fmt::format("{} tasks; estimated: {} of CPU time in total, {:.0f} MiB for the largest",
                     block.n_tasks(), duration_text(all.seconds), all.memory_mib);
}

/// `jobs`: from the command line, or 0.
int run_block(const BlockArguments& a, int jobs) {
  RunOptions options = run_options(a.flags);
  options.n_decoys = 0;  // parts of a block contain only some of its lines
  FramesBlock block(a.file, a.out, std::move(options));
  const bool is_one_step = !a.task.empty() || a.merge;
  const std::filesystem::path plan = std::filesystem::path(a.out) / "plan.json";
  if (is_one_step && !std::filesystem::exists(plan)) {
    throw io::IoError(plan.string(), "there is no plan; create it first: ridgeline block " +
                                         a.file + " --out " + a.out + " --plan");
  }
  block.plan();
  if (!a.task.empty()) {
    const auto [first, last] = tasks_of(a.task, block.n_tasks());
    return run_tasks(block, first, last) == 0 ? kDone : kWrongInput;
  }
  if (a.plan) {
    say("{}: {}. Next: ridgeline block {} --out {} --task 1-{}, then --merge\n", plan.string(),
        estimate_text(block), a.file, a.out, block.n_tasks());
    return kDone;
  }
  if (a.slurm) {
    // Tasks with one thread use processor time most efficiently, and there are many tasks.
    write_cluster_files(block, a.out, std::max(jobs, 1));
    return kDone;
  }
  if (!a.merge) (void)run_tasks(block, 0, block.n_tasks() - 1);
  const std::size_t n_missing = block.merge();
  say("Results: {}\n", std::filesystem::absolute(a.out).lexically_normal().string());
  if (n_missing == 0) return kDone;
  spdlog::error(
      "{} of {} tasks have no results; fix the reported problems and restart: finished tasks are "
      "kept",
      n_missing, block.n_tasks());
  return kWrongInput;
}

void add_steps(CLI::App& app, BlockArguments& a) {
  const char* group = "Steps, which can run on different hosts; by default all run here";
  CLI::Option* plan =
      app.add_flag("--plan", a.plan, "divide the block into patches and write plan.json")
          ->group(group);
  CLI::Option* task =
      app.add_option("--task", a.task, "reconstruct these patches: I or FIRST-LAST, counted from 1")
          ->group(group);
  CLI::Option* merge =
      app.add_flag("--merge", a.merge, "merge and judge the lines of all finished tasks")
          ->group(group);
  CLI::Option* slurm =
      app.add_flag("--slurm", a.slurm,
                   "write scripts that submit all steps to Slurm or run them with GNU parallel")
          ->group(group);
  plan->excludes(task)->excludes(merge)->excludes(slurm);
  task->excludes(merge)->excludes(slurm);
  merge->excludes(slurm);
}

}  // namespace

Run add_block(CLI::App& subcommand) {
  auto a = std::make_shared<BlockArguments>();
  subcommand.add_option("block", a->file, "block file (YAML): frames, their orientation, LIDAR")
      ->required();
  subcommand.add_option("--out", a->out, "folder of the block; finished tasks there are kept")
      ->required();
  add_steps(subcommand, *a);
  add_block_flags(subcommand, a->flags);
  const CLI::Option* jobs = subcommand.get_parent()->get_option("--jobs");
  return [a, jobs] { return run_block(*a, jobs->count() > 0 ? jobs->as<int>() : 0); };
}

}  // namespace ridgeline::apps
