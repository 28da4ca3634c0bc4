// SPDX-License-Identifier: BSD-3-Clause
#include "apps/report/line_observations.h"

#include "reconstruct/geometry/transformed.h"

#include <algorithm>
#include <charconv>
#include <set>

namespace ridgeline::apps {
namespace {

/// The id as an index; std::nullopt if it is not a number, because ids of other tools may be text.
std::optional<int> index_of(std::string_view id) {
  int index = 0;
  const auto [end, fault] = std::from_chars(id.data(), id.data() + id.size(), index);
  if (fault != std::errc() || end != id.data() + id.size() || index < 0) return std::nullopt;
  return index;
}

/// The track from which a line was made: track 17 for lines "17" and "17.2". nullptr if there is
/// none or its images are not those of the line.
const Track* track_of(const ReportPatch& patch, const io::Line& line) {
  const auto number = index_of(std::string_view(line.id).substr(0, line.id.find('.')));
  if (!patch.images || !number) return nullptr;
  const std::vector<Track>& tracks = patch.images->tracks;
  if (static_cast<std::size_t>(*number) >= tracks.size()) return nullptr;
  const Track& track = tracks[static_cast<std::size_t>(*number)];
  const bool is_same = std::ranges::equal(track.observations, line.observations,
                                          [&](const Observation& a, const io::LineObservation& b) {
                                            return patch.patch->images[a.view].id == b.image;
                                          });
  return is_same ? &track : nullptr;
}

std::vector<LineInImage> observations_of_pair(const io::Line& line) {
  std::vector<LineInImage> found;
  const auto add = [&](std::size_t view, const std::string& id, const auto& px) {
    const std::optional<int> segment = index_of(id);
    if (segment || px) found.push_back({view, segment, px});
  };
  add(0, line.base_id, line.base_px);
  add(1, line.other_id, line.other_px);
  return found;
}

const EdgeSegment* segment_of(const ReportImages& images, const LineInImage& seen) {
  const std::vector<EdgeSegment>& segments = images.segments[seen.view];
  const bool is_known = seen.segment && static_cast<std::size_t>(*seen.segment) < segments.size();
  return is_known ? &segments[static_cast<std::size_t>(*seen.segment)] : nullptr;
}

/// The state of a line in an image where it has a segment, with its offset if that can be computed.
LineInView observed(const ReportImages& images,
                    const ProjectionMatrix& camera,
                    const io::Line& line,
                    const std::optional<Segment3>& segment,
                    const LineInImage& seen) {
  if (!segment || !line.covariance_m2 || !seen.px) return {ViewOfLine::kObserved, {}};
  const EdgeSegment* own = segment_of(images, seen);
  const auto offset = offset_of(camera, *segment, *line.covariance_m2, *seen.px,
                                own == nullptr ? nullptr : &own->line);
  if (!offset) return {ViewOfLine::kObserved, {}};
  const bool differs = offset->offset_px > kMaxSigmas * offset->sigma_px;
  return {differs ? ViewOfLine::kDiffers : ViewOfLine::kAgrees, offset};
}

/// Whether `a` is off by more of its sigmas than `b`. The worst of several segments of a line in
/// one image represents all of them.
bool is_worse(const LineInView& a, const LineInView& b) {
  if (!a.offset || !b.offset) return b.offset.has_value() < a.offset.has_value();
  return a.offset->offset_px * b.offset->sigma_px > b.offset->offset_px * a.offset->sigma_px;
}

/// The images in which any line of the method has a segment.
std::set<std::size_t> used_views(const std::vector<std::vector<LineInImage>>& observations) {
  std::set<std::size_t> used;
  for (const auto& of_line : observations) {
    for (const LineInImage& seen : of_line) used.insert(seen.view);
  }
  return used;
}

}  // namespace

std::vector<LineInImage> observations_of(const ReportPatch& patch, const io::Line& line) {
  if (!patch.patch || line.observations.empty()) return observations_of_pair(line);
  const std::vector<io::PatchImage>& images = patch.patch->images;
  const Track* track = track_of(patch, line);
  std::vector<LineInImage> found;
  for (std::size_t i = 0; i < line.observations.size(); ++i) {
    const auto image = std::ranges::find(images, line.observations[i].image, &io::PatchImage::id);
    if (image == images.end()) continue;
    LineInImage& seen = found.emplace_back();
    seen.view = static_cast<std::size_t>(image - images.begin());
    seen.px = line.observations[i].px;
    if (track != nullptr && track->observations[i].segment >= 0)
      seen.segment = track->observations[i].segment;
  }
  return found;
}

std::vector<std::vector<LineInView>> lines_in_views(const ReportPatch& patch,
                                                    const ReportMethod& method) {
  if (!patch.images || patch.images->pictures.size() <= 2) return {};
  const std::size_t n_views = patch.images->pictures.size();
  const std::vector<std::vector<LineInImage>> observations =
      transformed(method.lines, [&](const std::optional<io::Line>& line) {
        return line ? observations_of(patch, *line) : std::vector<LineInImage>();
      });
  const std::set<std::size_t> used = used_views(observations);
  std::vector<std::vector<LineInView>> shown(method.lines.size());
  for (std::size_t view = 0; view < n_views; ++view) {
    const ProjectionMatrix camera = patch.image_from_local(view);
    const ImageField field(camera, patch.images->sizes_px[view], patch.surface_in_local);
    for (std::size_t i = 0; i < method.lines.size(); ++i) {
      if (!method.lines[i]) continue;
      std::optional<LineInView> worst;
      for (const LineInImage& seen : observations[i]) {
        if (seen.view != view) continue;
        const LineInView one =
            observed(*patch.images, camera, *method.lines[i], method.segments[i], seen);
        if (!worst || is_worse(one, *worst)) worst = one;
      }
      if (!worst) {
        worst = LineInView{
            method.segments[i] ? field.unobserved(*method.segments[i]) : ViewOfLine::kOutside, {}};
        if (worst->state != ViewOfLine::kOutside && !used.contains(view)) {
          worst->state = ViewOfLine::kNotUsed;
        }
      }
      shown[i].push_back(*worst);
    }
  }
  return shown;
}

}  // namespace ridgeline::apps
