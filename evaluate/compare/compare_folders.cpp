// SPDX-License-Identifier: BSD-3-Clause
// Selects what to compare in results folders, and whether it got worse.
#include "evaluate/compare/comparison.h"
#include "evaluate/statistics/product_method.h"
#include "reconstruct/geometry/check.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace ridgeline::evaluate {
namespace {

const Evaluation* counterpart(const Evaluation& e,
                              const ResultFolder& of,
                              const ResultFolder& other) {
  const auto of_patch = [&](const ResultFolder& folder) {
    std::vector<const Evaluation*> found;
    for (const Evaluation& x : folder.evaluations) {
      if (x.patch == e.patch) found.push_back(&x);
    }
    return found;
  };
  const auto same =
      std::find_if(other.evaluations.begin(), other.evaluations.end(),
                   [&](const Evaluation& x) { return x.patch == e.patch && x.method == e.method; });
  if (same != other.evaluations.end()) return &*same;
  const std::vector<const Evaluation*> own = of_patch(of);
  const std::vector<const Evaluation*> others = of_patch(other);
  if (own.size() == 1 && others.size() == 1) return others[0];
  // runs without a common method are compared by their main results
  const bool share_a_method = std::ranges::any_of(own, [&](const Evaluation* x) {
    return std::ranges::find(others, x->method, &Evaluation::method) != others.end();
  });
  if (share_a_method || others.empty() || of.is_of_line_files || other.is_of_line_files ||
      own[product_index(own, &Evaluation::method)] != &e)
    return nullptr;
  return others[product_index(others, &Evaluation::method)];
}

/// Whether `joint` may have adjusted lines to faces. This is assumed for a run with unknown
/// options, so that a difference from direct does not count as a defect.
bool may_adjust_to_faces(const ResultFolder& folder) {
  return folder.joint_adjusts_to_faces.value_or(true);
}

std::optional<std::size_t> n_views_of(const ResultFolder& folder, const std::string& patch) {
  const auto found = folder.n_views.find(patch);
  return found == folder.n_views.end() ? std::nullopt : std::optional(found->second);
}

/// Whether lines with the same id were reconstructed from the same segments.
bool have_same_ids(const ResultFolder& a, const ResultFolder& b, const std::string& patch) {
  const auto of_a = a.id_hashes.find(patch);
  const auto of_b = b.id_hashes.find(patch);
  return of_a != a.id_hashes.end() && of_b != b.id_hashes.end() && of_a->second == of_b->second &&
         n_views_of(a, patch) == n_views_of(b, patch);
}

/// Whether the positions of the lines are known; older folders only contain those of lines from
/// images.
bool are_placed(const Evaluation& e) {
  return std::ranges::all_of(e.lines, [](const LineEvaluation& line) {
    return line.status != Status::kEvaluated || line.segment;
  });
}

void compare_with_first(const ResultFolder& first,
                        const ResultFolder& other,
                        ComparisonReport& report) {
  if (first.input_hashes != other.input_hashes) {
    report.warnings.push_back(other.name + ": its input hashes differ from those of " + first.name +
                              "; the figures include the differences of the data");
  }
  for (const Evaluation& a : first.evaluations) {
    const Evaluation* b = counterpart(a, first, other);
    if (b == nullptr) {
      report.warnings.push_back(other.name + ": nothing to compare with patch " + a.patch + ", " +
                                a.method + " of " + first.name);
      continue;
    }
    std::string name_a = first.name + " " + a.method;
    std::string name_b = other.name + " " + b->method;
    if (!have_same_ids(first, other, a.patch) && are_placed(a) && are_placed(*b)) {
      Comparison& c = report.comparisons.emplace_back(
          compare_in_space(a, *b, std::move(name_a), std::move(name_b)));
      c.n_views_a = n_views_of(first, a.patch);
      c.n_views_b = n_views_of(other, a.patch);
      if (c.n_views_a == c.n_views_b) c.n_views_a = c.n_views_b = std::nullopt;
      continue;
    }
    report.comparisons.push_back(compare(a, *b, std::move(name_a), std::move(name_b),
                                         may_adjust_to_faces(first) || may_adjust_to_faces(other)));
  }
}

}  // namespace

ComparisonReport compare_folders(std::span<const ResultFolder> folders) {
  check(folders.size() >= 2, "compare: ", folders.size(), " result folder; at least 2 are needed");
  ComparisonReport report;
  for (const ResultFolder& other : folders.subspan(1)) {
    compare_with_first(folders.front(), other, report);
  }
  check(!report.comparisons.empty(), "compare: no patch of ", folders.front().name,
        " is in another folder; folders must share a patch and a method");
  return report;
}

std::vector<Comparison> compare_methods(const ResultFolder& folder) {
  std::map<std::string, const Evaluation*> first_of_patch;
  std::vector<Comparison> result;
  for (const Evaluation& e : folder.evaluations) {
    const Evaluation* first = first_of_patch.try_emplace(e.patch, &e).first->second;
    if (first == &e) continue;
    const bool in_space = folder.is_of_line_files && are_placed(*first) && are_placed(e);
    result.push_back(
        in_space ? compare_in_space(*first, e, first->method, e.method)
                 : compare(*first, e, first->method, e.method, may_adjust_to_faces(folder)));
  }
  return result;
}

std::vector<WorseFigure> worse_figures(
    const ComparisonReport& report,
    const std::function<std::optional<double>(const Summary&)>& figure,
    bool more_is_better,
    double margin) {
  constexpr double kRounding = 1e-12;
  std::vector<WorseFigure> worse;
  for (const Comparison& c : report.comparisons) {
    const auto of_all = [&](const std::vector<Summary>& own) {
      const Summary* const total = find_class(own, kTotal);
      return total ? figure(*total) : std::nullopt;
    };
    const std::optional<double> a = of_all(c.own_a), b = of_all(c.own_b);
    if (!a) continue;
    const double loss = b ? (more_is_better ? *a - *b : *b - *a) : HUGE_VAL;
    if (loss > margin + kRounding) worse.push_back({c.patch, c.name_a, c.name_b, *a, b});
  }
  return worse;
}

}  // namespace ridgeline::evaluate
