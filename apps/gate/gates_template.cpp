// SPDX-License-Identifier: BSD-3-Clause
#include "apps/gate/gates_template.h"

#include "evaluate/gates/metric.h"

#include <fmt/format.h>

#include <string_view>

namespace ridgeline::apps {
namespace {

constexpr std::string_view kKeys =
    R"(# Accuracy gates: ridgeline gate RESULTS --gates THIS_FILE
# RESULTS is a folder that run, demo or evaluate wrote with --out.
# Exit code 0: every gate holds. 3: a gate failed. 1: this file or the results are wrong.
# A gate whose figure does not exist fails. What is not written here is not checked.
#
# What a gate is about:
#   metric  the figure, one of the lists below; rms_m if left out
#   class   total, aligned or not_aligned (with the epipolar lines); total if left out.
#           Lines without classes are judged as total; classes come from images (run, demo,
#           evaluate --patch PATCH.yaml) or from a column class of the line file.
#   n_images  only lines of so many images, 2 to 5, where 5 is five and more; all if left out
#   decided_by  only lines on whose surface plan and images decided (plan_images: the headline of the
#           tables), or points and place (points_place); all that were judged if left out
#   within_m  of buildings_within_m: the largest RMS of a building's lines that is good, as in
#           {metric: buildings_within_m, within_m: 0.20, min: 0.90}
#   kind    of decoy_share: height, across or match
#   distance_m  of decoy_share: 0.5, 1, 2 or 5, as in
#           {metric: decoy_share, kind: height, distance_m: 1, max: 0.02}. With an interval
#           wider than its limit the gate fails; --decoys of run and evaluate makes more.
#   patch   the patch's id; each patch if left out
#   method  direct, joint, network or planes; after evaluate the line file's name without extension;
#           for the figures of matching the matcher: pairwise, chio or both. If left out:
#           network, else joint, else direct, of those that were run; after evaluate each
#           line file; both, else the matcher that was run.
#   n_min   with fewer lines, or matches, the gate fails; any number will do if left out.
#           Beside `gates` it is the n_min of every gate that has none of its own.
#
# Its rules; every one that is written must hold:
#   max                          the figure is at most this, in m or as a share from 0 to 1
#   bound                        of max: point, the figure itself, if left out; upper95, the upper
#                                end of the 95 % interval, of rms_m and decoy_share. With fewer
#                                than 10 clusters (buildings) the gate then fails.
#   min                          it is at least this
#   max_ratio_to: {class: NAME}  at most `ratio` times the same figure of the class NAME;
#   ratio                        2.5 if left out
#   max_increase_over_baseline   at most this much above the figure of --baseline DIR, in m or
#                                as a share; `default`: the larger of 0.002 m and 5 %
#   max_decrease_below_baseline  at most this much below it
# --baseline DIR is a folder of results, too, of an earlier run on the same data.
#
)";

constexpr std::string_view kGates = R"(
n_min: 20

gates:
  - {class: total, metric: rms_m, max: 0.30}

  # Bad lines that are left out lower the RMS, so the share of lines judged needs its own gate:
  - {class: total, metric: evaluated_share, min: 0.80}

  # So that chance cannot pass it, the upper end of the interval instead:
  # - {class: total, metric: rms_m, max: 0.35, bound: upper95}

  # Of lines with classes:
  # - {class: aligned, metric: rms_m, max_ratio_to: {class: not_aligned}, ratio: 2.5}

  # Of matches, where the patch file names reference_matches:
  # - {metric: correctness, min: 0.95}
  # - {metric: completeness, min: 0.90}
  # - {metric: quality, min: 0.85}

  # Against --baseline DIR:
  # - {class: total, metric: rms_m, max_increase_over_baseline: 0.02}
  # - {class: total, metric: evaluated_share, max_decrease_below_baseline: 0.02}
)";

std::string list_of(const std::vector<evaluate::Metric>& metrics) {
  std::string text;
  for (const evaluate::Metric& metric : metrics) {
    text += fmt::format("#   {:<25}  {}\n", metric.name, metric.meaning);
  }
  return text;
}

}  // namespace

std::string gates_template() {
  return fmt::format(
      "{}# Metrics of lines:\n{}# Metrics of matches:\n{}# Metrics of tracks, where the patch file "
      "names reference_tracks:\n{}# Metrics of buildings:\n{}# Metrics of decoys, lines moved on "
      "purpose:\n{}{}",
      kKeys, list_of(evaluate::accuracy_metrics()), list_of(evaluate::matching_metrics()),
      list_of(evaluate::track_metrics()), list_of(evaluate::building_metrics()),
      list_of(evaluate::decoy_metrics()), kGates);
}

}  // namespace ridgeline::apps
