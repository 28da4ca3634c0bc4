// SPDX-License-Identifier: BSD-3-Clause
#include "apps/pipeline/patch_matching.h"

#include "io/error.h"
#include "io/project/matches_file.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/core.h>

#include <variant>

namespace ridgeline::apps {
namespace {

std::vector<Segment2> in_image(const std::vector<EdgeSegment>& segments) {
  return transformed(segments, &EdgeSegment::in_image);
}

std::vector<evaluate::EdgeInBoth> edges_in_both(const std::vector<io::ReferenceEdge>& edges) {
  return transformed(edges, [&](const io::ReferenceEdge& edge) -> evaluate::EdgeInBoth {
    return {edge.left, edge.right, edge.is_wrong_pair};
  });
}

void check_id(const std::string& file,
              const char* column,
              int id,
              const std::vector<EdgeSegment>& segments) {
  if (id >= 0 && static_cast<std::size_t>(id) < segments.size()) return;
  throw io::IoError(
      file,
      fmt::format("{} = {}, must be in 0..{}: the image has {} segments. Guided "
                  "matches need the segments.IMAGE.csv of their run beside them",
                  column, id, static_cast<std::ptrdiff_t>(segments.size()) - 1, segments.size()));
}

}  // namespace

void check_segment_ids(const std::string& file,
                       std::span<const LineMatch> matches,
                       const std::array<std::vector<EdgeSegment>, 2>& segments) {
  for (const LineMatch& match : matches) {
    check_id(file, "left_id", match.left, segments[0]);
    check_id(file, "right_id", match.right, segments[1]);
  }
}

std::vector<LineMatch> read_line_matches(const std::string& file,
                                         const std::array<std::vector<EdgeSegment>, 2>& segments) {
  std::vector<LineMatch> matches;
  for (const FoundMatch& found : io::read_matches(file)) matches.push_back(found.scored.match);
  check_segment_ids(file, matches, segments);
  return matches;
}

std::optional<evaluate::MatchingScore> score_patch_matches(
    const io::PatchFile& patch,
    const std::array<std::vector<EdgeSegment>, 2>& segments,
    std::span<const LineMatch> matches) {
  if (!patch.reference_matches) return std::nullopt;
  const io::ReferenceMatches reference = io::read_reference_matches(*patch.reference_matches);
  if (const auto* pairs = std::get_if<std::vector<LineMatch>>(&reference)) {
    check_segment_ids(*patch.reference_matches, *pairs, segments);
    return evaluate::score_matches(matches, *pairs);
  }
  return evaluate::score_matches(
      in_image(segments[0]), in_image(segments[1]), matches,
      edges_in_both(std::get<std::vector<io::ReferenceEdge>>(reference)));
}

}  // namespace ridgeline::apps
