// SPDX-License-Identifier: BSD-3-Clause
// A block of lines gives the bytes of one `ridgeline evaluate`, whatever happens to its tasks.
#include "apps/block/lines_block.h"

#include "io/files/folder_lock.h"
#include "tests/support/cut_cloud.h"
#include "tests/support/paths.h"
#include "tests/support/run_program.h"
#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace ridgeline::apps {
namespace {

namespace fs = std::filesystem;
using test::ProgramResult;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string steps_program() {
  return (fs::read_symlink("/proc/self/exe").parent_path() / "lines_block_steps").string();
}

/// A simulated town: its cloud in tiles, its true lines, those of a tool, and odd ones. The program
/// makes it once.
class Town {
 public:
  Town() {
    const ProgramResult made = test::run_program(
        test::program(),
        {"simulate", "--out", "town", "--seed", "3", "--extent-m", "90,90", "--no-images"},
        folder_.file(""));
    EXPECT_EQ(made.exit_code, 0) << made.err;
    test::cut_cloud(folder_.file("town/lidar.las"), folder_.file("town/tiles"), 37.0);
    (void)folder_.write("town/odd.csv",
                        "id,x1,y1,z1,x2,y2,z2\n"
                        "a,513030,5403030,251,513035,5403032,251\n"
                        "a,513060,5403060,251,513065,5403062,251\n"
                        "b,nan,5403030,251,513035,5403032,251\n"
                        "c,513030,5403030,-9999,513035,5403032,-9999\n"
                        "d,513010,5403010,251,513010,5403010,251\n"
                        "e,519010,5403010,251,519020,5403010,251\n");
  }
  [[nodiscard]] std::string folder() const { return folder_.file("town"); }

 private:
  io::TempFolder folder_;
};

class LinesBlock : public testing::Test {
 protected:
  LinesBlock() {
    static const Town town;
    fs::copy(town.folder(), folder_.file("town"), fs::copy_options::recursive);
    write_block("");
  }

  void write_block(const std::string& more) const {
    (void)folder_.write("BLOCK.yaml",
                        "lines: [town/truth.geojson, town/lines.fair.geojson, town/odd.csv]\n"
                        "lidar: town/tiles/*.las\nreference_lines: town/truth.geojson\n" +
                            (more.empty() ? "patch_size_m: 30\n" : more));
  }

