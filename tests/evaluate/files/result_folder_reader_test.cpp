// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/result_folder_reader.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace ridgeline::results {
namespace {

std::optional<bool> by_options(const std::string& options) {
  return joint_adjusts_to_faces(evaluate::Json::parse(R"({"options": )" + options + "}"));
}

TEST(JointAdjustsToFaces, WithTheExtensionAndTheSurfaceThatItNeeds) {
  EXPECT_EQ(by_options(R"({"reconstruct": {"surface": true, "faces_beside": true}})"), true);
  EXPECT_EQ(by_options(R"({"reconstruct": {"surface": true, "faces_beside": false}})"), false);
  EXPECT_EQ(by_options(R"({"reconstruct": {"surface": false, "faces_beside": true}})"), false);
}

TEST(JointAdjustsToFaces, IsUnknownWhereTheRecordDoesNotSayIt) {
  EXPECT_EQ(joint_adjusts_to_faces(evaluate::Json::object()), std::nullopt);
  for (const char* options : {"3", "{}", R"({"reconstruct": {"max_aligned_angle_deg": 10.0}})",
                              R"({"reconstruct": {"faces_beside": "yes"}})"}) {
    EXPECT_EQ(by_options(options), std::nullopt) << options;
  }
}

}  // namespace
}  // namespace ridgeline::results
