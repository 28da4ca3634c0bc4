// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/patch_matchers.h"

#include "reconstruct/chio/combine_matches.h"
#include "reconstruct/match/match_pairwise.h"

#include <fmt/core.h>

#include <algorithm>

namespace ridgeline::apps {
namespace {

using reconstruct::MatchSource;

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

std::vector<ScoredMatch> scored_matches(const MatchList& list) {
  std::vector<ScoredMatch> matches;
  matches.reserve(list.rows.size());
  for (const io::MatchRow& row : list.rows) matches.push_back(row.scored);
  return matches;
}

/// A match that both have found is of "pairwise+chio".
MatchList combined(const std::vector<EdgeSegment>& left,
                   const MatchList& first,
                   const MatchList& second) {
  MatchList both{kBothMatchers, {}, first.reasons};
  for (const reconstruct::CombinedMatch& match :
       reconstruct::combine_matches(left, scored_matches(first), scored_matches(second))) {
    const std::string matcher = match.source == MatchSource::kFirst ? first.name
                                : match.source == MatchSource::kSecond
                                    ? second.name
                                    : first.name + "+" + second.name;
    both.rows.push_back({match.scored, matcher});
    both.reasons[static_cast<std::size_t>(match.scored.match.left)] = "matched";
  }
  return both;
}

}  // namespace

const char* name(Matcher matcher) { return matcher == Matcher::kPairwise ? "pairwise" : "chio"; }

void add_matcher_option(CLI::App& app, std::vector<std::string>& names) {
  app.add_option("--matcher", names, "of the line segments: pairwise, chio, or both: pairwise,chio")
      ->delimiter(',')
      ->check(CLI::IsMember({"pairwise", "chio"}))
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
      const reconstruct::MatchResult found =
          reconstruct::match_pairwise(left, right, height_range_in_local_m, options.pairwise);
      result.lists.push_back(
          {name(matcher), rows_of(found.matches, matcher), reasons_of(found.outcomes)});
    } else {
      result.chio = reconstruct::chio_match(left, right, height_range_in_local_m, options.chio,
                                            options.pairwise);
      result.lists.push_back({name(matcher), rows_of(matches_of(*result.chio), matcher),
                              reasons_of(result.chio->outcomes)});
    }
  }
  if (result.lists.size() == 2) {
    result.lists.push_back(combined(left.segments, result.lists[0], result.lists[1]));
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
