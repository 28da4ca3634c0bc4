// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// What the scripts of a block need to know: how the program is called, and what its plan foresees.
struct SlurmJob {
  std::string program;             ///< absolute path
  std::vector<std::string> words;  ///< all but the step: "block", "BLOCK.yaml", "--out", "DIR", ...
  std::string working_folder;      ///< absolute path; `words` are relative to it
  std::string folder;              ///< absolute path of DIR, which holds the scripts
  std::size_t n_tasks = 0;         ///< at least 1
  int threads = 1;                 ///< of a task and of the merge, at least 1
  double task_s = 0.0;             ///< estimated for the slowest task
  double task_mib = 0.0;           ///< estimated for the largest task
  double total_task_s = 0.0;       ///< estimated for all tasks one after another
  double merge_s = 0.0;            ///< estimated
  double merge_mib = 0.0;          ///< estimated
};

/// tasks.sbatch: an array of at most 1000 elements, which is what Slurm takes by default. An
/// element does several tasks where one would end within a minute: Slurm needs a moment for each
/// element.
std::string tasks_script(const SlurmJob& job);

/// merge.sbatch: one job that merges the results of all tasks.
std::string merge_script(const SlurmJob& job);

/// submit.sh: submits both jobs, the merge after the end of all tasks, failed ones as well. It
/// passes its arguments on to both calls of sbatch.
std::string submit_script(const SlurmJob& job);

/// parallel.sh: the same tasks and the merge by GNU parallel, to which it passes its arguments on.
std::string parallel_script(const SlurmJob& job);

/// What to say once the scripts are written: how to start them, and what they ask for.
std::string how_to_submit(const SlurmJob& job);

}  // namespace ridgeline::apps
