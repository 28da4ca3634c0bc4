// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/tables/tolerance_table.h"

#include "evaluate/tables/format.h"
#include "evaluate/tables/text_table.h"

#include <fmt/core.h>

namespace ridgeline::evaluate {
namespace {

constexpr int kRatioDecimals = 3;
constexpr int kToleranceDecimals = 3;

}  // namespace

std::string tolerances_to_csv(const std::vector<ToleranceRow>& rows) {
  std::string text =
      "patch,method,reference,tolerance_m,precision,completeness,f_score,redundancy,limap_r_m,"
      "limap_p_percent\n";
  for (const ToleranceRow& row : rows) {
    const ToleranceMeasures& m = row.measures;
    text += fmt::format(
        "{},{},{},{},{},{},{},{},{},{}\n", escape_csv(row.patch), escape_csv(row.method),
        row.reference, fixed(m.tolerance_m, kToleranceDecimals),
        fixed(m.precision, kRatioDecimals, ""), fixed(m.completeness, kRatioDecimals, ""),
        fixed(m.f_score, kRatioDecimals, ""), fixed(m.redundancy, kRatioDecimals, ""),
        metres(m.limap_r_m), fixed(m.limap_p_percent, 1, ""));
  }
  return text;
}

std::string tolerances_to_markdown(const std::vector<ToleranceRow>& rows) {
  PrintedTable table({"patch", "method", "against", "tolerance m:", "precision:", "completeness:",
                      "F:", "redundancy:", "R m:", "P:"});
  for (const ToleranceRow& row : rows) {
    const ToleranceMeasures& m = row.measures;
    table.add(row.patch, row.method, row.reference, fixed(m.tolerance_m, kToleranceDecimals),
              percent(m.precision), percent(m.completeness), percent(m.f_score),
              fixed(m.redundancy, kRatioDecimals), metres(m.limap_r_m),
              fixed(m.limap_p_percent, 1));
  }
  return "Length-weighted, in percent; R and P as defined by LIMAP.\n\n" +
         table.text(Markup::kMarkdown);
}

}  // namespace ridgeline::evaluate
