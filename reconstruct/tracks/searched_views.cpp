// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/tracks/searched_views.h"

#include "reconstruct/geometry/transformed.h"

#include <algorithm>
#include <tuple>

namespace ridgeline::reconstruct {

SearchedViews::SearchedViews(const Scene& scene, std::span<const MatchedPair> pairs)
    : scene_(scene), views_(scene.views.size()) {
  const auto centres = transformed(scene.views, [](const View& view) -> Eigen::Vector3d {
    return projection_centre(view.image_from_local).hnormalized();
  });
  for (std::size_t v = 0; v < views_.size(); ++v) {
    SearchedView& view = views_[v];
    view.lines = transformed(scene.views[v].segments, &EdgeSegment::line);
    view.index = BoxIndex2(ideal_segments(scene.views[v]));
    for (std::size_t w = 0; w < views_.size(); ++w) {
      view.to.emplace_back(scene.views[v].image_from_local, scene.views[w].image_from_local);
      view.matched.emplace_back(view.lines.size(), -1);
      if (w != v) view.others.push_back(w);
    }
    std::ranges::sort(view.others, {}, [&](std::size_t w) {
      return std::tuple((centres[w] - centres[v]).norm(), scene.views[w].id);
    });
  }
  for (const auto& [of_pair, matches] : pairs) {
    for (const Correspondence& match : matches) {
      views_[of_pair.base].matched[of_pair.search][static_cast<std::size_t>(match.base)] =
          match.other;
      views_[of_pair.search].matched[of_pair.base][static_cast<std::size_t>(match.other)] =
          match.base;
    }
  }
}

bool SearchedViews::shows(std::size_t view, const Eigen::Vector2d& x_px) const {
  const cv::Mat& image = scene_.views[view].image;
  return x_px.x() >= 0.0 && x_px.y() >= 0.0 && x_px.x() < image.cols && x_px.y() < image.rows;
}

EndStretches SearchedViews::stretches(const Observation& from, std::size_t to) const {
  const Segment2& s = line(from).segment;
  const EpipolarTransfer& transfer = views_[from.view].to[to];
  return {transfer.stretch(s.start), transfer.stretch(s.end)};
}

Segment3 SearchedViews::object_segment(const Observation& s,
                                       const Eigen::Vector2d& heights_m) const {
  const EpipolarTransfer& transfer = views_[s.view].to[s.view];
  const Segment2& segment = line(s).segment;
  return {transfer.object_point(segment.start, heights_m[0]),
          transfer.object_point(segment.end, heights_m[1])};
}

SearchedViews::MatchState SearchedViews::match_state(const Observation& a,
                                                     const Observation& b) const {
  const int matched_with_a = views_[a.view].matched[b.view][static_cast<std::size_t>(a.segment)];
  const int matched_with_b = views_[b.view].matched[a.view][static_cast<std::size_t>(b.segment)];
  if (matched_with_a == b.segment || matched_with_b == a.segment) return MatchState::kMatched;
  return matched_with_a >= 0 || matched_with_b >= 0 ? MatchState::kMatchedElsewhere
                                                    : MatchState::kUnknown;
}

}  // namespace ridgeline::reconstruct
