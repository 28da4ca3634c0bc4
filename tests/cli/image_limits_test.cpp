// SPDX-License-Identifier: BSD-3-Clause
// Small files that decode to gigabytes, and what is no file at all.
#include "tests/cli/cli_fixture.h"

#include <opencv2/imgcodecs.hpp>
#include <sys/stat.h>

namespace ridgeline::cli {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

// Limits for the start of the program and the reading of a header, since nothing is decoded.
constexpr double kMaxImageTime_s = test::kIsSanitized ? 30.0 : 3.0;
constexpr double kMaxImageMemory_mib = test::kIsSanitized ? 2048.0 : 256.0;

class ImageLimits : public Cli {
 protected:
  /// Expects that `extract` refuses the file before it decodes anything.
  void expect_refused_at_once(const std::string& file, const std::string& why) const {
    const ProgramResult result = run({"extract", file, "--out", "segments.csv"});
    EXPECT_REFUSED(result, AllOf(HasSubstr(file), HasSubstr(why)));
    EXPECT_LT(result.processor_s, kMaxImageTime_s) << file;
    EXPECT_LT(result.peak_memory_mib, kMaxImageMemory_mib) << file;
  }

  void write_flat(const std::string& name, int side_px) const {
    fs::create_directories(path(name).parent_path());
    ASSERT_TRUE(cv::imwrite(path(name).string(), cv::Mat(side_px, side_px, CV_8UC1, cv::Scalar(9)),
                            {cv::IMWRITE_PNG_COMPRESSION, 9}));
  }
};

TEST_F(ImageLimits, FlatPngOf400MegapixelsIsRefused) {
  write_flat("flat.png", 20000);
  ASSERT_LT(fs::file_size(path("flat.png")), 10000000U);
  expect_refused_at_once("flat.png", "20000 x 20000 pixels are 400 million");
  expect_refused_at_once("flat.png", "--max-image-mpx 400");
}

TEST_F(ImageLimits, SparseTiffIsRefused) {
  for (const char* name : {"sparse_8000.tif", "sparse_16000.tif"}) {
    const fs::path file = shared_data("hostile") / name;
    if (!fs::exists(file)) GTEST_SKIP() << file << " is absent";
    expect_refused_at_once(file.string(), "--max-image-mpx");
  }
}

TEST_F(ImageLimits, OptionAllowsMoreAndLess) {
  write_flat("flat.png", 3000);
  EXPECT_REFUSED(run({"extract", "flat.png", "--out", "s.csv"}), HasSubstr("9 million"));
  EXPECT_EQ(run({"extract", "flat.png", "--out", "s.csv", "--max-image-mpx", "9"}).exit_code, 0);
  EXPECT_REFUSED(run({"extract", "flat.png", "--out", "s2.csv", "--max-image-mpx", "8"}),
                 HasSubstr("the limit is 8 million"));
  EXPECT_REFUSED(run({"extract", "flat.png", "--out", "s2.csv", "--max-image-mpx", "-1"}),
                 HasSubstr("--max-image-mpx"));
}

TEST_F(ImageLimits, EveryCommandThatTakesAPairHasThem) {
  write_flat("left.png", 3000);
  write_flat("right.png", 3000);
  write(path("patch.yaml"),
        "id: flat\nheight_range: [0, 50]\nimages:\n"
        "  - {id: left, path: left.png, projection_matrix: "
        "[[10000, 0, -100, 80000], [0, -10000, -100, 80000], [0, 0, -1, 800]]}\n"
        "  - {id: right, path: right.png, projection_matrix: "
        "[[10000, 0, -100, 70000], [0, -10000, -100, 80000], [0, 0, -1, 800]]}\n");
  const auto refusal = AllOf(HasSubstr("left.png: 3000 x 3000"), HasSubstr("--max-image-mpx 9"));
  EXPECT_REFUSED(run({"run", "patch.yaml", "--out", "out"}), refusal);
  EXPECT_REFUSED(run({"match", "patch.yaml", "--out", "m.csv"}), refusal);
  EXPECT_REFUSED(run({"reconstruct", "patch.yaml", "--out", "l.csv"}), refusal);
  EXPECT_EQ(run({"info", "left.png"}).exit_code, 0);
  EXPECT_EQ(run({"match", "patch.yaml", "--out", "m.csv", "--max-image-mpx", "9"}).exit_code, 0);
}

TEST_F(ImageLimits, DevicesPipesAndFoldersAreNoImages) {
  ASSERT_EQ(mkfifo(path("pipe.png").c_str(), 0600), 0);
  expect_refused_at_once("pipe.png", "pipe");
  expect_refused_at_once("/dev/zero", "device");
  expect_refused_at_once("/dev/random", "device");
  expect_refused_at_once("scene", "folder");
  EXPECT_REFUSED(run({"info", "pipe.png"}), HasSubstr("pipe"));
}

TEST_F(ImageLimits, NothingIsWrittenBesideAnImageAndErrorsAreShort) {
  write_flat("a/flat.png", 100);
  fs::create_directories(path("b"));
  cv::Mat noise(300, 300, CV_8UC3);
  cv::RNG(1).fill(noise, cv::RNG::UNIFORM, 0, 255);
  ASSERT_TRUE(cv::imwrite(path("b/noise.tif").string(), noise));
  std::string bytes = read(path("b/noise.tif"));
  for (std::size_t i = 2000; i + 5000 < bytes.size(); ++i) bytes[i] = '\x55';
  write(path("b/noise.tif"), bytes);
  EXPECT_EQ(run({"info", "a/flat.png"}).exit_code, 0);
  (void)run({"extract", "a/flat.png", "--out", "s.csv"});
  EXPECT_EQ(names_in(path("a")), std::vector<std::string>{"flat.png"});
  const ProgramResult damaged = run({"extract", "b/noise.tif", "--out", "s2.csv"});
  EXPECT_REFUSED(damaged, HasSubstr("cannot be decoded"));
  EXPECT_LT(damaged.err.size(), 300U);
  EXPECT_EQ(names_in(path("b")), std::vector<std::string>{"noise.tif"});
}

}  // namespace
}  // namespace ridgeline::cli
