// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/simulate_arguments.h"
#include "reconstruct/geometry/check.h"

#include <algorithm>
#include <array>

namespace ridgeline::apps {
namespace {

struct RefusedOption {
  const char* flag;
  const char* reason;
};
constexpr std::array kNotWithABlock{
    RefusedOption{"--extent-m", "the village is what two frames or more show"},
    RefusedOption{"--geometry", "it states a pair"},
    RefusedOption{"--no-images", "a block is made of its frames"},
    RefusedOption{"--views", "the views of a block are its frames"},
    RefusedOption{"--base-to-height", "--forward-overlap decides it"},
    RefusedOption{"--oblique-tilt-deg", "all frames are vertical"},
};
constexpr std::array kOnlyWithABlock{"--cross-strips", "--forward-overlap", "--side-overlap",
                                     "--tile-m"};

void check_options(const CLI::App& app, bool is_block) {
  for (const RefusedOption& refused : kNotWithABlock) {
    check(!is_block || app.count(refused.flag) == 0, "--block and ", refused.flag,
          ", must not both be given: ", refused.reason);
  }
  for (const char* flag : kOnlyWithABlock) {
    check(is_block || app.count(flag) == 0, flag, ", must be with --block");
  }
}

/// Uses the angle of view and ground pixel of the DMC, whatever the frame size. From less than
/// about ten house heights, a frame would show far less of the roofs than of the ground.
void set_camera(const CLI::App& app, simulate::FlightOptions& flight) {
  constexpr double kFocalPerColumn = 10000.0 / 7680.0;
  constexpr double kPixel_m = 0.08;
  constexpr double kMinHeight_m = 200.0;
  if (app.count("--focal-length-px") == 0) {
    flight.focal_length_px = kFocalPerColumn * flight.frame_px->x();
  }
  if (app.count("--camera-height-m") == 0) {
    flight.height_above_ground_m = std::max(kMinHeight_m, kPixel_m * flight.focal_length_px);
  }
}

}  // namespace

void set_block(const CLI::App& app, SimulateArguments& a) {
  const bool is_block = !a.strips_and_frames.empty();
  check_options(app, is_block);
  if (!is_block) return;
  a.block.num_strips = a.strips_and_frames[0];
  a.block.num_frames = a.strips_and_frames[1];
  if (!a.views.flight.frame_px) a.views.flight.frame_px = Eigen::Vector2i(2048, 1536);
  if (a.views.orientation.empty()) a.views.orientation = "opk";
  // a block has many times the pixels of a pair; four rays per pixel take half the time of nine
  if (app.count("--samples-per-side") == 0) a.views.render.samples_per_side = 2;
  set_camera(app, a.views.flight);
  a.village.extent_m =
      simulate::block_extent_m(a.block, a.views.flight, a.village.terrain_slope_deg);
}

}  // namespace ridgeline::apps
