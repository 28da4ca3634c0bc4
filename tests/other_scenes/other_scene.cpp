// SPDX-License-Identifier: BSD-3-Clause
// other_scene FOLDER SEED [VIEWS [hard]]: a scene with its truth, as the acceptance test renders it.
// VIEWS: strip:N for N views along a strip (strip:2, a stereo pair, if nothing is said), or
// strip:N,cross:M with M more along a strip at right angles. hard: on steeper ground, with annexes,
// small dormers and laser points.
#include "tests/other_scenes/write_scene.h"

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>

int main(int argc, char** argv) {
  const bool is_hard = argc == 5 && std::string(argv[4]) == "hard";
  if (argc < 3 || argc > 5 || (argc == 5 && !is_hard)) {
    std::cerr << "usage: other_scene FOLDER SEED [strip:N[,cross:M] [hard]]\n";
    return EXIT_FAILURE;
  }
  try {
    const auto plan = ridgeline::other::flight_plan(argc >= 4 ? argv[3] : "strip:2");
    std::filesystem::create_directories(argv[1]);
    ridgeline::other::write_scene(argv[1], std::stoull(argv[2]), plan, is_hard);
  } catch (const std::exception& error) {
    std::cerr << "other_scene: " << error.what() << "\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
