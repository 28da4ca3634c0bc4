// SPDX-License-Identifier: BSD-3-Clause
#include "tests/mutated/base_files.h"
#include "tests/mutated/mutate.h"
#include "tests/support/paths.h"
#include "tests/support/run_program.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace ridgeline {
namespace {

namespace fs = std::filesystem;
using test::BaseFile;
using test::ProgramResult;

/// Of one command. The sanitizers make a run some ten times slower.
constexpr unsigned kProcessorLimit_s = test::kIsSanitized ? 100 : 10;
/// For files that are all far below 10 MB.
constexpr double kMaxMemory_mib = test::kIsSanitized ? 4096.0 : 512.0;
/// How many files ctest mutates. Longer runs: RIDGELINE_MUTATIONS=FIRST,COUNT.
constexpr std::size_t kMutations = 150;

struct Range {
  std::size_t first = 0, count = kMutations;
};

Range range_of_mutations() {
  const char* const text = std::getenv("RIDGELINE_MUTATIONS");
  Range range;
  if (text == nullptr) return range;
  char* rest = nullptr;
  range.first = std::strtoul(text, &rest, 10);
  if (*rest != ',') throw std::runtime_error("RIDGELINE_MUTATIONS must be FIRST,COUNT");
  range.count = std::strtoul(rest + 1, nullptr, 10);
  return range;
}

std::string content_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void write_content(const fs::path& file, const std::string& content) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << content;
}

/// A simulated scene, its results, and a small file of every format; made once.
class MutatedFiles : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    std::string pattern = (fs::temp_directory_path() / "ridgeline-mutated-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = pattern;
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"simulate", "--out", ".", "--seed", "5", "--extent-m", "40,40",
                                   "--samples-per-side", "1"},
          {"simulate", "--out", "town", "--seed", "3", "--extent-m", "60,60", "--no-images",
           "--models", "cityjson,citygml"},
          {"run", "patch.yaml", "--out", "results", "--methods", "direct,lines"}}) {
      const ProgramResult made = test::run_program(test::program(), command, folder_);
      if (made.exit_code != 0) throw std::runtime_error(made.err);
    }
    std::string patch;
    for (const auto& entry : fs::directory_iterator(folder_ / "results")) {
      if (entry.is_directory()) patch = entry.path().filename().string();
    }
    files_ = test::write_base_files(folder_, patch);
  }
  static void TearDownTestSuite() { fs::remove_all(folder_); }

  static ProgramResult run(std::vector<std::string> command, const std::string& file) {
    for (std::string& word : command) {
      if (word == "FILE") word = file;
      if (word.starts_with("OUT")) word = "out" + word.substr(3);
    }
    return test::run_program(test::program(), command, folder_, {}, kProcessorLimit_s);
  }

  static void remove_outputs() {
    for (const auto& entry : fs::directory_iterator(folder_)) {
      if (entry.path().stem() == "out") fs::remove_all(entry.path());
    }
  }

  static inline fs::path folder_;
  static inline std::vector<BaseFile> files_;
};

/// What a command may do with a file that anybody may have damaged.
testing::AssertionResult is_in_order(const ProgramResult& result) {
  const auto fault = [&](const std::string& what) {
    return testing::AssertionFailure() << what << "; stderr: " << result.err.substr(0, 500);
  };
  if (result.exit_code == 128 + SIGALRM) return fault("waited for too long");
  if (result.exit_code == 128 + SIGXCPU) return fault("took more processor time than the limit");
  if (result.exit_code > 128) return fault(fmt::format("signal {}", result.exit_code - 128));
  if (result.exit_code == 2) return fault("internal error");
  if (result.peak_memory_mib > kMaxMemory_mib) {
    return fault(fmt::format("took {:.0f} MiB", result.peak_memory_mib));
  }
  if (result.exit_code != 1) return testing::AssertionSuccess();
  const std::size_t last_line = result.err.find_last_of('\n', result.err.size() - 2) + 1;
  if (result.err.substr(last_line).starts_with("ridgeline: ")) return testing::AssertionSuccess();
  return fault("an error without a message");
}

TEST_F(MutatedFiles, UnharmedOnesAreRead) {
  for (const BaseFile& file : files_) {
    const ProgramResult result = run(file.commands.front(), file.name);
    EXPECT_TRUE(is_in_order(result));
    const int refused = file.name.starts_with("seed_") ? 1 : 0;
    EXPECT_THAT(result.exit_code, testing::AnyOf(0, 3, refused)) << file.name << ": " << result.err;
    remove_outputs();
  }
}

TEST_F(MutatedFiles, EndInAnAnswerOrAClearError) {
  const Range range = range_of_mutations();
  for (std::size_t number = range.first; number < range.first + range.count; ++number) {
    test::Random random(number);
    const BaseFile& file = files_[number % files_.size()];
    const std::string unharmed = content_of(folder_ / file.name);
    write_content(folder_ / file.name, test::mutated(unharmed, random));
    const auto& command = file.commands[random.bits() % file.commands.size()];
    const ProgramResult result = run(command, file.name);
    EXPECT_TRUE(is_in_order(result))
        << "mutation " << number << " of " << file.name << ", ridgeline "
        << fmt::format("{}", fmt::join(command, " "));
    write_content(folder_ / file.name, unharmed);
    remove_outputs();
  }
}

}  // namespace
}  // namespace ridgeline
