// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/check_pair.h"
#include "apps/common/command.h"
#include "apps/common/exit_code.h"
#include "apps/common/image_options.h"
#include "apps/common/parameters.h"
#include "apps/common/patch_matchers.h"
#include "apps/common/patch_views.h"
#include "apps/common/say.h"
#include "apps/match/match_overlay.h"
#include "io/atomic_file.h"
#include "io/matches_file.h"
#include "io/png_writer.h"
#include "io/results/output_folder.h"

#include <algorithm>
#include <map>
#include <memory>

namespace ridgeline::apps {
namespace {

struct MatchArguments {
  std::string patch;
  std::string out;
  std::string overlay;
  std::string provenance;
  ParameterArguments parameters;
  double max_image_mpx = 0.0;
  double max_y_parallax_px = kDefaultMaxYParallax_px;
  std::vector<std::string> matchers{"pairwise"};
  reconstruct::Options options;  ///< as the parameters say
};

void print_summary(const reconstruct::StereoPair& pair, const reconstruct::Matches& result) {
  say("{} segments in the left, {} in the right image\n", pair.views[0].segments.size(),
      pair.views[1].segments.size());
  for (const reconstruct::MatchList& list : result.lists) {
    std::map<std::string, int> n;
    for (const std::string& reason : list.reasons) ++n[reason];
    if (result.lists.size() > 1) say("{}:\n", list.name);
    for (const auto& [reason, count] : n) say("  {:<21}{}\n", reason, count);
  }
}

/// As Chio and Wang 2000 count: by the first two processes, then with the looser ones.
void print_processes(const reconstruct::ChioResult& result,
                     const reconstruct::ChioOptions& options) {
  const auto count = [&](auto holds) {
    return std::count_if(result.lines.begin(), result.lines.end(),
                         [&](const reconstruct::ChioLine& line) { return holds(line.acquired); });
  };
  using reconstruct::Acquired;
  say("lines of chio by process:\n");
  say("  1 and 2              {}\n", count([](const Acquired& a) { return a.process <= 2; }));
  say("  then 3 and 4         {}\n",
      count([](const Acquired& a) { return a.process > 2 && !a.relaxed; }));
  say("  relaxed to {:<5} m   {}\n", options.relaxed_height_difference_m,
      count([](const Acquired& a) { return a.relaxed; }));
}

/// Neither inputs nor each other, and all of them can be made.
void check_outputs(const MatchArguments& a, const io::PatchFile& patch) {
  std::vector<std::string> others = results::paths_of(input_files(patch));
  for (const std::string& file : {a.out, a.overlay, a.provenance}) {
    if (!file.empty()) others.push_back(results::output_file(file, others));
  }
  results::check_is_own(a.out, "left_id,right_id,score,", "table of matches");
  results::check_is_own(a.provenance, "left_id,right_id,linked_right_ids,",
                        "table of lines of chio");
  results::check_is_png("--overlay", a.overlay);
  const std::vector<reconstruct::Matcher>& matchers = a.options.matching.matchers;
  check(a.provenance.empty() || std::find(matchers.begin(), matchers.end(),
                                          reconstruct::Matcher::kChio) != matchers.end(),
        "provenance: lines of pairwise have none; needs --matcher chio");
}

int run_match(MatchArguments a) {
  a.options = read_parameters(a.parameters).method;
  a.options.matching.matchers = matchers_named(a.matchers);
  io::PatchFile file = io::read_patch(a.patch);
  file.max_image_mpx = a.max_image_mpx;
  check_outputs(a, file);
  const reconstruct::StereoPair pair = load_pair(file, a.options.extraction, a.max_y_parallax_px);
  const reconstruct::Matches result = reconstruct::match(pair, a.options.matching);
  io::write_matches(a.out, result.used().matches);
  if (!a.provenance.empty()) {
    io::write_file(a.provenance, chio_csv(*result.chio, patch_frame(file)));
  }
  if (!a.overlay.empty()) {
    io::write_png(a.overlay, match_overlay(pair.views[0], pair.views[1], result.used().matches));
  }
  print_summary(pair, result);
  if (result.chio) print_processes(*result.chio, a.options.matching.chio);
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
  add_matcher_option(subcommand, a->matchers);
  subcommand.add_option("--provenance", a->provenance,
                        "CSV of the lines of chio: process, neighbour and height of each");
  add_pair_check_option(subcommand, a->max_y_parallax_px);
  add_image_size_option(subcommand, a->max_image_mpx);
  add_preset_option(subcommand, a->parameters.preset);
  add_config_option(subcommand, a->parameters.config);
  return [a] { return run_match(*a); };
}

}  // namespace ridgeline::apps
