// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/command.h"
#include "apps/common/option_flags.h"
#include "apps/common/say.h"
#include "apps/simulate/als.h"
#include "apps/simulate/degrade.h"
#include "apps/simulate/flight.h"
#include "apps/simulate/planned_views.h"
#include "apps/simulate/scene_record.h"
#include "apps/simulate/village.h"
#include "apps/simulate/write_views.h"
#include "io/cloud/las_writer.h"
#include "io/crs/crs.h"
#include "io/lines/write_lines.h"
#include "io/orientation/write_orientation.h"
#include "io/results/output_folder.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>
#include <stdexcept>

namespace ridgeline::apps {
namespace {

struct SimulateArguments {
  std::string out;
  std::uint64_t seed = 1;
  std::vector<double> extent_m{120.0, 120.0};
  std::vector<double> origin_m{513000.0, 5403000.0, 250.0};
  simulate::VillageOptions village;
  simulate::AlsOptions als;
  ViewOptions views;
  std::vector<int> frame_px;  ///< empty: images around the plan
  bool no_images = false;
};

/// Sets the options to the test of Chio and Wang 2000: their flight over houses on every lot, with few trees. The plan
/// is larger than the images.
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
    (void)io::orientation_files(format);
  } catch (const std::invalid_argument& error) {
    throw CLI::ValidationError("--orientation", error.what());
  }
  a.views.orientation = format;
}

/// Whole frames and the files that state their cameras.
void add_frame_options(CLI::App& app, SimulateArguments& a, const char* group) {
  app.add_option("--frame-px", a.frame_px,
                 "columns,rows: whole frames of one camera with the village amid lawn, as tiled "
                 "TIFF; 7680,13824 is the DMC's. Without: images of the plan alone")
      ->delimiter(',')
      ->expected(2)
      ->check(in_range(simulate::kLeastFrame_px, simulate::kMostFrame_px))
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
  add_flags(app, a.views.render, group);
  add_flags(app, a.views.flight, group);
}

void write_lines_of(const results::OutputFolder& out,
                    const std::string& name,
                    const io::LineSet& lines) {
  io::write_lines(out.path(name), lines, io::LineFormat::kGeoJson);
}

/// The patch is named after the folder that it is written to.
std::string name_of_folder(const std::string& folder) {
  const auto path = std::filesystem::weakly_canonical(folder);
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

std::vector<std::string> file_names(const SimulateArguments& a) {
  std::vector<std::string> names{"lidar.las", "lines.good.geojson", "lines.fair.geojson",
                                 "lines.poor.geojson", "truth.geojson"};
  if (a.no_images) return names;
  std::ranges::move(view_file_names(a.views), std::back_inserter(names));
  return names;
}

/// A geometry that sets the sizes of the images has as many views as sizes.
void check_image_sizes(const simulate::FlightOptions& flight) {
  const std::size_t num_views = simulate::planned_views(flight).size();
  check(flight.size_px.empty() || flight.size_px.size() == num_views, "--views has ", num_views,
        " views; must have ", flight.size_px.size(),
        " with --geometry, which sets the size of each image");
  check(flight.size_px.empty() || !flight.frame_px,
        "--frame-px and --geometry, must not both be given: each sets the size of the images");
}

int run_simulate(SimulateArguments a) {
  a.village.seed = a.seed;
  a.als.seed = a.seed;
  a.views.flight.seed = a.seed;
  a.views.render.seed = a.seed;
  a.views.sensor.seed = a.seed;
  a.village.extent_m = {a.extent_m[0], a.extent_m[1]};
  a.village.origin_m = {a.origin_m[0], a.origin_m[1], a.origin_m[2]};
  if (!a.frame_px.empty()) {
    a.views.flight.frame_px = Eigen::Vector2i(a.frame_px[0], a.frame_px[1]);
  }
  check_image_sizes(a.views.flight);
  const io::CrsFacts crs = io::describe({a.village.crs});
  check(!crs.is_geographic, "--crs = ", a.village.crs, " (", crs.name,
        "), its coordinates are degrees; must be a projected one");
  const results::OutputFolder out(a.out, {});
  const std::vector<std::string> names = file_names(a);
  check_scene_files(out, names);
  const simulate::Scene scene = simulate::make_village(a.village);
  if (!a.no_images) (void)simulate::aerial_views(scene, a.views.flight);  // throws before the work
  const io::PointCloud cloud = simulate::scan_als(scene, a.als);

  io::write_las(out.path("lidar.las"), cloud.points, cloud.frame, scene.crs);
  const io::LineSet truth =
      simulate::classed_by_views(simulate::true_lines(scene), simulate::nominal_pair(scene));
  for (const auto& [name, grade] :
       {std::pair("good", simulate::Grade::kGood), std::pair("fair", simulate::Grade::kFair),
        std::pair("poor", simulate::Grade::kPoor)}) {
    write_lines_of(out, fmt::format("lines.{}.geojson", name),
                   simulate::degrade_lines(truth, simulate::options_of(grade, a.seed)));
  }
  write_lines_of(
      out, "truth.geojson",
      a.no_images ? truth : write_views(scene, name_of_folder(a.out), a.views, truth, out));
  record_scene_files(out, names);
  say("{}: {} buildings, {} true lines, {} laser points\n", a.out, scene.buildings.size(),
      truth.lines.size(), cloud.points.size());
  return kDone;
}

}  // namespace

Run add_simulate(CLI::App& subcommand) {
  auto a = std::make_shared<SimulateArguments>();
  subcommand
      .add_option("--out", a->out,
                  "folder for patch.yaml, left.tif, right.tif (more views: ID.tif), matches.csv, "
                  "lidar.las, truth.geojson and lines.{good,fair,poor}.geojson; files there are "
                  "kept unless an earlier scene wrote them")
      ->required();
  subcommand
      .add_option_function<std::string>(
          "--geometry", [a](const std::string&) { set_chio_wang_geometry(*a); },
          "other defaults. chio_wang_2000: pixels of 0.24 m, B/H 0.6, images of 180 x 180 and "
          "225 x 180 pixels, dense housing")
      ->check(CLI::IsMember({"chio_wang_2000"}))
      ->trigger_on_parse();
  subcommand.add_option("--seed", a->seed, "same seed, same bytes")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  add_village_options(subcommand, *a);
  add_scanner_options(subcommand, *a);
  add_image_options(subcommand, *a);
  return [a] { return run_simulate(*a); };
}

}  // namespace ridgeline::apps
