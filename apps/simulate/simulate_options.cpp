// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/option_flags.h"
#include "apps/simulate/simulate_arguments.h"
#include "apps/simulate/write_orientation.h"

#include <stdexcept>

namespace ridgeline::apps {
namespace {

constexpr int kMinTileSide_m = 10;
constexpr int kMaxTileSide_m = 1000;

/// Sets the options to the test of Chio and Wang 2000: their flight, over a village with a house on
/// every lot and few trees. The plan is larger than the images.
void set_chio_wang_geometry(SimulateArguments& a) {
  a.views.flight = simulate::chio_wang_flight();
  a.extent_m = {80.0, 80.0};
  a.village.built_share = 1.0;
  a.village.trees_per_lot = 0.2;
  a.village.fence_share = 0.0;
}

void add_village_options(CLI::App& app, SimulateArguments& a) {
  const char* group = "Village";
  app.add_option("--extent-m", a.extent_m, "of the plan: x,y")
      ->delimiter(',')
      ->expected(2)
      ->capture_default_str()
      ->group(group);
  app.add_option("--origin-m", a.origin_m, "map coordinates of its corner: x,y,z, whole metres")
      ->delimiter(',')
      ->expected(3)
      ->capture_default_str()
      ->group(group);
  app.add_option("--crs", a.village.crs, "of the files")->capture_default_str()->group(group);
  app.add_option("--street-azimuth-deg", a.village.street_azimuth_deg,
                 "of the streets and the rows of houses to x")
      ->capture_default_str()
      ->group(group);
  app.add_option("--aligned-share", a.village.aligned_share,
                 "of the houses whose main ridge is parallel to x, the epipolar direction")
      ->capture_default_str()
      ->group(group);
  app.add_option("--built-share", a.village.built_share, "of the lots that bear a house")
      ->capture_default_str()
      ->group(group);
  app.add_option("--terrain-slope-deg", a.village.terrain_slope_deg, "of the ground, at most 15")
      ->capture_default_str()
      ->group(group);
  app.add_option("--terrace-step-m", a.village.terrace_step_m, "between two rows of lots")
      ->capture_default_str()
      ->group(group);
  app.add_option("--trees-per-lot", a.village.trees_per_lot, "mean number, 0 to 6")
      ->capture_default_str()
      ->group(group);
}

/// Options that make lines harder to judge, off by default.
void add_clutter_options(CLI::App& app, SimulateArguments& a) {
  const char* group = "Clutter";
  app.add_flag_callback(
         "--clutter", [&a] { set_clutter(a.village); },
         "sets the options of this group to those of a suburb: 0.5, 0.6, 1.5, 0.5 and both kinds "
         "of lines")
      ->trigger_on_parse()
      ->group(group);
  app.add_option("--annex-share", a.village.annex_share,
                 "share of the detached houses with a low lean-to or flat annex")
      ->capture_default_str()
      ->group(group);
  app.add_option("--dormer-share", a.village.dormer_share,
                 "share of the plain gabled and hipped houses with small dormers")
      ->capture_default_str()
      ->group(group);
  app.add_option("--cars-per-lot", a.village.cars_per_lot,
                 "mean number of cars at the kerb and in gardens, 0 to 4")
      ->capture_default_str()
      ->group(group);
  app.add_option("--garden-wall-share", a.village.garden_wall_share,
                 "share of the borders between lots with a garden wall, unless they have a fence")
      ->capture_default_str()
      ->group(group);
  app.add_flag("--foot-lines,!--no-foot-lines", a.village.with_feet,
               "true lines where walls meet the ground or a lower roof")
      ->group(group);
  app.add_flag("--object-lines,!--no-object-lines", a.village.with_objects,
               "true lines at the edges of cars and chimneys")
      ->group(group);
}

/// Options for optional truth files.
void add_truth_options(CLI::App& app, SimulateArguments& a) {
  app.add_option("--models", a.models,
                 "writes the true buildings with their roofs, walls and grounds as well: cityjson "
                 "(buildings.city.json), citygml (buildings.gml) or both, cityjson,citygml")
      ->delimiter(',')
      ->check(CLI::IsMember({"cityjson", "citygml"}));
}

void add_scanner_options(CLI::App& app, SimulateArguments& a) {
  const char* group = "Laser scanner";
  app.add_option("--density-per-m2", a.als.density_per_m2, "pulses per m^2, all strips together")
      ->capture_default_str()
      ->group(group);
  app.add_option("--range-sigma-m", a.als.range_sigma_m, "noise along the beam")
      ->capture_default_str()
      ->group(group);
  app.add_option("--cross-sigma-m", a.als.cross_sigma_m, "noise across the beam, per axis")
      ->capture_default_str()
      ->group(group);
  app.add_option("--height-above-ground-m", a.als.height_above_ground_m, "of the flight")
      ->capture_default_str()
      ->group(group);
  app.add_option("--half-scan-angle-deg", a.als.half_scan_angle_deg, "to each side of nadir")
      ->capture_default_str()
      ->group(group);
  app.add_option("--strip-overlap", a.als.strip_overlap, "share of the swath")
      ->capture_default_str()
      ->group(group);
  app.add_option("--strip-azimuth-deg", a.als.strip_azimuth_deg, "of the flight to the x axis")
      ->capture_default_str()
      ->group(group);
  app.add_option("--footprint-m", a.als.footprint_m, "diameter of the beam at the ground")
      ->capture_default_str()
      ->group(group);
  app.add_option("--strip-offset-sigma-m", a.als.strip_offset_sigma_m,
                 "systematic shift of each strip, per axis")
      ->capture_default_str()
      ->group(group);
}

void set_view_groups(SimulateArguments& a, const std::string& text) {
  try {
    a.views.flight.groups = simulate::parse_view_groups(text);
  } catch (const std::invalid_argument& error) {
    throw CLI::ValidationError("--views", error.what());
  }
}

void set_orientation(SimulateArguments& a, const std::string& format) {
  try {
    (void)simulate::orientation_files(format);
  } catch (const std::invalid_argument& error) {
    throw CLI::ValidationError("--orientation", error.what());
  }
  a.views.orientation = format;
}

/// Options for whole frames and orientation files.
void add_frame_options(CLI::App& app, SimulateArguments& a, const char* group) {
  app.add_option("--frame-px", a.frame_px,
                 "columns,rows: whole frames of one camera with the village amid lawn, as tiled "
                 "TIFF; 7680,13824 is the DMC's. Without: images of the plan alone")
      ->delimiter(',')
      ->expected(2)
      ->check(in_range(simulate::kMinFrameSide_px, simulate::kMaxFrameSide_px))
      ->excludes("--no-images")
      ->group(group);
  app.add_option_function<std::string>(
         "--orientation", [&a](const std::string& format) { set_orientation(a, format); },
         "writes the cameras in a format of orientations and not as matrices: opk, opensfm, pix4d, "
         "inpho, pat_b, blocks_exchange, metashape or colmap")
      ->excludes("--no-images")
      ->group(group);
}

void add_image_options(CLI::App& app, SimulateArguments& a) {
  const char* group = "Images";
  app.add_flag("--no-images", a.no_images, "only LIDAR and lines")->group(group);
  add_frame_options(app, a, group);
  app.add_option_function<std::string>(
         "--views", [&a](const std::string& text) { set_view_groups(a, text); },
         "groups of images: strip:N along x, cross:N of a strip along y, oblique:N from all sides; "
         "2 to 30 in all, e.g. strip:3,cross:2")
      ->default_str("strip:2")
      ->group(group);
  app.add_option("--bands", a.views.sensor.bands, "of the images")
      ->check(CLI::IsMember({"rgb", "cir", "rgbn"}))
      ->capture_default_str()
      ->group(group);
  add_flags(app, a.views.sensor, group);
  app.get_option("--bits")->check(CLI::IsMember({8, 16}));
  app.add_flag("--bayer", a.views.sensor.bayer,
               "keeps one colour of each pixel (red green / green blue) and interpolates the "
               "other two")
      ->group(group);
  app.add_option(
         "--degraded-views", a.views.degraded,
         "ids of the views to which --blur-px, --bayer and --jpeg-quality apply; default: all")
      ->delimiter(',')
      ->excludes("--no-images")
      ->group(group);
  add_flags(app, a.views.render, group);
  add_flags(app, a.views.flight, group);
}

void add_block_options(CLI::App& app, SimulateArguments& a) {
  const char* group = "Block";
  app.add_option(
         "--block", a.strips_and_frames,
         "strips,frames: a photogrammetric block in place of a patch, so many strips along x of "
         "so many frames each. Writes block.yaml, frames/, tiles/, an orientation and "
         "truth.geojson. Two frames or more show each place of the village. Other defaults: "
         "--frame-px 2048,1536, the DMC's angle of view, pixels of 8 cm, "
         "--samples-per-side 2, --orientation opk")
      ->delimiter(',')
      ->expected(2)
      ->check(in_range(1, simulate::kMaxStripsOrFrames))
      ->group(group);
  add_flags(app, a.block, group);
  app.add_option("--tile-m", a.tile_m, "side of a tile of the LIDAR, whole metres")
      ->check(in_range(kMinTileSide_m, kMaxTileSide_m))
      ->capture_default_str()
      ->group(group);
}

/// Options that determine the defaults of others.
void add_scene_options(CLI::App& app, SimulateArguments& a) {
  app.add_option("--out", a.out,
                 "folder for patch.yaml, left.tif, right.tif (more views: ID.tif), matches.csv, "
                 "lidar.las, truth.geojson and lines.{good,fair,poor}.geojson, or for a block; "
                 "files there are kept unless an earlier scene wrote them")
      ->required();
  app.add_option_function<std::string>(
         "--geometry", [&a](const std::string&) { set_chio_wang_geometry(a); },
         "other defaults. chio_wang_2000: pixels of 0.24 m, B/H 0.6, images of 180 x 180 and "
         "225 x 180 pixels, dense housing")
      ->check(CLI::IsMember({"chio_wang_2000"}))
      ->trigger_on_parse();
  app.add_option("--seed", a.seed, "same seed, same bytes")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
}

}  // namespace

void add_simulate_options(CLI::App& app, SimulateArguments& a) {
  add_scene_options(app, a);
  add_truth_options(app, a);
  add_village_options(app, a);
  add_clutter_options(app, a);
  add_scanner_options(app, a);
  add_image_options(app, a);
  add_block_options(app, a);
}

}  // namespace ridgeline::apps
