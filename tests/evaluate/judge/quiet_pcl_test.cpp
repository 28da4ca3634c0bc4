// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/quiet_pcl.h"

#include "evaluate/judge/line_to_plane_evaluation.h"
#include "evaluate/judge/plane_search.h"
#include "tests/evaluate/judge/pcl_searches.h"

#include <gtest/gtest.h>
#include <pcl/console/print.h>

#include <functional>

namespace ridgeline::evaluate {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using pcl::console::getVerbosityLevel;

/// What a step prints to stderr while PCL prints whatever it can.
std::string printed_by(const std::function<void()>& step) {
  const auto before = getVerbosityLevel();
  pcl::console::setVerbosityLevel(pcl::console::L_VERBOSE);
  ::testing::internal::CaptureStderr();
  step();
  const std::string text = ::testing::internal::GetCapturedStderr();
  EXPECT_EQ(getVerbosityLevel(), pcl::console::L_VERBOSE);
  pcl::console::setVerbosityLevel(before);
  return text;
}

/// Points of one straight line, of which no three span a plane.
Cloud::Ptr straight_cloud() {
  auto cloud = std::make_shared<Cloud>();
  for (int i = 0; i < 60; ++i) cloud->emplace_back(0.25F * static_cast<float>(i), 0.5F, 3.0F);
  return cloud;
}

TEST(QuietPcl, HoldsUntilTheLastOfSeveralIsGone) {
  const auto before = getVerbosityLevel();
  {
    const QuietPcl outer;
    { const QuietPcl inner; }
    EXPECT_EQ(getVerbosityLevel(), pcl::console::L_ALWAYS);
  }
  EXPECT_EQ(getVerbosityLevel(), before);
}

TEST(QuietPcl, HoldsForTheSearchOfPlanes) {
  std::vector<ZonePoint> points;
  const Cloud::Ptr cloud = straight_cloud();
  for (const pcl::PointXYZ& p : *cloud) {
    const auto index = static_cast<std::uint32_t>(points.size());
    points.push_back({p.getVector3fMap().cast<double>(), p.x, p.y, index});
  }
  for (const SampleConsensus method :
       {SampleConsensus::kMsac, SampleConsensus::kRansac, SampleConsensus::kProsac}) {
    JudgeOptions options;
    options.method = method;
    EXPECT_EQ(printed_by([&] { EXPECT_TRUE(search_planes(points, options).empty()); }), "");
  }
}

TEST(QuietPcl, HoldsForALineAmongPointsWithoutAPlane) {
  JudgedLine line;
  line.segment = {{0.0, 0.0, 3.0}, {15.0, 0.0, 3.0}};
  for (const auto& search : test::pcl_searches()) {
    LineToPlaneEvaluation<pcl::PointXYZ> evaluation;
    evaluation.setInputCloud(straight_cloud());
    evaluation.setSearchMethod(search);
    evaluation.setInputLines({line});
    EXPECT_EQ(printed_by([&] { EXPECT_EQ(evaluation.compute()[0].status, Status::kNoPlane); }), "")
        << search->getName();
  }
}

TEST(QuietPcl, HoldsWithoutACloud) {
  LineToPlaneEvaluation<pcl::PointXYZ> evaluation;
  EXPECT_EQ(printed_by([&] { EXPECT_THROW(evaluation.compute(), std::invalid_argument); }), "");
}

}  // namespace
}  // namespace ridgeline::evaluate
