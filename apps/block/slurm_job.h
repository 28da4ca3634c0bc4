// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/block/estimate.h"

#include <cstddef>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// What the scripts of a block state: how the program is called, and what its plan estimates.
struct SlurmJob {
  std::string program;             ///< absolute path
  std::vector<std::string> words;  ///< all but the step: "block", "BLOCK.yaml", "--out", "DIR", ...
  std::string working_folder;      ///< absolute path; `words` are relative to it
  std::string folder;              ///< absolute path of DIR, which holds the scripts
  std::size_t n_tasks = 0;         ///< at least 1
  int threads = 1;                 ///< of a task and of the merge, at least 1
  TaskEstimate task;               ///< the time of the slowest and the memory of the largest task
  double total_task_s = 0.0;       ///< estimated for all tasks one after another
  TaskEstimate merge;
};

/// tasks.sbatch: an array of at most 1000 elements, Slurm's default limit. An element runs several
/// tasks if one would end within a minute, because Slurm takes a moment to start each element.
std::string tasks_script(const SlurmJob& job);

/// merge.sbatch: one job that merges the results of all tasks.
std::string merge_script(const SlurmJob& job);

/// submit.sh: submits both jobs, the merge after the end of all tasks, including failed ones. It
/// passes its arguments, such as --time and --mem, on to both calls of sbatch.
std::string submit_script(const SlurmJob& job);

/// parallel.sh: the same tasks and the merge by GNU parallel, to which it passes its arguments on.
std::string parallel_script(const SlurmJob& job);

/// How to start the scripts, with limits of time and memory that leave room above the estimates.
std::string how_to_submit(const SlurmJob& job);

}  // namespace ridgeline::apps