  [[nodiscard]] ProgramResult step(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "BLOCK.yaml");
    return test::run_program(steps_program(), arguments, folder_.file(""));
  }
  void expect_step(const std::vector<std::string>& arguments) const {
    const ProgramResult result = step(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.out << result.err;
  }

  /// Makes the plan, and returns the number of tasks.
  [[nodiscard]] int plan(const std::string& out) const {
    const ProgramResult result = step({out, "plan"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return static_cast<int>(std::ranges::count(result.out, '\n'));
  }
  void task(const std::string& out, int i) const { expect_step({out, "task", std::to_string(i)}); }
  void merge(const std::string& out) const { expect_step({out, "merge"}); }
  void all_steps(const std::string& out) const {
    const int n_tasks = plan(out);
    for (int i = 0; i < n_tasks; ++i) task(out, i);
    merge(out);
  }

  void evaluate(const std::string& out, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"evaluate",
                                       "--lines",
                                       "town/truth.geojson",
                                       "town/lines.fair.geojson",
                                       "town/odd.csv",
                                       "--cloud",
                                       "town/tiles/*.las",
                                       "--reference-lines",
                                       "town/truth.geojson",
                                       "--decoys",
                                       "0",
                                       "--out",
                                       out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProgramResult result = test::run_program(test::program(), arguments, folder_.file(""));
    ASSERT_EQ(result.exit_code, 0) << result.err;
  }

  /// All results but the run's record, by name; the plan and the tasks of a block are none.
  [[nodiscard]] std::map<std::string, std::string> results_in(const std::string& out) const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::directory_iterator(folder_.file(out))) {
      const std::string name = entry.path().filename().string();
      if (!entry.is_regular_file() || name == "run.json" || name == "plan.json") continue;
      files[name] = folder_.read(out + "/" + name);
    }
    return files;
  }
  void expect_same_bytes(const std::string& a, const std::string& b) const {
    const auto files_a = results_in(a);
    const auto files_b = results_in(b);
    EXPECT_GT(files_a.size(), 25U);
    for (const auto& [name, content] : files_a) {
      const auto other = files_b.find(name);
      EXPECT_TRUE(other != files_b.end() && other->second == content) << name;
    }
    EXPECT_EQ(files_a.size(), files_b.size());
  }

  void change(const std::string& file, const std::string& more) const {
    (void)folder_.write(file, folder_.read(file) + more);
  }

  io::TempFolder folder_;
};

TEST_F(LinesBlock, GivesTheBytesOfOneEvaluateForCellsOfAnySize) {
  if (test::kIsSanitized) GTEST_SKIP() << "takes long, and other tests run the same code";
  evaluate("one");
  int n_most = 0;
  for (const char* size_m : {"18.5", "5000"}) {
    write_block(std::string("patch_size_m: ") + size_m + "\n");
    const std::string out = std::string("block") + size_m;
    n_most = std::max(n_most, plan(out));
    all_steps(out);
    expect_same_bytes("one", out);
  }
  EXPECT_GT(n_most, 20);
  EXPECT_EQ(plan("block5000"), 2);  // a line lies 6 km from the others
}

TEST_F(LinesBlock, GivesTheBytesOfOneEvaluateWithTheOptionsOfItsFile) {
  evaluate("one", {"--assume-crs", "EPSG:3857", "--scale-to-ground", "--classes", "2,5,6",
                   "--last-returns", "--include-withheld", "--bounds",
                   "513005,5403000,513085,5403090", "--origin", "513100,5403100,200"});
  write_block(
      "patch_size_m: 30\ncrs: EPSG:3857\nscale_to_ground: true\nclasses: [2, 5, 6]\n"
      "last_returns: true\nexclude_withheld: false\n"
      "bounds: [513005, 5403000, 513085, 5403090]\norigin: [513100, 5403100, 200]\n");
  all_steps("block");
  expect_same_bytes("one", "block");
}

TEST_F(LinesBlock, RecordsTheInputsOfOneEvaluate) {
  if (test::kIsSanitized) GTEST_SKIP() << "takes long, and other tests run the same code";
  evaluate("one");
  all_steps("block");
  const auto one = nlohmann::json::parse(folder_.read("one/run.json"));
  const auto block = nlohmann::json::parse(folder_.read("block/run.json"));
  for (const char* key : {"command", "options", "inputs", "warnings", "messages", "page"}) {
    EXPECT_EQ(block[key], one[key]) << key;
  }
  EXPECT_EQ(block["cloud"]["n_files_unread"], one["cloud"]["n_files_unread"]);
}

TEST_F(LinesBlock, TasksInAnyOrderAndInTwoProcessesGiveTheSameBytes) {
  evaluate("one");
  const int n_tasks = plan("block");
  ASSERT_GT(n_tasks, 4);
  const auto every_second = [&](int last) {
    for (int i = last; i >= 0; i -= 2) task("block", i);
  };
  std::thread other([&] { every_second(n_tasks - 2); });
  every_second(n_tasks - 1);
  other.join();
  merge("block");
  expect_same_bytes("one", "block");
}

TEST_F(LinesBlock, TheSameTaskInTwoProcessesGivesTheSameBytes) {
  const int n_tasks = plan("block");
  std::thread other([&] { task("block", 0); });
  task("block", 0);
  other.join();
  const std::string bytes = folder_.read("block/tasks/0000.judged");
  ASSERT_EQ(plan("again"), n_tasks);
  task("again", 0);
  EXPECT_TRUE(folder_.read("again/tasks/0000.judged") == bytes);
}

TEST_F(LinesBlock, SurvivesTasksThatAreKilled) {
  evaluate("one");
  const int n_tasks = plan("block");
  for (int i = 0; i < n_tasks; ++i) {
    const std::string folder = folder_.file(""), program = steps_program();
    const std::string number = std::to_string(i);
    const pid_t child = fork();
    if (child == 0) {  // which takes no memory: another thread may hold its lock
      if (chdir(folder.c_str()) == 0) {
        execl(program.c_str(), "lines_block_steps", "BLOCK.yaml", "block", "task", number.c_str(),
              nullptr);
      }
      _exit(127);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10 * i));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
  }
  (void)folder_.write("block/tasks/0001.judged", "half of");
  (void)folder_.write("block/tasks/.0002.999999.0.tmp.judged", "left by a dead process");
  for (int i = 0; i < n_tasks; ++i) task("block", i);
  const std::string third = folder_.read("block/tasks/0003.judged");
  (void)folder_.write("block/tasks/0003.judged", third.substr(0, third.size() - 1));
  EXPECT_EQ(step({"block", "merge"}).exit_code, 1);
  task("block", 3);
  merge("block");
  expect_same_bytes("one", "block");
}

