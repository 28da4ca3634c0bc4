// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/tables/accuracy_table.h"

#include "evaluate/tables/cells.h"
#include "evaluate/tables/format.h"
#include "evaluate/tables/table2.h"
#include "evaluate/tables/text_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace ridgeline::evaluate {
namespace {

std::string flags_text(const AccuracyStatement& statement) {
  const std::vector<std::string> flags = statement.flags();
  return flags.empty() ? std::string(kNoValue) : fmt::format("{}", fmt::join(flags, ", "));
}

/// The figures in the style of ASPRS Edition 2 (RMSE) and of NSSDA (1.9600 RMSE, its factor for
/// heights, because a distance is one-dimensional); "" if there is no RMSE.
std::string style_sentence(const AccuracyStatement& total) {
  constexpr double kNssdaVertical = 1.9600;
  const std::optional<double> rmse_m = total.numbers.product_m;
  if (!rmse_m) return "";
  return fmt::format(
      "In the style of ASPRS Edition 2: RMSE {} m including the error of the reference, from {} "
      "lines{}. In the style of NSSDA: {} m at 95 % (1.9600 RMSE).\n",
      metres(rmse_m), total.n, total.few_samples ? ", fewer than the 30 it requires" : "",
      metres(kNssdaVertical * *rmse_m));
}

std::string strata_table(const Stratification& stratification) {
  PrintedTable table({stratification.by, "n / lines:", "RMS:", "95 % interval:", "NMAD:", "95 %:",
                      "NEES / dof:", "median z2:", "|z| <= 1.96 %:", "|z| > 3.29 %:"});
  for (const Stratum& stratum : stratification.strata) {
    const Summary& s = stratum.summary;
    table.add(s.line_class, fmt::format("{} / {}", s.n_evaluated, s.n_lines), metres(s.rms_m),
              interval_text(s), metres(s.nmad_m), metres(s.q95_m),
              fixed(stratum.calibration.nees_per_dof, 2), fixed(stratum.calibration.median_z2, 2),
              percent(stratum.calibration.coverage_1_96),
              percent(stratum.calibration.share_beyond_99_9));
  }
  return table.text(Markup::kMarkdown);
}

}  // namespace

std::string to_markdown(std::span<const AccuracyStatement> statements) {
  PrintedTable table(
      {"class", "n:", "observed (against the planes):", "product (true datum):", "method only:",
       "sigma of the reference:", "lines with half of the squares:", "RMS without them:", "flags"});
  for (const AccuracyStatement& s : statements) {
    const std::string method_only = s.numbers.below_reference_noise
                                        ? std::string("below reference noise")
                                        : metres(s.numbers.method_only_m);
    table.add(s.line_class, s.n, metres(s.numbers.observed_m), metres(s.numbers.product_m),
              method_only, metres(s.numbers.sigma_ref_m), s.n_half_of_squares,
              metres(s.rms_without_half_m), flags_text(s));
  }
  std::string text = fmt::format("{}\n{}\n", table.text(Markup::kMarkdown), kFixedSentence);
  if (!statements.empty()) text += fmt::format("\n{}", style_sentence(statements.back()));
  return text;
}

std::string to_markdown(std::span<const Stratification> stratifications) {
  std::string text;
  for (const Stratification& s : stratifications) text += strata_table(s) + "\n";
  return text;
}

}  // namespace ridgeline::evaluate
