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

/// Slurm's default of MaxArraySize is 1001, and element numbers must be below it.
constexpr std::size_t kMaxElements = 1000;
/// Slurm needs 0.2 s to start an element.
constexpr double kMinElementTime_s = 60.0;
/// Margins on the estimates: hosts differ and share disks; an element may wait for its second
/// attempt; the shell and libraries need memory, too.
constexpr double kTimeMargin = 3.0;
constexpr double kMoreTime_s = 600.0;
constexpr double kMemoryMargin = 1.5;
constexpr double kMoreMemoryMib = 256.0;

constexpr std::string_view kPlain =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_./,:=+@-";

/// Quotes a word so that a shell takes it literally.
std::string shell_quoted(const std::string& word) {
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) {
    if (c == '\'') {
      quoted += "'\\''";
    } else {
      quoted += c;
    }
  }
  return quoted + "'";
}

/// The command without its step. It uses the number of threads that the job requests.
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

/// The time limit for work with this estimated time.
int limit_min(double estimated_s) {
  return static_cast<int>(std::ceil((kTimeMargin * estimated_s + kMoreTime_s) / 60.0));
}

int element_min(const SlurmJob& job) {
  const double slowest_s = static_cast<double>(tasks_per_element(job)) * job.task_s;
  return limit_min(std::min(slowest_s, std::max(job.total_task_s, job.task_s)));
}

int limit_mib(double estimated_mib) {
  return static_cast<int>(std::ceil(kMemoryMargin * estimated_mib + kMoreMemoryMib));
}

/// A label derived from the folder of the block, because #SBATCH lines have special rules for
/// blanks and quotes.
std::string job_name(const SlurmJob& job, std::string_view step) {
  std::string name =
      fmt::format("{}-{}", std::filesystem::path(job.folder).filename().string(), step);
  for (char& c : name) {
    if (kPlain.find(c) == std::string_view::npos) c = '_';
  }
  return name;
}

/// Paths in #SBATCH lines are relative to DIR, from which submit.sh submits: a `%` or quote in the
/// path of DIR would mean something else there.
std::string sbatch_lines(const SlurmJob& job, std::string_view step, int mib, int minutes) {
  return fmt::format(
      "#SBATCH --job-name={}\n"
      "#SBATCH --nodes=1\n"
      "#SBATCH --ntasks=1\n"
      "#SBATCH --cpus-per-task={}\n"
      "#SBATCH --mem={}M\n"
      "#SBATCH --time={}\n"
      "#SBATCH --requeue\n"
      "#SBATCH --open-mode=append\n",
      job_name(job, step), job.threads, mib, minutes);
}

/// Slurm does not repeat failed work, so the script does. Finished work is not repeated.
std::string in_two_attempts(const SlurmJob& job, std::string_view step) {
  return fmt::format(
      "cd {} || exit\n"
      "step() {{\n"
      "  {} {}\n"
      "}}\n"
      "# A second attempt helps if another process still held the folder or a disk was away.\n"
      "step || {{\n"
      "  sleep \"${{RIDGELINE_RETRY_S:-60}}\"\n"
      "  step\n"
      "}}\n",
      shell_quoted(job.working_folder), command_of(job), step);
}

}  // namespace

std::string tasks_script(const SlurmJob& job) {
  check(job.n_tasks > 0, "n_tasks = ", job.n_tasks, ", must be positive");
  std::string text =
      "#!/bin/sh\n"
      "# The tasks of a block, by `ridgeline block --slurm`. submit.sh submits this and the "
      "merge.\n";
  text += sbatch_lines(job, "tasks", limit_mib(job.task_mib), element_min(job));
  text += fmt::format(
      "#SBATCH --array=1-{}\n"
      "#SBATCH --output=logs/tasks.%a.log\n"
      "set -u\n"
      "n_tasks={}\n"
      "tasks_per_element={}\n",
      n_elements(job), job.n_tasks, tasks_per_element(job));
  text +=
      "first=$(((SLURM_ARRAY_TASK_ID - 1) * tasks_per_element + 1))\n"
      "last=$((first + tasks_per_element - 1))\n"
      "[ \"$last\" -le \"$n_tasks\" ] || last=$n_tasks\n"
      "echo \"Tasks $first-$last on $SLURMD_NODENAME, restart ${SLURM_RESTART_COUNT:-0}, "
      "$(date)\"\n";
  return text + in_two_attempts(job, "--task \"$first-$last\"");
}

