// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/gates/figure.h"

#include "evaluate/gates/metric.h"
#include "evaluate/statistics/image_count.h"
#include "evaluate/statistics/product_method.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace ridgeline::evaluate {
namespace {

constexpr const char* kAnyPatch = "(any)";
constexpr const char* kNoMethod = "(none)";

std::vector<std::string> patches_of(const ResultFolder& folder) {
  std::vector<std::string> patches;
  const auto add = [&](const std::string& patch) {
    if (std::find(patches.begin(), patches.end(), patch) == patches.end()) patches.push_back(patch);
  };
  for (const Evaluation& e : folder.evaluations) add(e.patch);
  for (const Table1Row& row : folder.matching.rows) add(row.patch);
  for (const PatchTracks& tracks : folder.matching.tracks) add(tracks.patch);
  return patches;
}

Figure empty_figure(const std::string& patch,
                    const std::string& method,
                    const std::string& line_class) {
  Figure figure;
  figure.patch = patch;
  figure.method = method;
  figure.line_class = line_class;
  return figure;
}

bool is_by_class(const std::string& metric) {
  return !is_matching_metric(metric) && !is_decoy_metric(metric) && !is_scan_metric(metric);
}

Figure missing_figure(const Gate& gate,
                      const std::string& patch,
                      const std::string& line_class,
                      std::string why) {
  Figure figure = empty_figure(patch, gate.method.value_or(kNoMethod),
                               is_by_class(gate.metric) ? line_class : "");
  figure.why_missing = std::move(why);
  return figure;
}

std::string why_no_class(const Evaluation& e, const std::string& line_class) {
  std::vector<std::string> classes;
  for (const Summary& cell : e.classes) classes.push_back(cell.line_class);
  std::string why =
      fmt::format("these lines have no class {}, only {}", line_class, fmt::join(classes, ", "));
  if (find_class(e.classes, kAligned) == nullptr) {
    why +=
        "; the classes aligned and not_aligned come from evaluate `patch` PATCH.yaml, or from a "
        "column class of the line file";
  }
  return why;
}

std::string why_no_value(const Summary& cell, const std::string& metric) {
  if (cell.n_lines == 0) return "no line has class " + cell.line_class;
  if (cell.n_evaluated == 0) {
    return fmt::format("none of the {} lines of class {} was evaluated", cell.n_lines,
                       cell.line_class);
  }
  if (cell.n_parts == 0 && metric_count(cell, metric) == 0) {
    return fmt::format(
        "none of the {} lines is a ridge or hip with separate horizontal and vertical errors",
        cell.n_evaluated);
  }
  return fmt::format("n = {} lines have no {}", cell.n_evaluated, metric);
}

/// The classes of the lines with one number of images.
std::vector<Summary> classes_of_images(const Evaluation& e, int n_images) {
  std::vector<LineEvaluation> lines;
  std::ranges::copy_if(e.lines, std::back_inserter(lines), [&](const LineEvaluation& line) {
    return image_group(line.n_images) == image_group(n_images);
  });
  return summarize_classes(lines, e.options);
}

/// Among the buildings with judged lines of a class, the share whose lines have an RMS of at most
/// Gate::within_m.
Figure building_figure(const Evaluation& e, const std::string& line_class, const Gate& gate) {
  struct Sum {
    double squares_m2 = 0.0;
    double n = 0.0;
  };
  std::map<std::string, Sum> buildings;
  for (const LineEvaluation& line : e.lines) {
    const bool counts =
        line.status == Status::kEvaluated && !line.building.empty() &&
        (line_class == kTotal || line.line_class == line_class) &&
        (!gate.n_images || image_group(line.n_images) == image_group(*gate.n_images)) &&
        (!gate.decided_by || decided_group(line) == *gate.decided_by);
    if (!counts) continue;
    Sum& sum = buildings[line.building];
    sum.squares_m2 += *line.mean_distance_m * *line.mean_distance_m;
    sum.n += 1.0;
  }
  Figure figure = empty_figure(e.patch, e.method, line_class);
  figure.n = buildings.size();
  if (buildings.empty()) {
    figure.why_missing =
        "no line with a building was judged; buildings come from building models or from the "
        "column building";
    return figure;
  }
  const auto n_within = std::ranges::count_if(buildings, [&](const auto& building) {
    return std::sqrt(building.second.squares_m2 / building.second.n) <= *gate.within_m;
  });
  figure.value = static_cast<double>(n_within) / static_cast<double>(buildings.size());
  return figure;
}

Figure decoy_figure(const Evaluation& e, const Gate& gate) {
  Figure figure = empty_figure(e.patch, e.method, "");
  const auto found = std::ranges::find_if(e.decoys, [&](const DecoyFigure& d) {
    return name(d.kind) == gate.kind && d.distance_m == gate.distance_m;
  });
  if (found == e.decoys.end()) {
    figure.why_missing = e.decoys.empty() ? "no lines were moved on purpose (`decoys`)"
                                          : fmt::format("no line was moved that way ({}, {} m)",
                                                        *gate.kind, *gate.distance_m);
    return figure;
  }
  figure.value = found->share();
  figure.ci95 = found->ci95;
  figure.n_clusters = found->n_clusters;
  figure.n = found->n_decoys;
  figure.evaluated_share = 1.0 - found->withheld_share().value_or(0.0);
  return figure;
}

Figure scan_figure(const Evaluation& e, const Gate& gate) {
  Figure figure = empty_figure(e.patch, e.method, "");
  if (!e.completeness) {
    figure.why_missing = "the lines were not compared with the edges of the scan (`completeness`)";
    return figure;
  }
  const std::string kind = gate.kind.value_or("all");
  const CompletenessRow* row = find_row(*e.completeness, kind);
  if (row == nullptr || row->n == 0) {
    figure.why_missing = kind == "all" ? "the scan has no edges in the area of the lines"
                                       : fmt::format("the scan has no {} there", kind);
    return figure;
  }
  figure.value = metric_value(*row, gate.metric);
  figure.ci95 = metric_interval(*row, gate.metric);
  figure.n_clusters = row->n_clusters;
  figure.n = row->n;
  return figure;
}

Figure accuracy_figure(const Evaluation& e, const std::string& line_class, const Gate& gate) {
  const std::string& metric = gate.metric;
  Figure figure = empty_figure(e.patch, e.method, line_class);
  const std::vector<Summary> of_images =
      gate.n_images ? classes_of_images(e, *gate.n_images) : std::vector<Summary>();
  const Summary* of_class = find_class(gate.n_images ? of_images : e.classes, line_class);
  if (of_class == nullptr) {
    figure.why_missing = why_no_class(e, line_class);
    return figure;
  }
  const Summary cell = gate.decided_by ? of_class->of_group(*gate.decided_by) : *of_class;
  figure.value = metric_value(cell, metric);
  figure.ci95 = metric_interval(cell, metric);
  if (has_clustered_interval(metric)) figure.n_clusters = cell.n_clusters;
  figure.n = metric_count(cell, metric);
  figure.evaluated_share = cell.evaluated_share();
  if (figure.value) return figure;
  figure.why_missing = why_no_value(cell, metric);
  if (gate.n_images) {
    figure.why_missing +=
        fmt::format(" that {} images show", image_group_name(*image_group(gate.n_images)));
  }
  if (gate.decided_by) {
    figure.why_missing += fmt::format(", decided by {}", name(*gate.decided_by));
  }
  return figure;
}

/// The evaluations of a patch to which a gate without a method applies, see figures_of().
std::vector<const Evaluation*> products_of(const std::vector<const Evaluation*>& evaluations,
                                           const ResultFolder& folder) {
  if (folder.is_of_line_files || evaluations.empty()) return evaluations;
  return {evaluations[product_index(evaluations, &Evaluation::method)]};
}

std::string why_no_method(const std::string& method,
                          const std::vector<std::string_view>& methods,
                          const ResultFolder& folder) {
  std::string why =
      fmt::format("there is no method {}; available: {}", method, fmt::join(methods, ", "));
  const bool is_method = std::ranges::find(kMethodsByRank, method) != kMethodsByRank.end();
  if (is_method && !folder.is_of_line_files)
    why += fmt::format("; run with `methods` {},{}", fmt::join(methods, ","), method);
  return why;
}

std::vector<Figure> accuracy_figures(const Gate& gate,
                                     const std::string& patch,
                                     const std::string& line_class,
                                     const ResultFolder& folder) {
  std::vector<const Evaluation*> of_patch;
  std::vector<std::string_view> methods;
  for (const Evaluation& e : folder.evaluations) {
    if (e.patch != patch) continue;
    of_patch.push_back(&e);
    methods.push_back(e.method);
  }
  if (!gate.method) of_patch = products_of(of_patch, folder);
  std::vector<Figure> figures;
  for (const Evaluation* e : of_patch) {
    if (gate.method.value_or(e->method) != e->method) continue;
    figures.push_back(is_building_metric(gate.metric) ? building_figure(*e, line_class, gate)
                      : is_decoy_metric(gate.metric)  ? decoy_figure(*e, gate)
                      : is_scan_metric(gate.metric)   ? scan_figure(*e, gate)
                                                      : accuracy_figure(*e, line_class, gate));
  }
  if (figures.empty()) {
    figures.push_back(missing_figure(gate, patch, line_class,
                                     methods.empty()
                                         ? "no lines of this patch were judged"
                                         : why_no_method(*gate.method, methods, folder)));
  }
  return figures;
}

Figure matching_figure(const Table1Row& row, const std::string& metric) {
  Figure figure = empty_figure(row.patch, row.matcher, "");
  figure.value = metric_value(row.counts, metric);
  figure.ci95 = metric_interval(row.counts, metric);
  figure.n = metric_count(row.counts, metric);
  if (!figure.value) figure.why_missing = "none of these matches is in the reference";
  return figure;
}

std::string why_no_matching(const Gate& gate,
                            const std::vector<std::string_view>& matchers,
                            const ResultFolder& folder) {
  if (folder.is_of_line_files) {
    return gate.metric + " measures matching, which run and demo do but evaluate does not";
  }
  if (matchers.empty()) {
    return "the matches were not judged; the patch file needs reference_matches";
  }
  return fmt::format("there is no matcher {}; available: {}", gate.method.value_or(kNoMethod),
                     fmt::join(matchers, ", "));
}

std::vector<Figure> matching_figures(const Gate& gate,
                                     const std::string& patch,
                                     const ResultFolder& folder) {
  std::vector<const Table1Row*> of_patch;
  std::vector<std::string_view> matchers;
  for (const Table1Row& row : folder.matching.rows) {
    if (row.patch != patch) continue;
    of_patch.push_back(&row);
    matchers.push_back(row.matcher);
  }
  std::vector<Figure> figures;
  for (const Table1Row* row : of_patch) {
    if (gate.method.value_or(row->matcher) != row->matcher) continue;
    figures.push_back(matching_figure(*row, gate.metric));
  }
  if (figures.empty()) {
    figures.push_back(missing_figure(gate, patch, "", why_no_matching(gate, matchers, folder)));
  }
  return figures;
}

std::string why_no_tracks(const Gate& gate, const ResultFolder& folder) {
  if (gate.method) return gate.metric + " covers all tracks of a run, so method must be omitted";
  if (folder.is_of_line_files) return gate.metric + " measures tracks, which only run makes";
  return "the tracks were not judged; the patch file needs reference_tracks";
}

Figure track_figure(const Gate& gate,
                    const std::string& patch,
                    const std::string& line_class,
                    const ResultFolder& folder) {
  const auto of_patch = std::ranges::find(folder.matching.tracks, patch, &PatchTracks::patch);
  if (gate.method || of_patch == folder.matching.tracks.end())
    return missing_figure(gate, patch, line_class, why_no_tracks(gate, folder));
  for (const TrackCell& cell : of_patch->cells) {
    if (cell.line_class != line_class || cell.group != image_group(gate.n_images)) continue;
    Figure figure = empty_figure(patch, kNoMethod, line_class);
    figure.value = metric_value(cell.counts, gate.metric);
    figure.n = metric_count(cell.counts, gate.metric);
    if (!figure.value) figure.why_missing = "no such true edge exists, or none has a track";
    return figure;
  }
  return missing_figure(gate, patch, line_class, "tracks have no class " + line_class);
}

}  // namespace

std::vector<Figure> figures_of(const Gate& gate,
                               const std::string& line_class,
                               const ResultFolder& folder) {
  const std::vector<std::string> patches = patches_of(folder);
  std::vector<Figure> result;
  for (const std::string& patch : patches) {
    if (gate.patch.value_or(patch) != patch) continue;
    if (is_track_metric(gate.metric)) {
      result.push_back(track_figure(gate, patch, line_class, folder));
      continue;
    }
    std::vector<Figure> figures = is_matching_metric(gate.metric)
                                      ? matching_figures(gate, patch, folder)
                                      : accuracy_figures(gate, patch, line_class, folder);
    for (Figure& figure : figures) result.push_back(std::move(figure));
  }
  if (result.empty()) {
    const std::string patch = gate.patch.value_or(kAnyPatch);
    result.push_back(missing_figure(
        gate, patch, line_class,
        patches.empty()
            ? "there are no results"
            : fmt::format("there is no patch {}; available: {}", patch, fmt::join(patches, ", "))));
  }
  return result;
}

}  // namespace ridgeline::evaluate
