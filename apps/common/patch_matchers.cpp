// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/patch_matchers.h"

#include "reconstruct/chio/combine_matches.h"
#include "reconstruct/match/match_pairwise.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <utility>

namespace ridgeline::apps {
namespace {

using reconstruct::MatchSource;

/// The matcher of what height propagation adds to `pairwise`.
constexpr const char* kByHeight = "pairwise_height";

template <typename Outcome>
std::vector<std::string> reasons_of(const std::vector<Outcome>& outcomes) {
  std::vector<std::string> reasons;
  reasons.reserve(outcomes.size());
  for (const Outcome outcome : outcomes) reasons.emplace_back(reconstruct::name(outcome));
  return reasons;
}

std::vector<io::MatchRow> rows_of(const std::vector<ScoredMatch>& matches, Matcher matcher) {
  std::vector<io::MatchRow> rows;
  rows.reserve(matches.size());
  for (const ScoredMatch& scored : matches) rows.push_back({scored, name(matcher)});
  return rows;
}

std::pair<int, int> ids(const ScoredMatch& scored) {
  return {scored.match.left, scored.match.right};
}

/// The matches of `pairwise`, and those that the height of these makes possible.
MatchList pairwise_list(const reconstruct::MatchView& left,
                        const reconstruct::MatchView& right,
                        const std::array<double, 2>& height_range_in_local_m,
                        const MatchingOptions& options) {
  const reconstruct::MatchResult found =
      reconstruct::match_pairwise(left, right, height_range_in_local_m, options.pairwise);
  MatchList list{name(Matcher::kPairwise), rows_of(found.matches, Matcher::kPairwise),
                 reasons_of(found.outcomes)};
  if (!options.propagate_heights) return list;
  reconstruct::ChioOptions propagation = options.chio;
  propagation.range_m =
      0.0;  // heights of lines that are only nearby brought more wrong lines than right ones
  propagation.min_similarity =
      std::max(propagation.min_similarity, options.propagate_min_similarity);
  const reconstruct::ChioResult more = reconstruct::propagate_heights(
      left, right, height_range_in_local_m, found.matches, propagation, options.pairwise);
  for (const reconstruct::ChioLine& line : more.lines) {
    list.rows.push_back({line.scored, kByHeight});
    list.reasons[static_cast<std::size_t>(line.scored.match.left)] = "matched";
  }
  std::sort(list.rows.begin(), list.rows.end(), [](const io::MatchRow& a, const io::MatchRow& b) {
    return ids(a.scored) < ids(b.scored);
  });
  return list;
}

std::vector<ScoredMatch> scored_matches(const MatchList& list) {
  std::vector<ScoredMatch> matches;
  matches.reserve(list.rows.size());
  for (const io::MatchRow& row : list.rows) matches.push_back(row.scored);
  return matches;
}

/// A match that both have found is of "pairwise+chio", or of "pairwise_height+chio".
MatchList combined(const std::vector<EdgeSegment>& left,
                   const MatchList& pairwise,
                   const reconstruct::ChioResult& chio) {
  MatchList both{kBothMatchers, {}, pairwise.reasons};
  std::map<std::pair<int, int>, std::string> finders;
  for (const io::MatchRow& row : pairwise.rows) finders[ids(row.scored)] = row.matcher;
  for (const reconstruct::CombinedMatch& match :
       reconstruct::combine_matches(left, scored_matches(pairwise), chio.lines)) {
    std::string finder;
    if (match.source != MatchSource::kChio) finder = finders.at(ids(match.scored));
    if (match.source == MatchSource::kBoth) finder += '+';
    if (match.source != MatchSource::kPairwise) finder += name(Matcher::kChio);
    both.rows.push_back({match.scored, finder});
    both.reasons[static_cast<std::size_t>(match.scored.match.left)] = "matched";
  }
  return both;
}

}  // namespace

const char* name(Matcher matcher) { return matcher == Matcher::kPairwise ? "pairwise" : "chio"; }

void add_matcher_options(CLI::App& app, std::vector<std::string>& names, MatchingOptions& options) {
  app.add_option("--matcher", names, "of the line segments: pairwise, chio, or both: pairwise,chio")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember({"pairwise", "chio"}))
      ->capture_default_str();
  app.add_option(
         "--propagate-heights", options.propagate_heights,
         "lines that pairwise leaves unmatched may take the height of matched lines they meet")
      ->capture_default_str();
  app.add_option("--propagate-min-similarity", options.propagate_min_similarity,
                 "if they look alike to at least this")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
}

std::vector<Matcher> matchers_named(const std::vector<std::string>& names) {
  std::vector<Matcher> matchers;
  for (const Matcher matcher : {Matcher::kPairwise, Matcher::kChio}) {
    if (std::find(names.begin(), names.end(), name(matcher)) != names.end()) {
      matchers.push_back(matcher);
    }
  }
  return matchers;
}

void validate_matching(const MatchingOptions& options) {
  validate(options.pairwise);
  validate(options.chio);
}

PatchMatches match_views(const reconstruct::MatchView& left,
                         const reconstruct::MatchView& right,
                         const std::array<double, 2>& height_range_in_local_m,
                         const MatchingOptions& options) {
  PatchMatches result;
  for (const Matcher matcher : options.matchers) {
    if (matcher == Matcher::kPairwise) {
      result.lists.push_back(pairwise_list(left, right, height_range_in_local_m, options));
    } else {
      result.chio = reconstruct::chio_match(left, right, height_range_in_local_m, options.chio,
                                            options.pairwise);
      result.lists.push_back({name(matcher), rows_of(matches_of(*result.chio), matcher),
                              reasons_of(result.chio->outcomes)});
    }
  }
  if (result.lists.size() == 2) {
    result.lists.push_back(combined(left.segments, result.lists[0], *result.chio));
  }
  return result;
}

PatchMatches match_patch(const io::PatchFile& patch,
                         const std::array<cv::Mat, 2>& images,
                         const std::array<std::vector<EdgeSegment>, 2>& segments,
                         const MatchingOptions& options) {
  const LocalFrame frame = patch_frame(patch);
  const auto [left, right] = patch_cameras(patch, frame);
  return match_views({left, images[0], segments[0]}, {right, images[1], segments[1]},
                     patch_heights_m(patch, frame), options);
}

std::string unmatched_csv(const MatchList& list) {
  std::string text = "left_id,reason\n";
  for (std::size_t i = 0; i < list.reasons.size(); ++i) {
    if (list.reasons[i] == "matched") continue;
    text += fmt::format("{},{}\n", i, list.reasons[i]);
  }
  return text;
}

}  // namespace ridgeline::apps
