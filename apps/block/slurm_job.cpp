// SPDX-License-Identifier: BSD-3-Clause
#include "apps/block/slurm_job.h"

#include "reconstruct/geometry/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string_view>

namespace ridgeline::apps {
namespace {

/// Slurm's default of MaxArraySize is 1001, and the numbers of elements must be below it.
constexpr std::size_t kMaxElements = 1000;
/// Slurm takes 0.2 s to start an element.
constexpr double kMinElementTime_s = 60.0;

constexpr std::string_view kPlain =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_./,:=+@-";

/// A word that a shell takes as it is.
std::string shell_quoted(const std::string& word) {
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

/// The command without its step. Its number of threads is what the job asks for.
std::string command_of(const SlurmJob& job) {
  std::string command = fmt::format("{} --jobs {}", shell_quoted(job.program), job.threads);
  for (const std::string& word : job.words) command += " " + shell_quoted(word);
  return command;
}

std::size_t quotient_up(std::size_t a, std::size_t b) { return (a + b - 1) / b; }

std::size_t tasks_per_element(const SlurmJob& job) {
  const std::size_t least = quotient_up(job.n_tasks, kMaxElements);
  const double mean_s = job.total_task_s / static_cast<double>(job.n_tasks);
  const double wanted = mean_s > 0.0 ? std::ceil(kMinElementTime_s / mean_s) : 1.0;
  const auto n_tasks = static_cast<double>(job.n_tasks);
  return std::max(least, static_cast<std::size_t>(std::clamp(wanted, 1.0, n_tasks)));
}

std::size_t n_elements(const SlurmJob& job) {
  return quotient_up(job.n_tasks, tasks_per_element(job));
}

/// A label, after the folder of the block: #SBATCH lines have rules of their own for blanks and
/// quotes.
std::string label_of(const SlurmJob& job) {
  std::string name = std::filesystem::path(job.folder).filename().string();
  for (char& c : name) {
    if (kPlain.find(c) == std::string_view::npos) c = '_';
  }
  return name;
}

/// A script of sbatch. Its paths are relative to DIR, from which submit.sh submits: a `%` or quote
/// in the path of DIR would mean something else in #SBATCH lines. Slurm does not repeat what
/// failed, so the script does; what is finished takes no time again.
/// @param head  further #SBATCH lines, then what comes before the step
std::string sbatch_script(const SlurmJob& job,
                          std::string_view name,
                          std::string_view head,
                          std::string_view step) {
  return fmt::format(R"sh(#!/bin/sh
# Written by `ridgeline block --slurm`; submit.sh submits it.
#SBATCH --job-name={label}-{name}
#SBATCH --nodes=1
#SBATCH --ntasks=1
#SBATCH --cpus-per-task={threads}
#SBATCH --requeue
#SBATCH --open-mode=append
{head}
cd {folder} || exit
step() {{
  {command} {step}
}}
# A second attempt helps if another process still held the folder or a disk was away.
step || {{
  sleep "${{RIDGELINE_RETRY_S:-60}}"
  step
}}
)sh",
                     fmt::arg("label", label_of(job)), fmt::arg("name", name),
                     fmt::arg("threads", job.threads), fmt::arg("head", head),
                     fmt::arg("folder", shell_quoted(job.working_folder)),
                     fmt::arg("command", command_of(job)), fmt::arg("step", step));
}

/// The options of sbatch for the tasks and for the merge, with room for hosts that differ and share
/// their disks, for a second attempt, and for the shell and libraries.
std::string limits_of(const SlurmJob& job) {
  constexpr double kTimeMargin = 3.0, kMoreTime_s = 600.0;
  constexpr double kMemoryMargin = 1.5, kMoreMemoryMib = 256.0;
  const double element_s = std::min(static_cast<double>(tasks_per_element(job)) * job.task.seconds,
                                    std::max(job.total_task_s, job.task.seconds));
  const double longest_s = std::max(element_s, job.merge.seconds);
  const double largest_mib = std::max(job.task.memory_mib, job.merge.memory_mib);
  return fmt::format("--time={:.0f} --mem={:.0f}M",
                     std::ceil((kTimeMargin * longest_s + kMoreTime_s) / 60.0),
                     std::ceil(kMemoryMargin * largest_mib + kMoreMemoryMib));
}

}  // namespace

std::string tasks_script(const SlurmJob& job) {
  check(job.n_tasks > 0, "n_tasks = ", job.n_tasks, ", must be positive");
  const std::string head =
      fmt::format(R"sh(#SBATCH --array=1-{n_elements}
#SBATCH --output=logs/tasks.%a.log
set -u
n_tasks={n_tasks}
tasks_per_element={per_element}
first=$(((SLURM_ARRAY_TASK_ID - 1) * tasks_per_element + 1))
last=$((first + tasks_per_element - 1))
[ "$last" -le "$n_tasks" ] || last=$n_tasks
echo "Tasks $first-$last on $SLURMD_NODENAME, restart ${{SLURM_RESTART_COUNT:-0}}, $(date)")sh",
                  fmt::arg("n_elements", n_elements(job)), fmt::arg("n_tasks", job.n_tasks),
                  fmt::arg("per_element", tasks_per_element(job)));
  return sbatch_script(job, "tasks", head, "--task \"$first-$last\"");
}

