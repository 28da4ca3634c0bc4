// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/tables/reference_table.h"

#include "evaluate/tables/format.h"
#include "evaluate/tables/text_table.h"

#include <fmt/core.h>

#include <optional>

namespace ridgeline::evaluate {
namespace {

constexpr int kDecimalsOfShare = 4;
constexpr int kRatioDecimals = 3;

std::optional<double> share_of(const ReferenceCompleteness& row) {
  if (row.n_lines == 0) return std::nullopt;
  return static_cast<double>(row.n_reconstructed) / static_cast<double>(row.n_lines);
}

std::string errors_markdown(const std::vector<ReferenceRow>& rows) {
  PrintedTable table({"patch", "method", "class", "lines:", "on a true line:", "RMS m:",
                      "median m:", "95 % m:", "max m:", "gross %:", "RMSE H m:", "RMSE V m:",
                      "mean V m:", "median NEES:", "beyond 99.9 %:"});
  for (const ReferenceRow& row : rows) {
    for (const ReferenceErrors& e : row.comparison.classes) {
      table.add(row.patch, row.method, e.line_class, e.n_lines, e.n_on_reference, metres(e.rms_m),
                metres(e.median_m), metres(e.q95_m), metres(e.max_m), percent(e.gross_share),
                metres(e.rmse_horizontal_m), metres(e.rmse_vertical_m), metres(e.mean_vertical_m),
                fixed(e.median_nees_ratio, 2), percent(e.nees_beyond_99_9_share));
    }
  }
  return table.text(Markup::kMarkdown);
}

std::string completeness_markdown(const std::vector<ReferenceRow>& rows) {
  PrintedTable table({"patch", "method", "kind", "true lines:", "reconstructed:", "%:"});
  for (const ReferenceRow& row : rows) {
    for (const ReferenceCompleteness& c : row.comparison.completeness) {
      table.add(row.patch, row.method, c.kind, c.n_lines, c.n_reconstructed, percent(share_of(c)));
    }
  }
  return table.text(Markup::kMarkdown);
}

std::string wireframe_markdown(const std::vector<ReferenceRow>& rows) {
  PrintedTable table({"patch", "method", "threshold m:", "edge precision %:", "recall %:", "F1 %:",
                      "corner precision %:", "recall %:", "F1 %:", "mean corner offset m:"});
  for (const ReferenceRow& row : rows) {
    for (const WireframeScore& w : row.wireframe) {
      table.add(row.patch, row.method, fmt::format("{:g}", w.threshold_m),
                percent(w.edges.precision()), percent(w.edges.recall()), percent(w.edges.f1()),
                percent(w.corners.precision()), percent(w.corners.recall()),
                percent(w.corners.f1()), metres(w.mean_corner_offset_m));
    }
  }
  return table.text(Markup::kMarkdown);
}

}  // namespace

std::string reference_errors_to_csv(const std::vector<ReferenceRow>& rows) {
  std::string text =
      "patch,method,class,n_lines,n_on_reference,rms_m,median_m,q95_m,max_m,gross_share,"
      "n_parts,rmse_horizontal_m,rmse_vertical_m,mean_vertical_m,n_tested,median_nees_ratio,"
      "nees_beyond_99_9_share\n";
  for (const ReferenceRow& row : rows) {
    for (const ReferenceErrors& e : row.comparison.classes) {
      text += fmt::format(
          "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", escape_csv(row.patch),
          escape_csv(row.method), e.line_class, e.n_lines, e.n_on_reference, metres(e.rms_m, ""),
          metres(e.median_m, ""), metres(e.q95_m, ""), metres(e.max_m, ""),
          fixed(e.gross_share, kDecimalsOfShare, ""), e.n_parts, metres(e.rmse_horizontal_m, ""),
          metres(e.rmse_vertical_m, ""), metres(e.mean_vertical_m, ""), e.n_tested,
          fixed(e.median_nees_ratio, kRatioDecimals, ""),
          fixed(e.nees_beyond_99_9_share, kDecimalsOfShare, ""));
    }
  }
  return text;
}

std::string reference_completeness_to_csv(const std::vector<ReferenceRow>& rows) {
  std::string text = "patch,method,kind,n_reference_lines,n_reconstructed,share\n";
  for (const ReferenceRow& row : rows) {
    for (const ReferenceCompleteness& c : row.comparison.completeness) {
      text += fmt::format("{},{},{},{},{},{}\n", escape_csv(row.patch), escape_csv(row.method),
                          escape_csv(c.kind), c.n_lines, c.n_reconstructed,
                          fixed(share_of(c), kDecimalsOfShare, ""));
    }
  }
  return text;
}

std::string wireframe_to_csv(const std::vector<ReferenceRow>& rows) {
  std::string text =
      "patch,method,what,threshold_m,n_found,n_true,n_matched,precision,recall,f1,mean_offset_m\n";
  for (const ReferenceRow& row : rows) {
    for (const WireframeScore& w : row.wireframe) {
      const auto add = [&](const char* what, const DetectionScore& d,
                           std::optional<double> offset_m) {
        text += fmt::format("{},{},{},{:g},{},{},{},{},{},{},{}\n", escape_csv(row.patch),
                            escape_csv(row.method), what, w.threshold_m, d.n_found, d.n_true,
                            d.n_matched, fixed(d.precision(), kDecimalsOfShare, ""),
                            fixed(d.recall(), kDecimalsOfShare, ""),
                            fixed(d.f1(), kDecimalsOfShare, ""), metres(offset_m, ""));
      };
      add("edges", w.edges, std::nullopt);
      add("corners", w.corners, w.mean_corner_offset_m);
    }
  }
  return text;
}

std::string reference_to_markdown(const std::vector<ReferenceRow>& rows) {
  return "Mean distance from the true line of both image segments; RMSE across it in plan (H) and "
         "in height at the same place in plan (V). NEES: squared error of the ends over the stated "
         "covariance, median relative to its expectation (1), and the share beyond the 99.9 % "
         "limit (0.1).\n\n" +
         errors_markdown(rows) +
         "\nTrue lines visible in both images, reconstructed over half of their length within 0.3 "
         "m.\n\n" +
         completeness_markdown(rows) +
         "\nThe lines as a wireframe: corners (ends of lines) and edges (both ends) matched one to "
         "one to true ones.\n\n" +
         wireframe_markdown(rows);
}

}  // namespace ridgeline::evaluate