TEST_F(LinesBlock, LeavesATaskThatIsDoneAlone) {
  ASSERT_GT(plan("block"), 1);
  task("block", 1);
  const fs::path file = folder_.file("block/tasks/0001.judged");
  const auto long_ago = fs::last_write_time(file) - std::chrono::hours(1);
  fs::last_write_time(file, long_ago);
  task("block", 1);
  EXPECT_EQ(fs::last_write_time(file), long_ago);
}

TEST_F(LinesBlock, KeepsThePlanOfTheSameInputsAndRefusesThatOfOthers) {
  const int n_tasks = plan("block");
  const std::string text = folder_.read("block/plan.json");
  EXPECT_EQ(plan("block"), n_tasks);
  EXPECT_EQ(folder_.read("block/plan.json"), text);
  write_block("patch_size_m: 40\n");
  const ProgramResult other = step({"block", "plan"});
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_THAT(other.err, AllOf(HasSubstr("block/plan.json"), HasSubstr("use another folder")));
  EXPECT_EQ(folder_.read("block/plan.json"), text);
}

TEST_F(LinesBlock, RefusesInputsAndOptionsThatHaveChangedSinceThePlan) {
  (void)plan("block");
  const auto expect_refused = [&](const std::string& what) {
    for (const auto& last : {std::vector<std::string>{"task", "0"}, {"merge"}}) {
      std::vector<std::string> arguments{"block"};
      arguments.insert(arguments.end(), last.begin(), last.end());
      const ProgramResult result = step(arguments);
      EXPECT_EQ(result.exit_code, 1);
      EXPECT_THAT(result.err, HasSubstr(what)) << last[0];
    }
  };
  const std::string lines = folder_.read("town/odd.csv");
  change("town/odd.csv", "f,513030,5403030,251,513035,5403032,252\n");
  expect_refused("town/odd.csv: has changed since the plan was made");
  (void)folder_.write("town/odd.csv", lines);  // at another time: the content decides
  expect_step({"block", "task", "0"});

  const std::string tile = fs::directory_iterator(folder_.file("town/tiles"))->path().string();
  const auto time = fs::last_write_time(tile);
  fs::last_write_time(tile, time + std::chrono::seconds(5));
  expect_refused(fs::path(tile).filename().string() + ": has changed since the plan was made");
  fs::last_write_time(tile, time);
  fs::copy(tile, folder_.file("town/tiles/9_9.las"));
  expect_refused("town/tiles/9_9.las: is no input of the plan");
  fs::remove(folder_.file("town/tiles/9_9.las"));
  const std::string block = folder_.read("BLOCK.yaml");
  change("BLOCK.yaml", "last_returns: true\n");
  expect_refused("the block file: has changed since the plan was made");
  (void)folder_.write("BLOCK.yaml", block);
  EXPECT_THAT(step({"block", "task", "0", "0.05"}).err,
              HasSubstr("option judge/lidar_sigma_m: is 0.05, in the plan 0.034"));
  expect_step({"block", "task", "0"});
}

