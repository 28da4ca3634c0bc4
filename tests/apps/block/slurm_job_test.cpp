// SPDX-License-Identifier: BSD-3-Clause
#include "apps/block/slurm_job.h"

#include "tests/support/run_program.h"
#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

namespace ridgeline::apps {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::Ge;
using testing::HasSubstr;
using testing::Lt;

/// A folder that words of a shell must be quoted for, with a program that writes down how it was
/// called.
class SlurmJobTest : public testing::Test {
 protected:
  SlurmJobTest() {
    fs::create_directories(folder_ / "data");
    write("program",
          "#!/bin/sh\n"
          "printf '<%s>' \"${PWD##*/}\" \"$@\" >>\"$CALLS\"\n"
          "echo >>\"$CALLS\"\n"
          "case $* in *--fail*) exit 1 ;; esac\n");
    fs::permissions(folder_ / "program", fs::perms::owner_all);
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  [[nodiscard]] std::vector<std::string> calls() const {
    std::vector<std::string> lines;
    std::ifstream stream(folder_ / "calls");
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
  }
  /// Runs a line of a shell in the folder.
  [[nodiscard]] test::ProgramResult shell(const std::string& line) const {
    return test::run_program(
        "/bin/sh", {"-c", line}, folder_,
        {"CALLS=" + (folder_ / "calls").string(), "SLURMD_NODENAME=n1", "RIDGELINE_RETRY_S=0",
         "PATH=" + folder_.string() + ":/usr/bin:/bin"});
  }
  [[nodiscard]] SlurmJob job(std::size_t n_tasks, double task_s) const {
    return {.program = (folder_ / "program").string(),
            .words = {"block", "it's.yaml", "--methods", "direct,joint"},
            .working_folder = (folder_ / "data").string(),
            .folder = folder_.string(),
            .n_tasks = n_tasks,
            .threads = 2,
            .task = {task_s, 1000.0},
            .total_task_s = task_s * static_cast<double>(n_tasks),
            .merge = {30.0, 500.0}};
  }

  io::TempFolder temporary_;
  fs::path folder_ = temporary_.file("its folder's $HOME \"job\" 50%");
};

std::size_t number_after(const std::string& text, const std::string& key) {
  std::smatch match;
  return std::regex_search(text, match, std::regex(key + "([0-9]+)")) ? std::stoul(match[1]) : 0;
}

/// How often each task was done, in the order of the tasks, by calls that end in `--task
/// FIRST-LAST`.
std::vector<int> times_done(const std::vector<std::string>& calls, std::size_t n_tasks) {
  std::vector<int> times(n_tasks + 1, 0);
  for (const std::string& call : calls) {
    std::smatch match;
    if (!std::regex_search(call, match, std::regex("<--task><([0-9]+)-([0-9]+)>$"))) continue;
    for (std::size_t i = std::stoul(match[1]); i <= std::stoul(match[2]); ++i) ++times.at(i);
  }
  times.erase(times.begin());
  return times;
}

TEST_F(SlurmJobTest, EveryTaskIsInOneElement) {
  for (const std::size_t n_tasks : {1U, 7U, 1000U, 1001U, 12345U}) {
    for (const double task_s : {0.0, 7.0, 100.0}) {
      const std::string script = tasks_script(job(n_tasks, task_s));
      const std::size_t n_elements = number_after(script, "--array=1-");
      ASSERT_LE(n_elements, 1000U);
      const std::size_t chunk = number_after(script, "tasks_per_element=");
      EXPECT_THAT(chunk * n_elements, Ge(n_tasks));
      EXPECT_THAT(chunk * (n_elements - 1), Lt(n_tasks)) << "an element without tasks";
    }
  }
}

TEST_F(SlurmJobTest, EveryTaskIsDoneOnce) {
  for (const std::size_t n_tasks : {1U, 7U, 1000U, 1001U, 12345U}) {
    fs::remove(folder_ / "calls");
    const std::string script = tasks_script(job(n_tasks, 1.0));
    write("tasks.sbatch", script);
    const std::size_t n_elements = number_after(script, "--array=1-");
    const auto result = shell("i=0; while [ $i -lt " + std::to_string(n_elements) +
                              " ]; do i=$((i + 1)); SLURM_ARRAY_TASK_ID=$i sh tasks.sbatch; done");
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(times_done(calls(), n_tasks), std::vector<int>(n_tasks, 1));
  }
}

TEST_F(SlurmJobTest, CallsTheProgramWithItsOwnWords) {
  write("tasks.sbatch", tasks_script(job(3, 100.0)));
  EXPECT_EQ(shell("SLURM_ARRAY_TASK_ID=2 sh tasks.sbatch").exit_code, 0);
  EXPECT_THAT(
      calls(),
      ElementsAre("<data><--jobs><2><block><it's.yaml><--methods><direct,joint><--task><2-2>"));
}

TEST_F(SlurmJobTest, ShortTasksShareAnElementOfAMinute) {
  const std::string script = tasks_script(job(100, 7.0));
  EXPECT_THAT(script, HasSubstr("tasks_per_element=9\n"));
  EXPECT_THAT(script, HasSubstr("--array=1-12\n"));
}

TEST_F(SlurmJobTest, StatesItsThreadsAndItsName) {
  const std::string script = tasks_script(job(3, 100.0));
  EXPECT_THAT(script, HasSubstr("--cpus-per-task=2\n"));
  EXPECT_THAT(script, HasSubstr("--job-name=its_folder_s__HOME__job__50_-tasks\n"));
}

TEST_F(SlurmJobTest, WhatFailsIsTriedTwice) {
  SlurmJob failing = job(1, 100.0);
  failing.words.emplace_back("--fail");
  write("tasks.sbatch", tasks_script(failing));
  write("merge.sbatch", merge_script(failing));
  EXPECT_EQ(shell("SLURM_ARRAY_TASK_ID=1 sh tasks.sbatch").exit_code, 1);
  EXPECT_EQ(calls().size(), 2U);
  EXPECT_EQ(shell("sh merge.sbatch").exit_code, 1);
  EXPECT_EQ(calls().size(), 4U);
}

TEST_F(SlurmJobTest, TheMergeIsSubmittedToFollowAllTasks) {
  write("submit.sh", submit_script(job(3, 100.0)));
  write("sbatch", "#!/bin/sh\necho \"$*\" >>\"$CALLS\"\necho '12;cluster'\n");
  fs::permissions(folder_ / "sbatch", fs::perms::owner_all);
  const auto result = shell("cd / && sh \"$OLDPWD/submit.sh\" --partition=long");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("Job 12 does the tasks, job 12 merges"));
  EXPECT_THAT(calls(), ElementsAre("--parsable --partition=long tasks.sbatch",
                                   "--parsable --partition=long --dependency=afterany:12 "
                                   "merge.sbatch"));
  EXPECT_TRUE(fs::is_directory(folder_ / "logs"));
}

TEST_F(SlurmJobTest, ParallelDoesEveryTaskAndMerges) {
  if (!fs::exists("/usr/bin/parallel")) GTEST_SKIP() << "GNU parallel is not installed";
  write("parallel.sh", parallel_script(job(3, 100.0)));
  const auto result = shell("HOME=$PWD sh parallel.sh -j 1");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const std::string words = "<data><--jobs><2><block><it's.yaml><--methods><direct,joint>";
  EXPECT_THAT(calls(), ElementsAre(words + "<--task><1>", words + "<--task><2>",
                                   words + "<--task><3>", words + "<--merge>"));
}

TEST_F(SlurmJobTest, EveryScriptIsOneOfAShell) {
  for (const std::string& script : {tasks_script(job(3, 1.0)), merge_script(job(3, 1.0)),
                                    submit_script(job(3, 1.0)), parallel_script(job(3, 1.0))}) {
    write("script", script);
    for (const char* const check : {"bash -n script", "dash -n script"}) {
      EXPECT_EQ(shell(check).err, "") << script;
    }
  }
}

TEST_F(SlurmJobTest, SaysHowToStartTheScripts) {
  const std::string text = how_to_submit(job(7, 10.0));
  EXPECT_THAT(text, HasSubstr("7 tasks in an array of 2; the slowest is estimated at 10 s, the "
                              "largest at 1000 MiB with 2 threads; the merge at 30 s and 500 MiB"));
  // three times the 60 s of an element and 10 minutes; 1.5 times 1000 MiB and 256
  EXPECT_THAT(text, HasSubstr("/submit.sh' --time=13 --mem=1756M [--partition="));
  EXPECT_THAT(text, HasSubstr("/parallel.sh' [-S host1,host2]"));
}

TEST_F(SlurmJobTest, RefusesABlockWithoutTasks) {
  EXPECT_THROW(tasks_script(job(0, 1.0)), std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::apps