std::string merge_script(const SlurmJob& job) {
  return sbatch_script(job, "merge", R"sh(#SBATCH --output=logs/merge.log
set -u
echo "Merge on $SLURMD_NODENAME, restart ${SLURM_RESTART_COUNT:-0}, $(date)")sh",
                       "--merge");
}

std::string submit_script(const SlurmJob& job) {
  return fmt::format(R"sh(#!/bin/sh
# Submits the tasks of a block and their merge to Slurm. Takes options of sbatch for both, such as
# --time, --mem, --account and --partition. May be submitted again: finished tasks take no time.
set -eu
cd {folder}
mkdir -p logs
tasks=$(sbatch --parsable "$@" tasks.sbatch)
tasks=${{tasks%%;*}}  # the name of a cluster may follow
# Not afterok: of what failed the merge says what is missing.
merge=$(sbatch --parsable "$@" --dependency="afterany:$tasks" merge.sbatch)
echo "Job $tasks does the tasks, job ${{merge%%;*}} merges. Logs are in $PWD/logs"
)sh",
                     fmt::arg("folder", shell_quoted(job.folder)));
}

std::string parallel_script(const SlurmJob& job) {
  return fmt::format(R"sh(#!/bin/sh
# The tasks of a block and their merge by GNU parallel. Takes options of parallel, such as -j 4,
# --memfree 2G or -S host1,host2. May be started again: finished tasks take no time.
set -u
mkdir -p {logs}
cd {working_folder} || exit
seq {n_tasks} |
  parallel -q --wd "$PWD" -j {share}% --retries 2 --joblog {joblog} "$@" \
    {command} --task {{}}
{command} --merge
)sh",
                     fmt::arg("logs", shell_quoted(job.folder + "/logs")),
                     fmt::arg("working_folder", shell_quoted(job.working_folder)),
                     fmt::arg("n_tasks", job.n_tasks),
                     // of the cores, so that it holds on every host of -S
                     fmt::arg("share", std::max(1, 100 / job.threads)),
                     fmt::arg("joblog", shell_quoted(job.folder + "/logs/parallel.tsv")),
                     fmt::arg("command", command_of(job)));
}

std::string how_to_submit(const SlurmJob& job) {
  const auto script = [&](const char* name) {
    return "sh " + shell_quoted(job.folder + "/" + name);
  };
  return fmt::format(
      "{} tasks in an array of {}; the slowest is estimated at {:.0f} s, the largest at {:.0f} MiB "
      "with {}; the merge at {:.0f} s and {:.0f} MiB\n"
      "  Slurm         {} {} [--partition=P --account=A]\n"
      "  GNU parallel  {} [-S host1,host2]\n",
      job.n_tasks, n_elements(job), job.task.seconds, job.task.memory_mib,
      job.threads == 1 ? "1 thread" : fmt::format("{} threads", job.threads), job.merge.seconds,
      job.merge.memory_mib, script("submit.sh"), limits_of(job), script("parallel.sh"));
}

}  // namespace ridgeline::apps
