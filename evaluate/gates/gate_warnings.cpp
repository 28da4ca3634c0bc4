// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/gates/gate_warnings.h"

#include "evaluate/statistics/calibration.h"
#include "evaluate/tables/shift_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace ridgeline::evaluate {
namespace {

void warn_of_calibration(const Evaluation& e, std::vector<std::string>& warnings) {
  std::vector<std::size_t> all(e.lines.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const Calibration c = calibrate(e.lines, all, std::string(kTotal), e.options.sigma_sys_m);
  if (!c.nees_per_dof || (*c.nees_per_dof >= 0.5 && *c.nees_per_dof <= 2.0)) return;
  const std::string why =
      *c.nees_per_dof < 1.0
          ? "the predicted sigmas are too large"
          : fmt::format(
                "the predicted sigmas are too small, or the {:.1f} % of the lines with |z| above "
                "3.29 were judged against a wrong surface (median z^2 {:.2f}, 0.455 expected)",
                100.0 * *c.share_beyond_99_9, *c.median_z2);
  warnings.push_back(
      fmt::format("patch {}, {}: mean NEES / dof = {:.3g} (n = {}), outside [0.5, 2]: {}", e.patch,
                  e.method, *c.nees_per_dof, c.n, why));
}

void warn_of_time(const ResultFolder& results,
                  const ResultFolder& baseline,
                  std::vector<std::string>& warnings) {
  constexpr double kMaxSlowdown = 2.0;
  if (!baseline.duration_s || !results.duration_s) return;
  if (*results.duration_s <= kMaxSlowdown * *baseline.duration_s) return;
  warnings.push_back(fmt::format("time {:.1f} s is more than twice the {:.1f} s of the baseline",
                                 *results.duration_s, *baseline.duration_s));
}

bool refers_to_baseline(const Gate& gate) {
  return gate.max_increase_over_baseline || gate.max_decrease_below_baseline;
}

}  // namespace

std::vector<std::string> gate_warnings(std::span<const Gate> gates,
                                       std::span<const GateResult> applied,
                                       const ResultFolder& results,
                                       const ResultFolder* baseline) {
  std::vector<std::string> warnings;
  for (const Evaluation& e : results.evaluations) {
    const bool is_gated = std::any_of(applied.begin(), applied.end(), [&](const GateResult& r) {
      return r.patch == e.patch && r.method == e.method;
    });
    if (!is_gated) continue;
    warn_of_calibration(e, warnings);
    if (std::string note = moved_note(e); !note.empty()) warnings.push_back(std::move(note));
  }
  if (baseline == nullptr) return warnings;
  warn_of_time(results, *baseline, warnings);
  if (std::none_of(gates.begin(), gates.end(), refers_to_baseline)) {
    warnings.emplace_back(
        "no gate refers to the baseline; nothing was compared with it (max_increase_over_baseline, "
        "max_decrease_below_baseline)");
  }
  return warnings;
}

}  // namespace ridgeline::evaluate
