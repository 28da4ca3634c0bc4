// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/command.h"
#include "apps/common/say.h"
#include "apps/simulate/als.h"
#include "apps/simulate/block_truth.h"
#include "apps/simulate/degrade.h"
#include "apps/simulate/flight.h"
#include "apps/simulate/planned_views.h"
#include "apps/simulate/simulate_arguments.h"
#include "apps/simulate/village.h"
#include "apps/simulate/write_block.h"
#include "apps/simulate/write_views.h"
#include "evaluate/files/output_folder.h"
#include "io/cloud/las_writer.h"
#include "io/crs/crs.h"
#include "io/lines/write_lines.h"
#include "io/models/write_model.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace ridgeline::apps {
namespace {

constexpr std::array kLineFiles{"lines.good.geojson", "lines.fair.geojson", "lines.poor.geojson",
                                "truth.geojson"};

struct ModelFile {
  const char* option;  ///< value of --models
  const char* name;
  io::ModelFormat format;
};
constexpr std::array kModelFiles{
    ModelFile{"cityjson", "buildings.city.json", io::ModelFormat::kCityJson},
    ModelFile{"citygml", "buildings.gml", io::ModelFormat::kCityGml}};

/// The model files requested by the options, without duplicates.
std::vector<ModelFile> model_files(const SimulateArguments& a) {
  std::vector<ModelFile> files;
  std::ranges::copy_if(kModelFiles, std::back_inserter(files), [&](const ModelFile& file) {
    return std::ranges::find(a.models, file.option) != a.models.end();
  });
  return files;
}

void write_models(const simulate::SyntheticScene& scene,
                  const SimulateArguments& a,
                  const results::OutputFolder& out) {
  if (a.models.empty()) return;
  const io::BuildingModel model = simulate::true_model(scene);
  for (const ModelFile& file : model_files(a)) {
    io::write_model(out.path(file.name), model, file.format);
  }
}

void write_lines_of(const results::OutputFolder& out,
                    const std::string& name,
                    const io::LineSet& lines) {
  io::write_lines(out.path(name), lines, io::LineFormat::kGeoJson);
}

/// The patch or block is named after its output folder.
std::string name_of_folder(const std::string& folder) {
  const auto path = std::filesystem::weakly_canonical(folder);
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

std::vector<std::string> file_names(const SimulateArguments& a) {
  std::vector<std::string> names{"lidar.las"};
  names.insert(names.end(), std::begin(kLineFiles), std::end(kLineFiles));
  for (const ModelFile& file : model_files(a)) names.emplace_back(file.name);
  if (a.no_images) return names;
  std::ranges::move(view_file_names(a.views), std::back_inserter(names));
  return names;
}

/// A geometry that sets the image sizes has as many views as sizes.
void check_image_sizes(const simulate::FlightOptions& flight) {
  const std::size_t num_views = simulate::planned_views(flight).size();
  check(flight.size_px.empty() || flight.size_px.size() == num_views, "--views has ", num_views,
        " views; must have ", flight.size_px.size(),
        " with --geometry, which sets the size of each image");
  check(flight.size_px.empty() || !flight.frame_px,
        "--frame-px and --geometry, must not both be given: each sets the size of the images");
}

/// Sets values shared by several options and those that follow from other options.
void complete(const CLI::App& app, SimulateArguments& a) {
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
  set_block(app, a);
  check_image_sizes(a.views.flight);
  simulate::check_sensor(a.views.sensor);
  const io::CrsFacts crs = io::describe({a.village.crs});
  check(!crs.is_geographic, "--crs = ", a.village.crs, " (", crs.name,
        "), its coordinates are degrees; must be a projected one");
}

/// The true lines with their class for the nominal pair.
io::LineSet nominal_truth(const simulate::SyntheticScene& scene) {
  return simulate::classed_by_views(simulate::true_lines(scene), simulate::nominal_pair(scene));
}

void write_graded_lines(const io::LineSet& truth,
                        std::uint64_t seed,
                        const results::OutputFolder& out) {
  for (const auto& [name, grade] :
       {std::pair("good", simulate::Grade::kGood), std::pair("fair", simulate::Grade::kFair),
        std::pair("poor", simulate::Grade::kPoor)}) {
    write_lines_of(out, fmt::format("lines.{}.geojson", name),
                   simulate::degrade_lines(truth, simulate::options_of(grade, seed)));
  }
}

int simulate_patch(const SimulateArguments& a) {
  check_degraded(a.views,
                 transformed(simulate::planned_views(a.views.flight), &simulate::PlannedView::id));
  const results::OutputFolder out(a.out, {}, "simulate.json");
  const std::vector<std::string> names = file_names(a);
  for (const std::string& name : names) (void)out.path(name);
  const simulate::SyntheticScene scene = simulate::make_village(a.village);
  if (!a.no_images) (void)simulate::aerial_views(scene, a.views.flight);  // throws before the work
  const io::PointCloud cloud = simulate::scan_als(scene, a.als);

  io::write_las(out.path("lidar.las"), cloud.points, cloud.frame, scene.crs);
  const io::LineSet truth = nominal_truth(scene);
  write_graded_lines(truth, a.seed, out);
  write_lines_of(
      out, "truth.geojson",
      a.no_images ? truth : write_views(scene, name_of_folder(a.out), a.views, truth, out));
  write_models(scene, a, out);
  out.write_record(nlohmann::ordered_json::object());
  say("{}: {} buildings, {} true lines, {} laser points\n", a.out, scene.buildings.size(),
      truth.lines.size(), cloud.points.size());
  return kDone;
}

int simulate_block(const SimulateArguments& a) {
  const results::OutputFolder out(a.out, {}, "simulate.json");
  const simulate::SyntheticScene scene = simulate::make_village(a.village);
  const std::vector<simulate::AerialView> frames = block_frames(scene, a);
  check_degraded(a.views, transformed(frames, &simulate::AerialView::id));
  std::vector<std::string> names = block_file_names(scene, frames, a);
  names.insert(names.end(), std::begin(kLineFiles), std::end(kLineFiles));
  for (const ModelFile& file : model_files(a)) names.emplace_back(file.name);
  for (const std::string& name : names) (void)out.path(name);

  const std::size_t num_points = write_block(scene, frames, name_of_folder(a.out), a, out);
  const io::LineSet truth = simulate::seen_in_block(scene, frames, nominal_truth(scene));
  write_graded_lines(truth, a.seed, out);
  write_lines_of(out, "truth.geojson", truth);
  write_models(scene, a, out);
  out.write_record(nlohmann::ordered_json::object());
  say("{}: {} frames, a village of {} x {} m, {} buildings, {} true lines, {} laser points\n",
      a.out, frames.size(), scene.extent_m.x(), scene.extent_m.y(), scene.buildings.size(),
      truth.lines.size(), num_points);
  return kDone;
}

}  // namespace

Run add_simulate(CLI::App& subcommand) {
  auto a = std::make_shared<SimulateArguments>();
  add_simulate_options(subcommand, *a);
  return [a, &subcommand] {
    complete(subcommand, *a);
    return a->strips_and_frames.empty() ? simulate_patch(*a) : simulate_block(*a);
  };
}

}  // namespace ridgeline::apps
