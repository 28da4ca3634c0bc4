// SPDX-License-Identifier: BSD-3-Clause
#include "apps/block/cluster_files.h"

#include "apps/block/slurm_job.h"
#include "apps/common/say.h"
#include "evaluate/files/output_folder.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <vector>

namespace ridgeline::apps {
namespace fs = std::filesystem;
namespace {

/// The command-line arguments of this process, without the program.
std::vector<std::string> own_words() {
  std::ifstream stream("/proc/self/cmdline", std::ios::binary);
  std::vector<std::string> words;
  for (std::string word; std::getline(stream, word, '\0');) words.push_back(word);
  words.erase(words.begin());
  return words;
}

/// The arguments without the step and the number of threads, which the scripts specify themselves.
std::vector<std::string> words_of_all_steps() {
  const std::vector<std::string> own = own_words();
  std::vector<std::string> words;
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (own[i] == "--slurm" || own[i].starts_with("--jobs=")) continue;
    if (own[i] == "--jobs") {
      ++i;  // its value
      continue;
    }
    words.push_back(own[i]);
  }
  return words;
}

SlurmJob job_of(const FramesBlock& block, const std::string& folder, int threads) {
  SlurmJob job;
  job.program = fs::read_symlink("/proc/self/exe").string();
  job.words = words_of_all_steps();
  job.working_folder = fs::current_path().string();
  job.folder = fs::canonical(folder).string();
  job.n_tasks = block.n_tasks();
  job.threads = threads;
  for (std::size_t i = 0; i < job.n_tasks; ++i) {
    const TaskEstimate task = block.estimate_of_task(i);
    job.task.seconds = std::max(job.task.seconds, task.seconds / threads);
    job.task.memory_mib = std::max(job.task.memory_mib, task.memory_mib);
    job.total_task_s += task.seconds / threads;
  }
  job.merge = block.estimate_of_merge();
  job.merge.seconds /= threads;
  return job;
}

}  // namespace

void write_cluster_files(const FramesBlock& block, const std::string& folder, int threads) {
  const SlurmJob job = job_of(block, folder, threads);
  const results::OutputFolder out(folder, {});
  out.write("tasks.sbatch", tasks_script(job));
  out.write("merge.sbatch", merge_script(job));
  out.write("submit.sh", submit_script(job));
  out.write("parallel.sh", parallel_script(job));
  say("{}", how_to_submit(job));
}

}  // namespace ridgeline::apps
