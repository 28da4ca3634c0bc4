// SPDX-License-Identifier: BSD-3-Clause
// The block of make_fixtures.py, which shares nothing with the program, and what its cameras see.
#pragma once

#include "io/orientation/orientation.h"
#include "tests/support/paths.h"

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace ridgeline::io::fixture {

inline std::string path_of(const std::string& name) {
  return test::source_dir() + "/tests/io/orientation/fixtures/" + name;
}

inline const std::vector<std::string>& names() {
  static const std::vector<std::string> names{"a b_1.tif", "H\xC3\xB6he 2.tif", "3.tif",
                                              "strip 4.tif"};
  return names;
}

constexpr BrownDistortion kDistortion{-0.061, 0.023, -0.004, 0.0011, -0.0007};

struct Observation {
  std::size_t point = 0;
  std::size_t image = 0;  ///< number in names()
  Eigen::Vector3d x_in_world;
  Eigen::Vector2d x_px;
};

inline std::vector<Observation> observations(const std::string& file = "observations.csv") {
  std::ifstream stream(path_of(file));
  std::string row;
  std::getline(stream, row);
  std::vector<Observation> found;
  while (std::getline(stream, row)) {
    std::vector<std::string> fields;
    std::istringstream words(row);
    for (std::string word; std::getline(words, word, ',');) fields.push_back(word);
    const auto number = [&](std::size_t i) { return std::stod(fields.at(i)); };
    Observation observation{static_cast<std::size_t>(number(0)),
                            0,
                            {number(2), number(3), number(4)},
                            {number(5), number(6)}};
    while (names().at(observation.image) != fields.at(1)) ++observation.image;
    found.push_back(observation);
  }
  if (found.size() < 100) throw std::runtime_error("the fixture lacks observations");
  return found;
}

/// The pixel of an image at which a point is seen, lens included.
inline Eigen::Vector2d seen_px(const Orientation& orientation,
                               const OrientedImage& image,
                               const Eigen::Vector3d& x_in_world) {
  const InteriorOrientation& interior = orientation.cameras.at(image.camera.value()).interior;
  ExteriorOrientation local = image.exterior;
  local.position_m -= x_in_world;  // keeps all digits
  return distorted_px(interior,
                      project(projection_matrix(interior, local), Eigen::Vector3d::Zero()));
}

/// The largest distance of an observation from where the orientation sees its point. Images are in
/// the order of names().
inline double worst_px(const Orientation& orientation,
                       const std::vector<Observation>& observations) {
  double worst = 0.0;
  for (const Observation& one : observations) {
    const OrientedImage& image = orientation.images.at(one.image);
    worst = std::max(worst, (seen_px(orientation, image, one.x_in_world) - one.x_px).norm());
  }
  return worst;
}

}  // namespace ridgeline::io::fixture
