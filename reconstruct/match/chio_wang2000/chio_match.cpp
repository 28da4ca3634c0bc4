// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/chio_wang2000/chio_match.h"

#include "reconstruct/geometry/transformed.h"
#include "reconstruct/match/chio_wang2000/four_processes.h"
#include "reconstruct/match/chio_wang2000/linked_line.h"

#include <tbb/parallel_for.h>

namespace ridgeline::reconstruct {
namespace {

ChioLine line_of(int left_id,
                 const Acquired& acquired,
                 const CoreCandidates& candidates,
                 const SearchedPair& pair,
                 const ChioOptions& options,
                 const ChioExtensions& beyond) {
  const CoreCandidate& first = candidates.list[acquired.candidate];
  ChioLine line;
  line.match = {left_id, first.right, first.similarity};
  line.acquired = acquired;
  line.chain = first.chain;
  std::vector<int> links{first.right};
  for (const int c :
       linked_fragments(candidates, acquired.candidate, pair.right, options, beyond)) {
    links.push_back(candidates.list[c].right);
  }
  line.fragments.assign(links.begin() + 1, links.end());
  line.line = line_through_links(left_id, links, pair, candidates.gsd_m);
  return line;
}

}  // namespace

ChioResult chio_match(const StereoPair& pair,
                      const ChioOptions& options,
                      const CandidateOptions& candidate_options,
                      const ChioExtensions& beyond) {
  validate(options);
  const SearchedPair views = searched(pair);
  const std::vector<CoreCandidates> candidates =
      core_candidates(views, options, candidate_options, beyond);
  ProcessedSegments processed = four_processes(views, candidates, options, beyond);

  ChioResult result;
  result.outcomes = std::move(processed.outcomes);
  std::vector<int> acquired;
  for (std::size_t i = 0; i < processed.acquired.size(); ++i) {
    if (processed.acquired[i]) acquired.push_back(static_cast<int>(i));
  }
  result.lines.resize(acquired.size());
  tbb::parallel_for(std::size_t{0}, acquired.size(), [&](std::size_t k) {
    const int i = acquired[k];
    result.lines[k] = line_of(i, *processed.acquired[i], candidates[i], views, options, beyond);
  });
  return result;
}

std::vector<Correspondence> matches_of(const ChioResult& result) {
  return transformed(result.lines, &ChioLine::match);
}

}  // namespace ridgeline::reconstruct
