// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/reconstruct.h"

#include "apps/simulate/flight.h"
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

using ::testing::DoubleNear;
using ::testing::HasSubstr;
using ::testing::Pointwise;

constexpr std::array<double, 2> kHeights_m{-5.0, 20.0};

/// A house with a gable, seen from both sides of the flight.
class TwoViews : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    scene_ = new simulate::SyntheticScene(test::gabled_house(35.0, 20.0));
    const double ground_m = scene_->frame.origin_m.z();
    oriented_ = new Scene{{}, {ground_m + kHeights_m[0], ground_m + kHeights_m[1]}};
    const auto cameras = simulate::aerial_views(*scene_, {});
    const simulate::Renderer renderer(*scene_, {});
    for (std::size_t i = 0; i < cameras.size(); ++i) {
      oriented_->views.push_back({i == 0 ? "left" : "right", cameras[i].image_from_world,
                                  simulate::expose(renderer.radiance(cameras[i]), {}, i)});
    }
  }
  static void TearDownTestSuite() {
    delete scene_;
    delete oriented_;
  }

  static Scene oriented() { return *oriented_; }

  /// Largest distance of the ends of the true line from the nearest of the lines, extended.
  static double distance_m(const Segment3& truth, const Reconstruction& found) {
    double nearest_m = std::numeric_limits<double>::infinity();
    for (const ReconstructedLine& line : found.lines) {
      if (!line.segment_in_local) continue;
      const auto through = Eigen::ParametrizedLine<double, 3>::Through(
          found.scene.frame.world_from_local(line.segment_in_local->start),
          found.scene.frame.world_from_local(line.segment_in_local->end));
      nearest_m =
          std::min(nearest_m, std::max(through.distance(truth.start), through.distance(truth.end)));
    }
    return nearest_m;
  }

  static simulate::SyntheticScene* scene_;
  static Scene* oriented_;
};
simulate::SyntheticScene* TwoViews::scene_ = nullptr;
Scene* TwoViews::oriented_ = nullptr;

std::vector<double> coordinates(std::span<const ReconstructedLine> lines) {
  std::vector<double> all;
  for (const ReconstructedLine& line : lines) {
    if (!line.segment_in_local) continue;
    for (const Eigen::Vector3d& x : {line.segment_in_local->start, line.segment_in_local->end}) {
      all.insert(all.end(), x.begin(), x.end());
    }
  }
  return all;
}

TEST_F(TwoViews, GiveTheRidgeAndTheEavesOfAHouse) {
  const Reconstruction found = reconstruct(oriented());
  ASSERT_EQ(found.scene.views.size(), 2U);
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
  const Reconstruction found = reconstruct(oriented());
  Scene scene = in_local_frame(oriented());
  extract(scene.views);
  std::vector<PairMatches> pairs{match(scene, {0, 1})};
  add_guided(scene, pairs);
  for (std::size_t v = 0; v < 2; ++v)
    EXPECT_EQ(scene.views[v].segments.size(), found.scene.views[v].segments.size());
  EXPECT_EQ(pairs[0].list.matches.size(), found.pairs[0].list.matches.size());
  const std::vector<Track> tracks = tracks_of(scene, pairs);
  EXPECT_EQ(tracks.size(), pairs[0].list.matches.size());
  EXPECT_EQ(coordinates(estimate(scene, tracks, used_pairs(pairs))), coordinates(found.lines));
}

TEST_F(TwoViews, GiveTheSameFromAnyFrame) {
  constexpr double kRounding_m = 1e-6;  // of cameras that are moved by kilometres and back
  const Eigen::Vector3d origin_m(1000.0, -2000.0, 300.0);
  Scene moved = oriented();
  moved.frame.origin_m = origin_m;
  for (View& view : moved.views)
    view.image_from_local = image_from_local(view.image_from_local, origin_m);
  for (double& height_m : moved.height_range_in_local_m) height_m -= origin_m.z();
  const Reconstruction found = reconstruct(moved);
  const Reconstruction expected = reconstruct(oriented());
  EXPECT_EQ(found.scene.frame.origin_m, expected.scene.frame.origin_m);
  EXPECT_THAT(coordinates(found.lines),
              Pointwise(DoubleNear(kRounding_m), coordinates(expected.lines)));
}

