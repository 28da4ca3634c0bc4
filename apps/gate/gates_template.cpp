// SPDX-License-Identifier: BSD-3-Clause
#include "apps/gate/gates_template.h"

#include "evaluate/gates/metric.h"

#include <fmt/format.h>

#include <string_view>

namespace ridgeline::apps {
namespace {

constexpr std::string_view kKeys =
    R"(# Accuracy gates: ridgeline gate RESULTS --gates THIS_FILE
# RESULTS is a folder that run, block, demo, evaluate or pool wrote with --out.
# Exit code 0: all gates passed. 3: a gate failed. 1: this file or the results are wrong.
# A gate whose figure does not exist fails. Only the gates listed here are checked.
#
# What a gate checks (default if omitted):
#   metric  a figure from the lists below; default: rms_m
#   class   total, aligned or not_aligned (with the epipolar lines); default: total.
#           Lines without a class only count in total; classes come from images (run, demo,
#           evaluate --patch PATCH.yaml) or from the column class of the line file.
#   n_images  only lines seen in this many images, 2 to 5 (5: five or more); default: all
#   decided_by  only lines whose surface was chosen by plan and images (plan_images, the headline
#           of the tables) or by points and place (points_place); default: all judged lines
#   within_m  for buildings_within_m: the largest acceptable RMS of a building's lines, as in
#           {metric: buildings_within_m, within_m: 0.20, min: 0.90}
#   kind    for decoy_share: height, across or match; for scan_recall and scan_recall_length:
#           ridge, hip, valley, eave, verge or step; default: all
#   distance_m  for decoy_share: 0.5, 1, 2 or 5, as in
#           {metric: decoy_share, kind: height, distance_m: 1, max: 0.02}. The gate fails if
#           the interval is wider than its limit; raise --decoys of run and evaluate then.
#   patch   id of a patch; default: every patch
#   method  direct, joint, network or planes; after evaluate the line file's name without extension;
#           for matching figures the matcher: pairwise or chio. Default:
#           the first of network, joint and direct that was run; after evaluate every
#           line file; for matching the matcher that was run.
#   n_min   the gate fails with fewer lines or matches; default: no minimum.
#           At the top level, next to `gates`, it is the default for every gate.
#
# Its rules, which must all hold:
#   max                          largest allowed figure, in m or as a share from 0 to 1
#   bound                        what max limits: point, the figure itself (default), or upper95,
#                                the upper end of the 95 % interval (rms_m and decoy_share); fails
#                                with fewer than 10 clusters (buildings)
#   min                          smallest allowed figure
#   max_ratio_to: {class: NAME}  at most `ratio` times the same figure of the class NAME
#   ratio                        default: 2.5
#   max_increase_over_baseline   at most this much above the figure of --baseline DIR, in m or
#                                as a share; `default`: the larger of 0.002 m and 5 %
#   max_decrease_below_baseline  at most this much below it
# --baseline DIR is the results folder of an earlier run on the same data.
#
)";

constexpr std::string_view kGates = R"(
n_min: 20

gates:
  - {class: total, metric: rms_m, max: 0.30}

  # Leaving out bad lines lowers the RMS, so the share of judged lines needs its own gate:
  - {class: total, metric: evaluated_share, min: 0.80}

  # To rule out passing by chance, limit the upper end of the interval:
  # - {class: total, metric: rms_m, max: 0.35, bound: upper95}

  # For lines with classes:
  # - {class: aligned, metric: rms_m, max_ratio_to: {class: not_aligned}, ratio: 2.5}

  # For matches, if the patch file has reference_matches:
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
      "{}# Metrics of lines:\n{}# Metrics of matches:\n{}# Metrics of tracks, if the patch file "
      "has reference_tracks:\n{}# Metrics of buildings:\n{}# Metrics of decoys (lines moved on "
      "purpose):\n{}# Metrics of the edges of the scan, with --completeness of evaluate, run or "
      "block:"
      "\n{}{}",
      kKeys, list_of(evaluate::accuracy_metrics()), list_of(evaluate::matching_metrics()),
      list_of(evaluate::track_metrics()), list_of(evaluate::building_metrics()),
      list_of(evaluate::decoy_metrics()), list_of(evaluate::scan_metrics()), kGates);
}

}  // namespace ridgeline::apps