std::string merge_script(const SlurmJob& job) {
  std::string text =
      "#!/bin/sh\n"
      "# Merges the results of the tasks of a block, by `ridgeline block --slurm`.\n";
  text += sbatch_lines(job, "merge", limit_mib(job.merge_mib), limit_min(job.merge_s));
  text +=
      "#SBATCH --output=logs/merge.log\n"
      "set -u\n"
      "echo \"Merge on $SLURMD_NODENAME, restart ${SLURM_RESTART_COUNT:-0}, $(date)\"\n";
  return text + in_two_attempts(job, "--merge");
}

std::string submit_script(const SlurmJob& job) {
  std::string text = fmt::format(
      "#!/bin/sh\n"
      "# Submits the tasks of a block and their merge to Slurm. Takes options of sbatch for both, "
      "as\n"
      "# --account and --partition. May be submitted again: finished tasks take no time.\n"
      "set -eu\n"
      "cd {}\n"
      "mkdir -p logs\n",
      shell_quoted(job.folder));
  text +=
      "tasks=$(sbatch --parsable \"$@\" tasks.sbatch)\n"
      "tasks=${tasks%%;*}  # the name of a cluster may follow\n"
      "# Not afterok: of what failed the merge says what is missing.\n"
      "merge=$(sbatch --parsable \"$@\" --dependency=\"afterany:$tasks\" merge.sbatch)\n"
      "echo \"Job $tasks does the tasks, job ${merge%%;*} merges. Logs are in $PWD/logs\"\n";
  return text;
}

std::string parallel_script(const SlurmJob& job) {
  const std::string command = command_of(job);
  // A share of the cores, so that it is valid on every host of -S.
  const int share = std::max(1, 100 / job.threads);
  return fmt::format(
      "#!/bin/sh\n"
      "# The tasks of a block and their merge by GNU parallel. Takes options of parallel, as -j 4 "
      "or\n"
      "# -S host1,host2. May be started again: finished tasks take no time.\n"
      "set -u\n"
      "mkdir -p {}\n"
      "cd {} || exit\n"
      "seq {} |\n"
      "  parallel -q --wd \"$PWD\" -j {}% --memfree {}M --retries 2 --joblog {} \"$@\" \\\n"
      "    {} --task {{}}\n"
      "{} --merge\n",
      shell_quoted(job.folder + "/logs"), shell_quoted(job.working_folder), job.n_tasks, share,
      limit_mib(job.task_mib), shell_quoted(job.folder + "/logs/parallel.tsv"), command, command);
}

std::string how_to_submit(const SlurmJob& job) {
  const auto script = [&](const char* name) {
    return "sh " + shell_quoted(job.folder + "/" + name);
  };
  return fmt::format(
      "{} tasks in an array of {}, each at most {} MiB and {} min with {}; then the merge, "
      "at most {} MiB and {} min\n"
      "  Slurm         {} [--partition=P --account=A]\n"
      "  GNU parallel  {} [-S host1,host2]\n",
      job.n_tasks, n_elements(job), limit_mib(job.task_mib), element_min(job),
      job.threads == 1 ? "1 thread" : fmt::format("{} threads", job.threads),
      limit_mib(job.merge_mib), limit_min(job.merge_s), script("submit.sh"), script("parallel.sh"));
}

}  // namespace ridgeline::apps
