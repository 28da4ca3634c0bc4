// SPDX-License-Identifier: BSD-3-Clause
// What holds on the villages of `ridgeline simulate` holds on scenes made by other means as well:
// other houses, textures, shadows and rays, and a truth found another way (tests/other_scenes).
// Nothing is calibrated on seeds from 101 on; keep it so.
//
// The limits keep what is reached, less a few matches (measured: correctness 97.7 %, completeness
// 96.2 %, quality 94.1 %; 76 % of the roof lines by `joint`, 77 % by `network`; not_aligned lines
// to 0.110 m, aligned ones to 0.37 m with 2.0 % of gross errors). False matches are mostly edges of
// roofs with the foot of a wall that one image alone shows, both verges of a gable that lie on one
// epipolar line, and both sides of fences; gross errors are half-hipped ends and garden walls along
// the base.
#include "io/project/matches_file.h"
#include "tests/other_scenes/edge_profile.h"
#include "tests/other_scenes/write_scene.h"
#include "tests/support/csv_rows.h"
#include "tests/support/paths.h"
#include "tests/support/run_program.h"

#include <gmock/gmock.h>
#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace ridgeline {
namespace {

namespace fs = std::filesystem;
using SceneRow = test::CsvRow;

constexpr std::uint64_t kFirstSeed = 101;
constexpr std::uint64_t kScenes = 6;  ///< the streets of even seeds run along the base

const std::array<std::string, 5> kRoofKinds{"eave", "hip", "ridge", "valley", "verge"};

bool is_roof_line(const std::string& kind) {
  return std::find(kRoofKinds.begin(), kRoofKinds.end(), kind) != kRoofKinds.end();
}

double value(const SceneRow& row, const std::string& column) {
  const std::string& text = row.at(column);
  return text.empty() ? 0.0 : std::stod(text);
}

/// True errors over all scenes, of one method and class.
struct PooledErrors {
  double n = 0.0, sum_squares_m2 = 0.0, n_gross = 0.0;
  void add(const SceneRow& row) {
    const double count = value(row, "n_on_reference");
    n += count;
    sum_squares_m2 += count * value(row, "rms_m") * value(row, "rms_m");
    n_gross += count * value(row, "gross_share");
  }
  [[nodiscard]] double rms_m() const { return n > 0.0 ? std::sqrt(sum_squares_m2 / n) : 0.0; }
  [[nodiscard]] double gross_share() const { return n > 0.0 ? n_gross / n : 0.0; }
};

class OtherScenes : public testing::Test {
 protected:
  OtherScenes() {
    std::string pattern = (fs::temp_directory_path() / "ridgeline-other-XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
  }
  ~OtherScenes() override { fs::remove_all(folder_); }

  [[nodiscard]] fs::path make_scene(std::uint64_t seed,
                                    const std::string& name,
                                    const other::Degradation& degradation) const {
    const fs::path scene = folder_ / name;
    fs::create_directories(scene);
    other::write_scene(scene.string(), seed, {}, false, degradation);
    return scene;
  }
  [[nodiscard]] fs::path make_scene(std::uint64_t seed) const {
    return make_scene(seed, std::to_string(seed), {});
  }

  void run_all() const {
    std::vector<std::string> arguments{"run",         "--out",     "out",
                                       "--no-report", "--methods", "direct,joint,network"};
    for (std::uint64_t seed = kFirstSeed; seed < kFirstSeed + kScenes; ++seed) {
      arguments.push_back((make_scene(seed) / "patch.yaml").string());
    }
    const test::ProgramResult result = test::run_program(test::program(), arguments, folder_);
    ASSERT_EQ(result.exit_code, 0) << result.err;
  }

  [[nodiscard]] std::vector<SceneRow> results(const std::string& name) const {
    return test::read_csv(folder_ / "out" / name);
  }

  void check_matches() const {
    double n_correct = 0.0, n_false = 0.0, n_missed = 0.0;
    for (const SceneRow& row : results("table1.csv")) {
      n_correct += value(row, "correct");
      n_false += value(row, "false");
      n_missed += value(row, "missed");
    }
    const double correctness = n_correct / (n_correct + n_false);
    const double completeness = n_correct / (n_correct + n_missed);
    const double quality = n_correct / (n_correct + n_false + n_missed);
    std::cout << "matches: correct " << n_correct << ", false " << n_false << ", missed "
              << n_missed << "; correctness " << correctness << ", completeness " << completeness
              << ", quality " << quality << "\n";
    EXPECT_GE(correctness, 0.974);
    EXPECT_GE(completeness, 0.958);
    EXPECT_GE(quality, 0.936);
  }

  void check_true_errors() const {
    std::map<std::string, PooledErrors> errors;
    for (const SceneRow& row : results("reference_errors.csv")) {
      errors[row.at("method") + " " + row.at("class")].add(row);
    }
    for (const auto& [key, pooled] : errors) {
      std::cout << key << ": against true lines " << pooled.rms_m() << " m (" << pooled.n
                << " lines, " << 100.0 * pooled.gross_share() << " % gross)\n";
    }
    EXPECT_LE(errors["joint not_aligned"].rms_m(), 0.112);
    EXPECT_LE(errors["joint not_aligned"].gross_share(), 0.002);
    EXPECT_LE(errors["joint aligned"].rms_m(), 0.40);
    EXPECT_LE(errors["joint aligned"].gross_share(), 0.023);
    EXPECT_LE(errors["network not_aligned"].rms_m(), errors["joint not_aligned"].rms_m());
    EXPECT_LE(errors["network aligned"].rms_m(), 1.02 * errors["joint aligned"].rms_m());
  }

  void check_roof_lines() const {
    for (const char* method : {"joint", "network"}) {
      double n_true = 0.0, n_found = 0.0;
      for (const SceneRow& row : results("reference_completeness.csv")) {
        if (row.at("method") != method || !is_roof_line(row.at("kind"))) continue;
        n_true += value(row, "n_reference_lines");
        n_found += value(row, "n_reconstructed");
      }
      std::cout << method << ": roof lines reconstructed: " << n_found << " of " << n_true << "\n";
      EXPECT_GE(n_found / n_true, 0.775);
    }
  }

  fs::path folder_;
};

TEST_F(OtherScenes, AreReconstructedAsWellAsSimulatedVillages) {
  run_all();
  check_matches();
  check_true_errors();
  check_roof_lines();
}

/// The truth is one that the pixels know nothing of: rays and projections. It holds if the images
/// change where it says that they do. Where they change more beside an edge of a roof, there is a
/// gutter, the border of a shadow or the foot of a wall.
TEST_F(OtherScenes, ChangeWhereTheirTrueEdgesAre) {
  constexpr double kReach_px = 2.5, kNear_px = 0.5, kMinContrast_grey = 6.0;
  const fs::path scene = make_scene(kFirstSeed);
  const auto edges = std::get<std::vector<ReferenceEdge>>(
      io::read_reference_matches((scene / "matches.csv").string()));
  const std::array<cv::Mat, 2> images{cv::imread((scene / "left.tif").string()),
                                      cv::imread((scene / "right.tif").string())};
  double n = 0.0, n_near = 0.0;
  for (const ReferenceEdge& edge : edges) {
    if (!is_roof_line(edge.kind)) continue;
    for (std::size_t i = 0; i < 2; ++i) {
      const Segment2& segment = i == 0 ? edge.base : edge.other;
      const auto profile = other::edge_profile(images[i], segment, kReach_px);
      if (!profile || profile->contrast_grey < kMinContrast_grey) continue;
      n += 1.0;
      if (std::abs(profile->offset_px) <= kNear_px) n_near += 1.0;
    }
  }
  std::cout << "roof edges of both images where the images change most: " << n_near << " of " << n
            << "\n";
  EXPECT_GE(n, 200.0);
  EXPECT_GE(n_near / n, 0.85);
}

/// Mean squared difference of neighbouring pixels, which a blur lowers.
double sharpness(const fs::path& file) {
  const cv::Mat image = cv::imread(file.string());
  const cv::Rect left(0, 0, image.cols - 1, image.rows);
  const double norm = cv::norm(image(left), image(left + cv::Point(1, 0)));
  return norm * norm / static_cast<double>(left.area());
}

TEST_F(OtherScenes, DegradeTheChosenImagesAlone) {
  const fs::path plain = make_scene(kFirstSeed);
  const fs::path soft = make_scene(
      kFirstSeed, "soft", {.blur_px = 2.0, .bayer = true, .jpeg_quality = 80, .views = {"right"}});
  const auto difference = [&](const char* image) {
    return cv::norm(cv::imread((plain / image).string()), cv::imread((soft / image).string()));
  };
  EXPECT_EQ(difference("left.tif"), 0.0);
  EXPECT_LT(sharpness(soft / "right.tif"), 0.5 * sharpness(plain / "right.tif"));
  EXPECT_THROW((void)make_scene(kFirstSeed, "wrong", {.blur_px = 1.0, .views = {"strip1"}}),
               std::invalid_argument);
  EXPECT_THROW((void)make_scene(kFirstSeed, "wrong", {.jpeg_quality = 101}), std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline
