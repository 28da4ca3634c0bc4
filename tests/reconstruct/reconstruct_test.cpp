// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/reconstruct.h"

#include "apps/simulate/aerial_pair.h"
#include "apps/simulate/render.h"
#include "apps/simulate/sensor.h"
#include "apps/simulate/truth.h"
#include "reconstruct/geometry/interruption.h"
#include "tests/support/scene.h"

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace ridgeline::reconstruct {
namespace {

using ::testing::HasSubstr;

constexpr std::array<double, 2> kHeights_m{-5.0, 20.0};

/// A house with a gable, seen from both sides of the flight.
class TwoViews : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    scene_ = new simulate::Scene(test::gabled_house(35.0, 20.0));
    views_ = new std::vector<View>;
    const auto cameras = simulate::aerial_pair(*scene_, {});
    const simulate::Renderer renderer(*scene_, {});
    for (std::size_t i = 0; i < cameras.size(); ++i) {
      views_->push_back({i == 0 ? "left" : "right",
                         simulate::expose(renderer.radiance(cameras[i]), {}, i),
                         cameras[i].image_from_world,
                         {}});
    }
  }
  static void TearDownTestSuite() {
    delete scene_;
    delete views_;
  }

  static std::vector<View> views() { return *views_; }
  static std::array<double, 2> heights_m() {
    const double ground_m = scene_->frame.origin_m.z();
    return {ground_m + kHeights_m[0], ground_m + kHeights_m[1]};
  }

  /// Largest distance of the ends of the true line from the nearest of the lines, extended.
  static double distance_m(const Segment3& truth, const Reconstruction& found) {
    double nearest_m = std::numeric_limits<double>::infinity();
    for (const ReconstructedLine& line : found.pairs.at(0).lines) {
      if (!line.segment_in_local) continue;
      const auto through = Eigen::ParametrizedLine<double, 3>::Through(
          found.frame.world_from_local(line.segment_in_local->start),
          found.frame.world_from_local(line.segment_in_local->end));
      nearest_m =
          std::min(nearest_m, std::max(through.distance(truth.start), through.distance(truth.end)));
    }
    return nearest_m;
  }

  static simulate::Scene* scene_;
  static std::vector<View>* views_;
};
simulate::Scene* TwoViews::scene_ = nullptr;
std::vector<View>* TwoViews::views_ = nullptr;

std::vector<double> coordinates(const PairReconstruction& pair) {
  std::vector<double> all;
  for (const ReconstructedLine& line : pair.lines) {
    if (!line.segment_in_local) continue;
    for (const Eigen::Vector3d& x : {line.segment_in_local->start, line.segment_in_local->end}) {
      all.insert(all.end(), x.begin(), x.end());
    }
  }
  return all;
}

TEST_F(TwoViews, GiveTheRidgeAndTheEavesOfAHouse) {
  const Reconstruction found = reconstruct(views(), heights_m());
  ASSERT_EQ(found.segments.size(), 2U);
  ASSERT_EQ(found.pairs.size(), 1U);
  constexpr double kTolerance_m = 0.15;  // half a pixel of disparity in height
  int n_roof = 0;
  for (const io::Line& truth : simulate::true_lines(*scene_).lines) {
    if (truth.kind != "ridge" && truth.kind != "eave") continue;
    ++n_roof;
    EXPECT_LT(distance_m(truth.segment_in_world, found), kTolerance_m) << truth.kind << truth.id;
  }
  EXPECT_EQ(n_roof, 3);
}

TEST_F(TwoViews, GiveWhatTheStagesGiveOneByOne) {
  const Reconstruction found = reconstruct(views(), heights_m());
  StereoPair pair;
  const double origin_m = found.frame.origin_m.z();
  pair.height_range_in_local_m = {heights_m()[0] - origin_m, heights_m()[1] - origin_m};
  for (std::size_t v = 0; v < 2; ++v) {
    const cv::Mat image = normalised(views()[v]);
    pair.views[v] = {image_from_local(views()[v].image_from_world, found.frame.origin_m), image,
                     extract(image)};
  }
  const std::optional<Surface> surface = surface_of(pair);
  Matches matches = match(pair, {}, surface);
  guide(pair, matches, {}, surface);
  EXPECT_EQ(matches.used().matches.size(), found.pairs[0].matches.used().matches.size());
  EXPECT_EQ(coordinates({{}, {}, estimate(pair, line_matches(matches.used()), {}, {}, surface)}),
            coordinates(found.pairs[0]));
  for (std::size_t v = 0; v < 2; ++v) {
    EXPECT_EQ(pair.views[v].segments.size(),
              found.segments[v].size() + found.pairs[0].guided[v].size());
  }
}

TEST_F(TwoViews, OfMoreAreTheFirstTwoUnlessPairsAreNamed) {
  std::vector<View> three = views();
  three.push_back(three[0]);
  three[2].id = "again";
  const auto two = coordinates(reconstruct(views(), heights_m()).pairs[0]);
  const Reconstruction first = reconstruct(three, heights_m());
  ASSERT_EQ(first.pairs.size(), 1U);
  EXPECT_EQ(first.segments.size(), 3U);
  EXPECT_EQ(coordinates(first.pairs[0]), two);
  const std::vector<ViewPair> named{{2, 1}, {0, 1}};
  const Reconstruction both = reconstruct(three, heights_m(), {}, named);
  ASSERT_EQ(both.pairs.size(), 2U);
  EXPECT_EQ(coordinates(both.pairs[0]), two);
  EXPECT_EQ(coordinates(both.pairs[1]), two);
}

TEST_F(TwoViews, MayBeNormalisedAlready) {
  std::vector<View> normal = views();
  for (View& view : normal) view.image = normalised(view);
  EXPECT_EQ(coordinates(reconstruct(normal, heights_m()).pairs[0]),
            coordinates(reconstruct(views(), heights_m()).pairs[0]));
}

TEST_F(TwoViews, AreTheFewestAndPairsAreOfThem) {
  EXPECT_THROW((void)reconstruct(std::vector<View>{views()[0]}, heights_m()),
               std::invalid_argument);
  for (const ViewPair wrong : {ViewPair{0, 0}, ViewPair{0, 2}}) {
    EXPECT_THROW((void)reconstruct(views(), heights_m(), {}, std::vector<ViewPair>{wrong}),
                 std::invalid_argument);
  }
  Options options;
  options.matching.candidates.min_overlap = 2.0;
  EXPECT_THROW((void)reconstruct(views(), heights_m(), options), std::invalid_argument);
  options = {};
  options.matching.matchers.clear();
  EXPECT_THROW((void)reconstruct(views(), heights_m(), options), std::invalid_argument);
}

TEST_F(TwoViews, AreRefusedByNameIfTheyCannotBeAPair) {
  const auto message_of = [&](const std::vector<View>& views, std::array<double, 2> range_m,
                              const Options& options = {}) -> std::string {
    try {
      (void)reconstruct(views, range_m, options);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(message_of(views(), {10.0, 0.0}), HasSubstr("height_range_m = 10 to 0"));
  EXPECT_THAT(message_of(views(), {NAN, 0.0}), HasSubstr("height_range_m = nan"));
  std::vector<View> wrong = views();
  cv::merge(std::vector{wrong[1].image, wrong[1].image}, wrong[1].image);
  EXPECT_THAT(message_of(wrong, heights_m()), HasSubstr("view " + wrong[1].id + ": bands = "));
  wrong = views();
  wrong[0].image_from_world.col(0) = wrong[0].image_from_world.col(1);
  EXPECT_THAT(message_of(wrong, heights_m()), HasSubstr("view " + wrong[0].id + ": the matrix"));
  Options no_surface;
  no_surface.estimation.lines.method = Method::kPlanes;
  no_surface.estimation.beyond.surface = false;
  no_surface.matching.beyond.surface = no_surface.matching.beyond.guided = false;
  EXPECT_THAT(message_of(views(), heights_m(), no_surface), HasSubstr("there is no surface"));
}

TEST_F(TwoViews, AreLeftWhenInterrupted) {
  Interruption::request();
  EXPECT_THROW((void)reconstruct(views(), heights_m()), Interrupted);
  Interruption::clear();
  EXPECT_FALSE(reconstruct(views(), heights_m()).pairs[0].lines.empty());
}

}  // namespace
}  // namespace ridgeline::reconstruct
