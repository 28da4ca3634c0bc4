// SPDX-License-Identifier: BSD-3-Clause
#include "apps/info/data_facts.h"

#include "evaluate/files/judged_lines.h"
#include "io/cloud/cloud_facts.h"
#include "io/cloud/read_cloud.h"
#include "io/crs/grid_scale.h"
#include "io/lines/line_facts.h"
#include "io/lines/read_lines.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>

namespace ridgeline::apps {
namespace {

/// The unit of the file, with its name in the reference system if both units are the same.
std::string unit_text(double unit_m, double crs_unit_m, const std::string& crs_unit_name) {
  if (io::same_unit(unit_m, crs_unit_m))
    return fmt::format("{} ({:.12g} m)", crs_unit_name, unit_m);
  return io::unit_text(unit_m);
}

/// `unit_m`: the unit of each axis. The unit keys of a file may differ from its reference system.
void print_crs(const io::CrsFacts& crs, const Eigen::Vector3d& unit_m, bool states_unit) {
  fmt::print("  crs         {}\n", crs.name);
  if (!states_unit) {
    fmt::print("  units       unknown, assuming metres\n");
    return;
  }
  fmt::print("  units       {} in plan, {} in height\n",
             unit_text(unit_m.x(), crs.horizontal_unit_m, crs.horizontal_unit_name),
             unit_text(unit_m.z(), crs.vertical_unit_m, crs.vertical_unit_name));
}

/// Prints the map scale of a projected reference system at the centre of the data.
void print_scale(const std::string& path,
                 const std::optional<io::GridScale>& scale,
                 InfoWarnings& warnings) {
  if (!scale) return;
  fmt::print("  scale       map scale {}\n", io::scale_text(*scale));
  if (!scale->in_area_of_use) {
    warnings.add(path, "outside the reference system's area of use");
  } else if (!scale->is_true()) {
    warnings.add(path, "the plan is not true to scale; evaluate requires --scale-to-ground");
  }
}

void print_bounds(const Eigen::AlignedBox3d& box) {
  if (box.isEmpty()) {
    fmt::print("  bounds      none\n");
    return;
  }
  fmt::print("  bounds      x {:.3f} .. {:.3f}, y {:.3f} .. {:.3f}, z {:.3f} .. {:.3f}\n",
             box.min().x(), box.max().x(), box.min().y(), box.max().y(), box.min().z(),
             box.max().z());
}

void print_counts(const char* label, const std::map<std::uint8_t, std::uint64_t>& counts) {
  if (counts.empty()) return;
  fmt::print("  {:<11}", label);
  for (const auto& [value, n] : counts) fmt::print(" {}: {}", value, n);
  fmt::print("\n");
}

/// Buildings and roof faces by LoD, and the kinds of the edges.
void print_buildings(const io::LineSet& set) {
  std::map<std::string, std::size_t> lods, kinds;
  for (const io::Building& building : set.model->buildings)
    ++lods[building.lod.empty() ? "of unknown LoD" : "of LoD " + building.lod];
  for (const io::Line& line : set.lines) ++kinds[line.kind];
  const auto listed = [](const std::map<std::string, std::size_t>& counts) {
    return transformed(
        counts, [](const auto& entry) { return fmt::format("{} {}", entry.second, entry.first); });
  };
  const auto n_roofs = std::ranges::count(set.model->faces, FaceKind::kRoof, &Face::kind);
  fmt::print("  buildings   {}; {} roof faces\n  kinds       {}\n", fmt::join(listed(lods), ", "),
             n_roofs, fmt::join(listed(kinds), ", "));
}

}  // namespace

void print_crs(const io::Crs& crs) {
  const io::CrsFacts facts = io::describe(crs);
  print_crs(facts, {facts.horizontal_unit_m, facts.horizontal_unit_m, facts.vertical_unit_m},
            crs.known());
}

void print_cloud(const std::string& path, double max_resolution_m, InfoWarnings& warnings) {
  const io::CloudFacts facts = io::cloud_facts(path, {.max_resolution_m = max_resolution_m});
  fmt::print("{}: {}\n  points      {}\n", path, facts.format, facts.n_points);
  if (facts.n_non_finite > 0) fmt::print("  not finite  {}\n", facts.n_non_finite);
  print_bounds(facts.bounds);
  if (facts.density_per_m2) {
    fmt::print("  density     {:.2f} points/m2 where not empty\n", *facts.density_per_m2);
  }
  print_counts("classes", facts.n_by_class);
  print_counts("returns", facts.n_by_return);
  if (facts.n_withheld > 0) fmt::print("  withheld    {}\n", facts.n_withheld);
  print_crs(facts.crs, facts.unit_m, facts.states_unit);
  print_scale(path, facts.plan_scale, warnings);
  if (facts.scale && facts.offset) {
    fmt::print("  stored as   scale {:g} {:g} {:g}, offset {:.3f} {:.3f} {:.3f}\n",
               facts.scale->x(), facts.scale->y(), facts.scale->z(), facts.offset->x(),
               facts.offset->y(), facts.offset->z());
  }
  for (const std::string& warning : facts.warnings) warnings.add(path, warning);
}

void print_lines(const std::string& path, InfoWarnings& warnings) {
  const io::LineSet set = io::read_lines(path);
  const io::LineFacts facts = io::line_facts(set);
  const std::string unit = io::describe(set.crs).horizontal_unit_name;
  fmt::print("{}: {}\n  lines       {}, total length {:.1f} {}\n", path, set.format, facts.n_lines,
             facts.total_length, unit == "metre" ? "m" : unit);
  if (facts.n_polylines > 0) fmt::print("  polylines   {}\n", facts.n_polylines);
  if (facts.n_non_finite > 0) fmt::print("  not finite  {}\n", facts.n_non_finite);
  print_bounds(facts.bounds);
  const Eigen::Vector3d steps_m = io::steps_of(set, results::unit_m_of(set)).steps_m();
  if (!steps_m.isZero()) fmt::print("  digits      {}\n", io::steps_text(steps_m));
  fmt::print("  attributes  {}\n", fmt::join(facts.attributes, " "));
  print_crs(set.crs);
  if (!facts.bounds.isEmpty()) {
    print_scale(path, io::grid_scale(set.crs, facts.bounds.center().head<2>()), warnings);
  }
  if (!set.stated_unit.empty()) fmt::print("  $INSUNITS   {}\n", set.stated_unit);
  if (set.model) print_buildings(set);
  for (const std::string& warning : set.warnings) warnings.add(path, warning);
}

}  // namespace ridgeline::apps
