// SPDX-License-Identifier: BSD-3-Clause
// A scene with its truth, as the acceptance test renders it.
#include "tests/other_scenes/write_scene.h"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>

int main(int argc, char** argv) {
  std::string folder;
  std::uint64_t seed = 0;
  std::string views = "strip:2";
  std::string hard;
  ridgeline::other::Degradation degradation;
  CLI::App app("Writes a scene of the second renderer");
  app.add_option("FOLDER", folder)->required();
  app.add_option("SEED", seed)->required();
  app.add_option("VIEWS", views, "strip:N, or strip:N,cross:M with M views at right angles")
      ->capture_default_str();
  app.add_option("hard", hard, "steeper ground, annexes, small dormers, and laser points")
      ->check(CLI::IsMember({"hard"}));
  app.add_option("--blur-px", degradation.blur_px, "blurs the images before their noise arises");
  app.add_flag("--bayer", degradation.bayer, "one colour per pixel, the others interpolated");
  app.add_option("--jpeg-quality", degradation.jpeg_quality, "1 to 100; 0: no compression");
  app.add_option("--degraded-views", degradation.views, "ids; default: all")->delimiter(',');
  CLI11_PARSE(app, argc, argv);
  try {
    const auto plan = ridgeline::other::flight_plan(views);
    std::filesystem::create_directories(folder);
    ridgeline::other::write_scene(folder, seed, plan, !hard.empty(), degradation);
  } catch (const std::exception& error) {
    std::cerr << "other_scene: " << error.what() << "\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
