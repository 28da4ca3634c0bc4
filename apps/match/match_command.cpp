// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/command.h"
#include "apps/common/exit_code.h"
#include "apps/common/option_flags.h"
#include "apps/common/patch_views.h"
#include "apps/match/match_overlay.h"
#include "io/matches_file.h"
#include "io/png_writer.h"
#include "reconstruct/match/match_pairwise.h"

#include <fmt/core.h>

#include <map>
#include <memory>

namespace ridgeline::apps {
namespace {

struct MatchArguments {
  std::string patch;
  std::string out;
  std::string overlay;
  reconstruct::ExtractOptions extract;
  reconstruct::MatchOptions match;
};

void print_summary(const PatchViews& patch, const reconstruct::MatchResult& result) {
  std::map<reconstruct::MatchOutcome, int> n;
  for (const reconstruct::MatchOutcome outcome : result.outcomes) ++n[outcome];
  fmt::print("{} segments in the left, {} in the right image\n", patch.views[0].segments.size(),
             patch.views[1].segments.size());
  for (const auto& [outcome, count] : n) {
    fmt::print("  {:<13}{}\n", reconstruct::name(outcome), count);
  }
}

int run_match(const MatchArguments& a) {
  const PatchViews patch = load_patch_views(io::read_patch(a.patch), a.extract);
  const reconstruct::MatchResult result = reconstruct::match_pairwise(
      patch.views[0], patch.views[1], patch.height_range_in_local_m, a.match);
  io::write_matches(a.out, result.matches, "pairwise");
  if (!a.overlay.empty()) {
    io::write_png(a.overlay, match_overlay(patch.views[0], patch.views[1], result));
  }
  print_summary(patch, result);
  return kDone;
}

}  // namespace

Run add_match(CLI::App& subcommand) {
  auto a = std::make_shared<MatchArguments>();
  subcommand.add_option("patch", a->patch, "patch file (YAML)")->required();
  subcommand
      .add_option("--out", a->out,
                  "CSV: left_id,right_id,score,votes,matcher; ids count the segments of each image")
      ->required();
  subcommand.add_option("--overlay", a->overlay, "PNG of both images with the matched segments");
  add_flags(subcommand, a->match, "Matching");
  add_flags(subcommand, a->extract, "Extraction");
  return [a] { return run_match(*a); };
}

}  // namespace ridgeline::apps