TEST_F(TwoViews, OfMoreAreThoseOfThePairThatIsNamed) {
  Scene three = oriented();
  three.views.insert(three.views.begin() + 1, three.views[0]);
  three.views[1].id = "again";
  const auto two = coordinates(reconstruct(oriented()).lines);
  for (const ViewPair& named : {ViewPair{0, 2}, ViewPair{1, 2}}) {
    const Reconstruction found = reconstruct(three, {}, {&named, 1});
    ASSERT_EQ(found.pairs.size(), 1U);
    EXPECT_EQ(found.scene.views.size(), 3U);
    EXPECT_EQ(coordinates(found.lines), two);
  }
}

TEST_F(TwoViews, MayBeNormalisedAlready) {
  Scene normal = oriented();
  for (View& view : normal.views) view.image = normalised(view);
  EXPECT_EQ(coordinates(reconstruct(normal).lines), coordinates(reconstruct(oriented()).lines));
}

TEST_F(TwoViews, AreTheFewestAndPairsAreOfThem) {
  Scene one = oriented();
  one.views.pop_back();
  EXPECT_THROW((void)reconstruct(one), std::invalid_argument);
  for (const ViewPair wrong : {ViewPair{0, 0}, ViewPair{0, 2}}) {
    EXPECT_THROW((void)reconstruct(oriented(), {}, std::vector<ViewPair>{wrong}),
                 std::invalid_argument);
  }
  Options options;
  options.matching.candidates.max_slope_deg = 90.0;
  EXPECT_THROW((void)reconstruct(oriented(), options), std::invalid_argument);
  options = {};
  options.matching.beyond_chio.min_similarity = 2.0;
  EXPECT_THROW((void)reconstruct(oriented(), options), std::invalid_argument);
}

TEST_F(TwoViews, AreRefusedByNameIfTheyCannotBeAPair) {
  const auto message_of = [&](const Scene& scene, const Options& options = {}) -> std::string {
    try {
      (void)reconstruct(scene, options);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  Scene wrong = oriented();
  wrong.height_range_in_local_m = {10.0, 0.0};
  EXPECT_THAT(message_of(wrong), HasSubstr("height_range_m = 10 to 0"));
  wrong.height_range_in_local_m = {NAN, 0.0};
  EXPECT_THAT(message_of(wrong), HasSubstr("height_range_m = nan"));
  wrong = oriented();
  cv::merge(std::vector{wrong.views[1].image, wrong.views[1].image}, wrong.views[1].image);
  EXPECT_THAT(message_of(wrong), HasSubstr("view " + wrong.views[1].id + ": bands = "));
  wrong = oriented();
  wrong.views[0].image_from_local.col(0) = wrong.views[0].image_from_local.col(1);
  EXPECT_THAT(message_of(wrong),
              HasSubstr("view " + wrong.views[0].id + ": its projection matrix"));
  Options no_surface;
  no_surface.estimation.lines.method = Method::kPlanes;
  no_surface.estimation.beyond.surface = false;
  no_surface.matching.beyond.surface = no_surface.matching.beyond.guided = false;
  EXPECT_THAT(message_of(oriented(), no_surface), HasSubstr("there is no surface"));
}

TEST_F(TwoViews, LinesAreThoseOfTheNetworkAndOfPlanesWhereItHasNone) {
  Options options;
  options.extraction.edges.min_length_px = 300.0;  // longer than any edge of the house
  options.extraction.beyond.faint_edges = options.matching.beyond.guided = false;
  options.estimation.lines.method = Method::kNetwork;
  const std::vector<ReconstructedLine> network = reconstruct(oriented(), options).lines;
  options.estimation.lines.method = Method::kLines;
  std::vector<ReconstructedLine> lines = reconstruct(oriented(), options).lines;
  ASSERT_GT(lines.size(), network.size());
  for (std::size_t i = network.size(); i < lines.size(); ++i)
    EXPECT_STREQ(status_name(lines[i]), "planes");
  lines.resize(network.size());
  EXPECT_EQ(coordinates(lines), coordinates(network));
}

TEST_F(TwoViews, AreLeftWhenInterrupted) {
  Interruption::request();
  EXPECT_THROW((void)reconstruct(oriented()), Interrupted);
  Interruption::clear();
  EXPECT_FALSE(reconstruct(oriented()).lines.empty());
}

}  // namespace
}  // namespace ridgeline::reconstruct
