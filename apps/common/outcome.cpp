// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/outcome.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace ridgeline::apps {
namespace {

using evaluate::Evaluation;
using evaluate::LineEvaluation;
using evaluate::Status;

std::size_t n_of(const Evaluation& evaluation, auto holds) {
  return static_cast<std::size_t>(std::ranges::count_if(
      evaluation.lines, [&](const LineEvaluation& line) { return holds(line.status); }));
}

bool is_unconfirmed(Status status) { return status == Status::kUnconfirmed; }

std::size_t n_reconstructed(const Evaluation& evaluation) {
  return n_of(evaluation, [](Status status) { return status != Status::kNotReconstructed; });
}

std::string counted(std::size_t n, const char* noun, const char* plural) {
  return fmt::format("{} {}", n, n == 1 ? noun : plural);
}

std::string lines(std::size_t n) { return counted(n, "line", "lines"); }

/// How many lines were reconstructed: "57 lines", or "57 lines by direct, 55 lines by joint" if the
/// methods differ.
std::string lines_text(std::span<const Evaluation> evaluations) {
  std::set<std::size_t> different;
  std::vector<std::string> texts;
  for (const Evaluation& evaluation : evaluations) {
    const std::size_t n = n_reconstructed(evaluation);
    different.insert(n);
    texts.push_back(fmt::format("{} by {}", lines(n), evaluation.method));
  }
  if (different.size() == 1) return lines(*different.begin());
  return fmt::format("{}", fmt::join(texts, ", "));
}

/// Why the lines of the method with the most lines were not judged: "40 no_lidar, 17 low_coverage".
std::string reasons_text(std::span<const Evaluation> evaluations) {
  const auto most = std::ranges::max_element(evaluations, {}, n_reconstructed);
  std::map<std::string, std::size_t> n_by_reason;
  for (const LineEvaluation& line : most->lines) ++n_by_reason[name(line.status)];
  std::vector<std::string> texts;
  texts.reserve(n_by_reason.size());
  for (const auto& [reason, n] : n_by_reason) texts.push_back(fmt::format("{} {}", n, reason));
  return fmt::format("{}", fmt::join(texts, ", "));
}

bool none_is_reconstructed(std::span<const Evaluation> evaluations) {
  return std::ranges::all_of(evaluations, [](const auto& e) { return n_reconstructed(e) == 0; });
}

std::string statuses_text(std::span<const Evaluation> evaluations) {
  return fmt::format("none of {} could be judged: {}", lines_text(evaluations),
                     reasons_text(evaluations));
}

std::string why_none_is_judged(const PatchCounts& counts, std::span<const Evaluation> evaluations) {
  if (none_is_reconstructed(evaluations)) {
    if (counts.n_matches == 0) {
      return fmt::format("no line was reconstructed: none of {} of the left image has a match",
                         counted(counts.n_left_segments, "segment", "segments"));
    }
    return fmt::format("no line was reconstructed from {}",
                       counted(counts.n_matches, "match", "matches"));
  }
  if (!counts.has_lidar) {
    return fmt::format("no LIDAR given: {} reconstructed, none judged", lines_text(evaluations));
  }
  return statuses_text(evaluations);
}

/// The smallest median distance of the methods; std::nullopt unless each method has enough judged
/// lines for a median.
std::optional<double> least_median_m(std::span<const Evaluation> evaluations) {
  constexpr std::size_t kMinLines = 10;
  std::optional<double> least;
  for (const Evaluation& evaluation : evaluations) {
    for (const evaluate::Summary& summary : evaluation.classes) {
      if (summary.line_class != "total") continue;
      if (summary.n_evaluated < kMinLines || !summary.median_m) return std::nullopt;
      least = std::min(least.value_or(*summary.median_m), *summary.median_m);
    }
  }
  return least;
}

std::vector<std::string> unconfirmed_messages(const std::string& patch,
                                              std::span<const Evaluation> evaluations) {
  std::vector<std::string> texts;
  for (const Evaluation& evaluation : evaluations) {
    const std::size_t n = n_of(evaluation, is_unconfirmed);
    if (n == 0) continue;
    texts.push_back(fmt::format("{} of {}", n, lines(n_reconstructed(evaluation))));
    if (evaluations.size() > 1) texts.back() += " by " + evaluation.method;
  }
  if (texts.empty()) return {};
  return {fmt::format(
      "Patch {}: not judged because another image should show them but does not (unconfirmed): {}.",
      patch, fmt::join(texts, ", "))};
}

}  // namespace

bool has_figures(std::span<const Evaluation> evaluations) {
  return std::ranges::any_of(evaluations, [](const Evaluation& evaluation) {
    return n_of(evaluation, [](Status status) { return status == Status::kEvaluated; }) > 0;
  });
}

std::vector<std::string> judging_messages(const std::string& patch,
                                          std::span<const Evaluation> evaluations) {
  if (evaluations.empty()) return {};
  if (has_figures(evaluations)) return unconfirmed_messages(patch, evaluations);
  const std::string why =
      none_is_reconstructed(evaluations) ? "no line has a geometry" : statuses_text(evaluations);
  return {fmt::format("Patch {}: {}.", patch, why)};
}

std::vector<std::string> outcome_messages(const PatchCounts& counts,
                                          std::span<const Evaluation> evaluations) {
  if (evaluations.empty()) return {};
  if (!has_figures(evaluations)) {
    return {fmt::format("Patch {}: {}.", counts.patch, why_none_is_judged(counts, evaluations))};
  }
  std::vector<std::string> messages = unconfirmed_messages(counts.patch, evaluations);
  const std::optional<double> median_m = least_median_m(evaluations);
  if (!median_m || *median_m <= evaluations.front().options.gross_m) return messages;
  messages.push_back(
      fmt::format("Patch {}: half of the lines are more than {:.2f} m from the LIDAR; images, "
                  "cameras and LIDAR probably do not match.",
                  counts.patch, *median_m));
  return messages;
}

}  // namespace ridgeline::apps
