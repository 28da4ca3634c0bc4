// SPDX-License-Identifier: BSD-3-Clause
#include "apps/block/patch_table.h"

#include "io/text/text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace ridgeline::apps {
namespace {

std::string figure(const std::optional<double>& value) {
  return value ? fmt::format("{:.4f}", *value) : "";
}

/// A text that may contain commas and quotes, as a CSV field.
std::string csv_field(std::string text) {
  std::size_t at = 0;
  while ((at = text.find('"', at)) != std::string::npos)
    text.insert(std::exchange(at, at + 2), "\"");
  std::ranges::replace(text, '\n', ' ');
  return text.empty() ? "" : '"' + text + '"';
}

}  // namespace

std::string patches_csv(const BlockPlan& plan,
                        const std::string& method,
                        const std::vector<PatchOutcome>& outcomes,
                        bool with_header) {
  std::string text;
  if (with_header) {
    text =
        "patch,method,x_min_m,y_min_m,x_max_m,y_max_m,n_images,images,low_m,high_m,status,n_lines,"
        "n_evaluated,rms_m,median_m,max_m,n_reference_lines,n_reference_found,reason\n";
  }
  for (std::size_t i = 0; i < plan.patches.size(); ++i) {
    const PlannedPatch& p = plan.patches[i];
    const PatchOutcome& o = outcomes[i];
    text += fmt::format(
        "{},{},{:.3f},{:.3f},{:.3f},{:.3f},{},{},{:.2f},{:.2f},{},{},{},{},{},{},{},{},{}\n", p.id,
        method, p.core_m.min().x(), p.core_m.min().y(), p.core_m.max().x(), p.core_m.max().y(),
        p.images.size(), csv_field(fmt::format("{}", fmt::join(p.images, " "))),
        p.height_range_m[0], p.height_range_m[1], o.reason.empty() ? "done" : "failed", o.n_lines,
        o.n_evaluated, figure(o.rms_m), figure(o.median_m), figure(o.max_m), o.n_reference_lines,
        o.n_reference_found, csv_field(o.reason));
  }
  return text;
}

}  // namespace ridgeline::apps
