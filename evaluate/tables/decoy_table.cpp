// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/tables/decoy_table.h"

#include "evaluate/tables/format.h"
#include "evaluate/tables/text_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace ridgeline::evaluate {
namespace {

constexpr const char* kNote =
    "Lines were moved on purpose and judged again; the table shows how many would pass as correct. "
    "It does not show how many lines are wrong. height: up and down. across: in plan; a plane "
    "cannot detect a shift within itself, so most pass next to large roofs. match: along the rays "
    "of the first image, as a false match would.";

bool has_decoys(const Evaluation& evaluation) { return !evaluation.decoys.empty(); }

const DecoyFigure* find(const Evaluation& evaluation, DecoyKind kind, double distance_m) {
  const auto found = std::ranges::find_if(evaluation.decoys, [&](const DecoyFigure& d) {
    return d.kind == kind && d.distance_m == distance_m;
  });
  return found == evaluation.decoys.end() ? nullptr : &*found;
}

std::string decoy_cell(const DecoyFigure* figure) {
  if (figure == nullptr) return std::string(kNoValue);
  return fmt::format("{} ({})", percent(figure->share()), percent(figure->withheld_share()));
}

std::string interval_percent(const std::optional<Interval>& interval) {
  if (!interval) return std::string(kNoValue);
  return fmt::format("{} - {}", percent(interval->low), percent(interval->high));
}

}  // namespace

std::string decoys_to_terminal(std::span<const Evaluation> evaluations) {
  if (std::ranges::none_of(evaluations, has_decoys)) return "";
  std::vector<std::string> columns{"patch", "method", "moved"};
  for (const double distance_m : kDecoyDistances_m) {
    columns.push_back(fmt::format("{} m:", distance_m));
  }
  PrintedTable table(columns);
  for (const Evaluation& e : evaluations) {
    for (const DecoyKind kind : kDecoyKinds) {
      const bool has_kind = std::ranges::count(e.decoys, kind, &DecoyFigure::kind) > 0;
      if (!has_kind) continue;
      std::vector<std::string> row{e.patch, e.method, name(kind)};
      for (const double distance_m : kDecoyDistances_m) {
        row.push_back(decoy_cell(find(e, kind, distance_m)));
      }
      table.add_row(std::move(row));
    }
  }
  return captioned(fmt::format("Decoys that pass within {} m, % (not evaluated, %)", kRight_m),
                   table, Markup::kPlain) +
         paragraph(kNote, Markup::kPlain);
}

std::string decoys_to_markdown(const Evaluation& evaluation) {
  if (!has_decoys(evaluation)) return "";
  PrintedTable table({"decoys",
                      "moved by:", "lines:", "decoys:", fmt::format("within {} m %:", kRight_m),
                      "95 % interval:", "not evaluated %:"});
  for (const DecoyFigure& d : evaluation.decoys) {
    table.add(name(d.kind), fmt::format("{} m", d.distance_m), d.n_lines, d.n_decoys,
              percent(d.share()), interval_percent(d.ci95), percent(d.withheld_share()));
  }
  return table.text(Markup::kMarkdown) + "\n" + kNote + "\n";
}

std::string decoys_to_csv(std::span<const Evaluation> evaluations) {
  std::string text =
      "patch,method,kind,distance_m,n_lines,n_decoys,share,ci95_low,ci95_high,withheld_share,"
      "n_clusters\n";
  const auto number = [](std::optional<double> value) {
    constexpr int kCsvDecimals = 6;
    return fixed(value, kCsvDecimals, "");
  };
  for (const Evaluation& e : evaluations) {
    for (const DecoyFigure& d : e.decoys) {
      text +=
          fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", escape_csv(e.patch),
                      escape_csv(e.method), name(d.kind), d.distance_m, d.n_lines, d.n_decoys,
                      number(d.share()), number(d.ci95 ? std::optional(d.ci95->low) : std::nullopt),
                      number(d.ci95 ? std::optional(d.ci95->high) : std::nullopt),
                      number(d.withheld_share()), d.n_clusters);
    }
  }
  return text;
}

std::string following_note(const Evaluation& evaluation) {
  const std::optional<CloudFollowing>& f = evaluation.elsewhere;
  if (!f || !f->is_weak()) return "";
  return fmt::format(
      "{} % of the lines lie within {} m of the cloud's surfaces, and {} % of the same lines after "
      "moving them by 20 to 100 m in plan (difference {}, 95 % interval {} to {}, {} moves)",
      percent(f->share), kRight_m, percent(f->share_elsewhere), fixed(f->difference(), 2),
      fixed(f->ci95->low, 2), fixed(f->ci95->high, 2), f->n_pairs);
}

}  // namespace ridgeline::evaluate
