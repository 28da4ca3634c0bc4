// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// Inputs for the scripts of a block: the program call and the estimates of the plan.
struct SlurmJob {
  std::string program;             ///< absolute path
  std::vector<std::string> words;  ///< all except the step: "block", "BLOCK.yaml", "--out", ...
  std::string working_folder;      ///< absolute path; `words` are relative to it
  std::string folder;              ///< absolute path of DIR, which contains the scripts
  std::size_t n_tasks = 0;         ///< at least 1
  int threads = 1;                 ///< per task and for the merge, at least 1
  double task_s = 0.0;             ///< estimated for the slowest task
  double task_mib = 0.0;           ///< estimated for the largest task
  double total_task_s = 0.0;       ///< estimated for all tasks in sequence
  double merge_s = 0.0;            ///< estimated
  double merge_mib = 0.0;          ///< estimated
};

/// tasks.sbatch: an array of at most 1000 elements, the default limit of Slurm. An element runs
/// several tasks if a single one would finish within a minute, because Slurm has an overhead per
/// element.
std::string tasks_script(const SlurmJob& job);

/// merge.sbatch: one job that merges the results of all tasks.
std::string merge_script(const SlurmJob& job);

/// submit.sh: submits both jobs; the merge runs after all tasks have ended, even if some failed. It
/// passes its arguments on to both calls of sbatch.
std::string submit_script(const SlurmJob& job);

/// parallel.sh: runs the same tasks and the merge with GNU parallel, to which it passes its
/// arguments.
std::string parallel_script(const SlurmJob& job);

/// Message after writing the scripts: how to start them, and the resources they request.
std::string how_to_submit(const SlurmJob& job);

}  // namespace ridgeline::apps