TEST_F(LinesBlock, WritesNoResultsWhileTasksHaveNone) {
  const int n_tasks = plan("block");
  for (int i = 0; i < n_tasks; ++i) {
    if (i != 2) task("block", i);
  }
  const ProgramResult result = step({"block", "merge"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.out + result.err,
              AllOf(HasSubstr("task 3, x 5"), HasSubstr("has no results")));
  EXPECT_TRUE(results_in("block").empty());
}

TEST_F(LinesBlock, NeedsItsPlan) {
  EXPECT_THAT(step({"block", "task", "0"}).err, HasSubstr("make the plan of the block first"));
  ASSERT_GT(plan("block"), 1);
  EXPECT_THAT(step({"block", "task", "4000"}).err, HasSubstr("must be below their number"));
  (void)folder_.write("block/tasks/0001.lines", "damaged");
  EXPECT_THAT(step({"block", "task", "1"}).err,
              AllOf(HasSubstr("0001.lines"), HasSubstr("make the plan again")));
  (void)folder_.write("block/plan.json", "{}");
  EXPECT_THAT(step({"block", "task", "0"}).err, HasSubstr("is no plan of a block of lines"));
}

TEST_F(LinesBlock, RefusesASecondMergeAtTheSameTime) {
  const int n_tasks = plan("block");
  for (int i = 0; i < n_tasks; ++i) task("block", i);
  {
    const auto lock = io::FolderLock::of(folder_.file("block"));
    EXPECT_EQ(step({"block", "merge"}).exit_code, 1);
    EXPECT_EQ(results_in("block").count("table2.md"), 0U);
    expect_step({"block", "task", "0"});  // tasks need no lock
  }
  merge("block");
}

TEST_F(LinesBlock, RefusesLinesElsewhereAsEvaluateDoes) {
  (void)folder_.write("town/odd.csv", "x1,y1,z1,x2,y2,z2\n1,2,3,4,5,6\n10,20,3,14,25,6\n");
  (void)folder_.write("BLOCK.yaml", "lines: town/odd.csv\nlidar: town/tiles/*.las\n");
  const ProgramResult one = test::run_program(
      test::program(),
      {"evaluate", "--lines", "town/odd.csv", "--cloud", "town/tiles/*.las", "--out", "one"},
      folder_.file(""));
  EXPECT_EQ(one.exit_code, 1);
  ASSERT_EQ(plan("block"), 1);
  task("block", 0);
  const ProgramResult block = step({"block", "merge"});
  EXPECT_EQ(block.exit_code, 1);
  EXPECT_EQ("ridgeline: " + block.err, one.err);
}

TEST_F(LinesBlock, IsCalledInTheTablesWhatItsFileSays) {
  write_block("block: suburb\npatch_size_m: 1000\n");
  all_steps("block");
  EXPECT_THAT(folder_.read("block/table2.md"), HasSubstr("| suburb |"));
  EXPECT_THAT(folder_.read("block/table2.md"), Not(HasSubstr("| tiles |")));
}

TEST_F(LinesBlock, RefusesToApplyTheShift) {
  LinesBlockOptions options;
  options.shift.apply = true;
  try {
    make_lines_block(folder_.file("BLOCK.yaml"), folder_.file("block"), options);
    ADD_FAILURE() << "is not refused";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("--apply-shift"));
  }
}

}  // namespace
}  // namespace ridgeline::apps
