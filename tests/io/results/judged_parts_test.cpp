// SPDX-License-Identifier: BSD-3-Clause
// Lines that are judged in parts get the results of lines that are judged together.
#include "io/results/judged_parts.h"

#include "io/results/part_files.h"
#include "io/results/prepare_lines.h"
#include "tests/support/paths.h"

#include <gmock/gmock.h>

#include <string>
#include <vector>

namespace ridgeline::results {
namespace {

constexpr std::uint64_t kMemory_bytes = 512ULL << 20U;

/// Two files of lines of the sample. Some ids are there twice, in different thirds.
class SampleLines {
 public:
  SampleLines() : cloud_({sample() + "lidar.las"}, {}) {
    JudgeFilesOptions options;
    options.line_paths = {sample() + "lines.fair.geojson", sample() + "truth.geojson"};
    lines_ = prepare_lines(read_lines_to_judge(options), cloud_, options).lines;
    for (auto& set : lines_) {
      for (std::size_t i = 5; i < set.size(); i += 10) set[i].id = set[i - 4].id;
    }
  }

  [[nodiscard]] const LineSets& lines() const { return lines_; }
  [[nodiscard]] io::CloudFiles& cloud() { return cloud_; }

  /// Each third line, from `first` on.
  [[nodiscard]] LineNumbers third(std::size_t first) const {
    LineNumbers numbers(lines_.size());
    for (std::size_t set = 0; set < lines_.size(); ++set) {
      for (std::size_t i = first; i < lines_[set].size(); i += 3) numbers[set].push_back(i);
    }
    return numbers;
  }

 private:
  static std::string sample() { return test::source_dir() + "/sample_data/1/"; }

  io::CloudFiles cloud_;
  LineSets lines_;
};

/// The results without what the number of readings decides.
std::string bytes_of_results(const JudgedBatches& judged) {
  return to_bytes(JudgedBatches{.results = judged.results, .readings = {}, .decoys = {}});
}

TEST(JudgedParts, GiveTheBytesOfLinesThatAreJudgedTogether) {
  SampleLines sample;
  const evaluate::JudgeOptions options;
  const JudgedBatches together =
      judge_in_batches(sample.cloud(), sample.lines(), options, kMemory_bytes);
  JudgedParts parts(sample.lines());
  for (const std::size_t first : {2U, 0U, 1U}) {
    const LineNumbers numbers = sample.third(first);
    parts.add(numbers, judge_part(sample.cloud(), lines_of(sample.lines(), numbers), options,
                                  kMemory_bytes));
  }
  const JudgedBatches joined = parts.join(sample.cloud(), options, kMemory_bytes);
  EXPECT_EQ(joined.readings.n_batches, 3U);
  EXPECT_EQ(bytes_of_results(joined), bytes_of_results(together));
  const auto is_duplicate = [](const evaluate::JudgedResult& result) {
    return result.evaluation.status == evaluate::Status::kDuplicateId;
  };
  EXPECT_GT(std::ranges::count_if(joined.results[0], is_duplicate), 5);
}

TEST(JudgedParts, WithoutAnyPointAreJudgedTogether) {
  SampleLines sample;
  const evaluate::JudgeOptions options;
  JudgedParts parts(sample.lines());  // no part has found a point
  const JudgedBatches joined = parts.join(sample.cloud(), options, kMemory_bytes);
  EXPECT_EQ(bytes_of_results(joined), bytes_of_results(judge_in_batches(
                                          sample.cloud(), sample.lines(), options, kMemory_bytes)));
}

TEST(CloudReadings, AddUpAndKeepEachWarningOnce) {
  CloudReadings sum;
  CloudReadings a{.n_batches = 1, .n_kept = 10, .cloud = {}, .read_places = {1, 4}};
  a.cloud.n_read = 100;
  a.cloud.warnings = {"one", "two"};
  CloudReadings b{.n_batches = 2, .n_kept = 5, .cloud = {}, .read_places = {0, 4}};
  b.cloud.n_read = 50;
  b.cloud.warnings = {"two", "three"};
  add(a, sum);
  add(b, sum);
  EXPECT_EQ(sum.n_batches, 3U);
  EXPECT_EQ(sum.n_kept, 15U);
  EXPECT_EQ(sum.cloud.n_read, 150U);
  EXPECT_THAT(sum.cloud.warnings, testing::ElementsAre("one", "two", "three"));
  EXPECT_THAT(sum.read_places, testing::ElementsAre(0, 1, 4));
}

TEST(CloudFiles, CountFilesAsReadThatAnotherProcessHasRead) {
  const std::string sample = test::source_dir() + "/sample_data/";
  io::CloudFiles cloud({sample + "1/lidar.las", sample + "2/lidar.las"}, {});
  EXPECT_TRUE(cloud.read_places().empty());
  cloud.count_as_read({1});
  EXPECT_THAT(cloud.unread_paths(), testing::ElementsAre(sample + "1/lidar.las"));
  EXPECT_THAT(cloud.read_places(), testing::ElementsAre(1));
  EXPECT_THROW(cloud.count_as_read({2}), std::invalid_argument);
}

TEST(CloudFiles, SortWarningsByFile) {
  const std::string sample = test::source_dir() + "/sample_data/";
  const io::CloudFiles cloud({sample + "2/lidar.las", sample + "1/lidar.las"}, {});
  std::vector<std::string> warnings{"line 3: near", sample + "1/lidar.las: c",
                                    sample + "2/lidar.las: b", sample + "1/lidar.las: a: x"};
  cloud.sort_warnings(warnings);
  EXPECT_THAT(warnings, testing::ElementsAre(sample + "2/lidar.las: b", sample + "1/lidar.las: c",
                                             sample + "1/lidar.las: a: x", "line 3: near"));
}

}  // namespace
}  // namespace ridgeline::results
