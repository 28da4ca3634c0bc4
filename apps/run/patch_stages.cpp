// SPDX-License-Identifier: BSD-3-Clause
#include "apps/run/patch_stages.h"

#include "apps/common/patch_matching.h"
#include "apps/common/patch_views.h"
#include "apps/reconstruct/reconstruct_patch.h"
#include "io/atomic_file.h"
#include "io/matches_file.h"
#include "io/segments_file.h"

#include <fmt/core.h>

namespace ridgeline::apps {
namespace {

constexpr const char* kMatcher = "pairwise";

std::vector<LineMatch> read_line_matches(const std::string& path) {
  std::vector<LineMatch> matches;
  for (const io::MatchRow& row : io::read_matches(path)) matches.push_back(row.scored.match);
  return matches;
}

}  // namespace

PatchStages::PatchStages(const io::PatchFile& patch,
                         const RunOptions& options,
                         std::filesystem::path folder)
    : patch_(patch), options_(options), folder_(std::move(folder)), frame_(patch_frame(patch)) {}

std::vector<std::string> PatchStages::segment_files() const {
  return {fmt::format("segments.{}.csv", patch_.images[0].id),
          fmt::format("segments.{}.csv", patch_.images[1].id)};
}

std::vector<std::string> PatchStages::match_files() { return {"matches.csv", "unmatched.csv"}; }

std::string PatchStages::line_file(reconstruct::Method method) {
  return fmt::format("lines.{}.geojson", reconstruct::name(method));
}

std::vector<std::string> PatchStages::line_files(reconstruct::Method method) const {
  std::vector<std::string> files{line_file(method)};
  for (const io::LineFormatInfo& info : io::line_formats()) {
    const auto& wanted = options_.line_formats;
    if (info.format == io::LineFormat::kGeoJson ||
        std::find(wanted.begin(), wanted.end(), info.format) == wanted.end()) {
      continue;
    }
    files.push_back(fmt::format("lines.{}{}", reconstruct::name(method), info.extension));
  }
  return files;
}

std::string PatchStages::path(const std::string& file) const { return (folder_ / file).string(); }

const cv::Mat& PatchStages::image(std::size_t i) {
  if (images_[i].empty()) images_[i] = patch_image(patch_, i);
  return images_[i];
}

std::array<std::vector<EdgeSegment>, 2> PatchStages::segments() const {
  const std::vector<std::string> files = segment_files();
  return {io::read_segments(path(files[0])), io::read_segments(path(files[1]))};
}

void PatchStages::extract() {
  const std::vector<std::string> files = segment_files();
  for (std::size_t i = 0; i < 2; ++i) {
    io::write_segments(path(files[i]), extract_patch_image(patch_, i, image(i), options_.extract));
  }
}

void PatchStages::match() {
  const reconstruct::MatchResult result =
      match_patch(patch_, {image(0), image(1)}, segments(), options_.match);
  io::write_matches(path("matches.csv"), result.matches, kMatcher);
  std::string unmatched = "left_id,reason\n";
  for (std::size_t i = 0; i < result.outcomes.size(); ++i) {
    if (result.outcomes[i] == reconstruct::MatchOutcome::kMatched) continue;
    unmatched += fmt::format("{},{}\n", i, reconstruct::name(result.outcomes[i]));
  }
  io::write_file(path("unmatched.csv"), unmatched);
}

void PatchStages::reconstruct(reconstruct::Method method) const {
  const auto extracted = segments();
  const std::vector<LineMatch> matches = read_line_matches(path("matches.csv"));
  reconstruct::ReconstructOptions options = options_.reconstruct;
  options.method = method;
  const io::LineSet lines = reconstruct_patch(patch_, extracted, matches, options, options_.match);
  io::write_lines(path(line_file(method)), lines, io::LineFormat::kGeoJson);
  for (const io::LineFormat format : options_.line_formats) {
    for (const io::LineFormatInfo& info : io::line_formats()) {
      if (info.format != format || format == io::LineFormat::kGeoJson) continue;
      io::write_lines(path(fmt::format("lines.{}{}", reconstruct::name(method), info.extension)),
                      lines, format);
    }
  }
}

std::optional<evaluate::Table1Row> PatchStages::score_matches() const {
  const std::optional<evaluate::MatchingScore> score =
      score_patch_matches(patch_, segments(), read_line_matches(path("matches.csv")));
  if (!score) return std::nullopt;
  return evaluate::Table1Row{patch_.id, kMatcher, score->counts, score->n_unjudged};
}

}  // namespace ridgeline::apps
