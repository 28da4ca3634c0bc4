// SPDX-License-Identifier: BSD-3-Clause
// other_scene FOLDER SEED: a stereo pair with its truth, as the acceptance test renders it.
#include "tests/other_scenes/write_scene.h"

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: other_scene FOLDER SEED\n";
    return EXIT_FAILURE;
  }
  try {
    std::filesystem::create_directories(argv[1]);
    ridgeline::other::write_scene(argv[1], std::stoull(argv[2]));
  } catch (const std::exception& error) {
    std::cerr << "other_scene: " << error.what() << "\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
