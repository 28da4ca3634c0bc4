// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/tables/table2.h"

#include "evaluate/tables/cells.h"
#include "evaluate/tables/format.h"
#include "evaluate/tables/shift_text.h"
#include "evaluate/tables/summary_json.h"
#include "evaluate/tables/table_layout.h"
#include "evaluate/tables/text_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

namespace ridgeline::evaluate {
namespace {

void append_new(std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

const Summary* find_cell(const Table2& table,
                         const std::string& patch,
                         const std::string& method,
                         const std::string& line_class) {
  for (const PatchMethodResult& result : table.results) {
    if (result.patch != patch || result.method != method) continue;
    if (const Summary* cell = find_class(result.classes, line_class)) return cell;
  }
  return nullptr;
}

std::string excluded_text(const Summary& s) {
  std::string text;
  for (std::size_t i = 0; i < s.n_by_status.size(); ++i) {
    const auto status = static_cast<Status>(i);
    if (status == Status::kEvaluated || s.n_by_status[i] == 0) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name(status), s.n_by_status[i]);
  }
  return text.empty() ? std::string(kNoValue) : text;
}

std::string published_form_markdown(const Table2& table) {
  const Table2Layout layout = lay_out(table);
  std::vector<std::string> columns{"patch"};
  for (const std::string& method : layout.methods) {
    for (const std::string& line_class : layout.classes) {
      columns.push_back(fmt::format("{} {}:", method, line_class));
    }
  }
  PrintedTable written(columns);
  for (const Table2Layout::LayoutRow& row : layout.rows) {
    std::vector<std::string> cells{row.patch};
    for (const Summary* cell : row.cells) cells.push_back(headline_text(cell));
    written.add_row(std::move(cells));
  }
  return written.text(Markup::kMarkdown);
}

std::string companions_markdown(const Table2& table) {
  PrintedTable written(
      {"patch", "method", "class", "n:", "evaluated %:", "RMS:", "95 % interval:", "clusters:",
       "bias:", "std:", "median:", "NMAD:", "68.3 %:", "95 %:", "max:",
       "lines with half of the squares:", "RMS without them:", "> gross limit %:", "excluded"});
  for (const PatchMethodResult& result : table.results) {
    for (const Summary& of_class : result.classes) {
      for (const auto& [class_name, s] : rows_of(of_class)) {
        written.add(result.patch, result.method, class_name, s.n_evaluated,
                    percent(s.evaluated_share()), metres(s.rms_m), interval_text(s), s.n_clusters,
                    metres(s.mean_m), metres(s.std_m), metres(s.median_m), metres(s.nmad_m),
                    metres(s.q683_m), metres(s.q95_m), metres(s.max_m), s.n_half_of_squares,
                    metres(s.rms_without_half_m), percent(s.gross_share), excluded_text(s));
      }
    }
  }
  return written.text(Markup::kMarkdown);
}

/// The table of the error components of ridges and hips with its caption; "" if there are none.
std::string parts_markdown(const Table2& table) {
  PrintedTable written(
      {"patch", "method", "class", "n:", "RMSE horizontal:", "RMSE vertical:", "mean vertical:"});
  for (const PatchMethodResult& result : table.results) {
    for (const Summary& s : result.classes) {
      if (s.n_parts == 0) continue;
      written.add(result.patch, result.method, s.line_class, s.n_parts, metres(s.rmse_horizontal_m),
                  metres(s.rmse_vertical_m), metres(s.mean_vertical_m));
    }
  }
  if (written.empty()) return "";
  return "Ridges and hips, from both planes: offset across in plan and in height. Shifts along a "
         "line cannot be observed.\n\n" +
         written.text(Markup::kMarkdown) + "\n";
}

/// Whether a result has the classes aligned and not_aligned. A result without lines has both, so it
/// is only considered if no result has lines.
bool has_classes(const Table2& table) {
  const auto is_empty = [](const PatchMethodResult& result) {
    const Summary* total = find_class(result.classes, kTotal);
    return total == nullptr || total->n_lines == 0;
  };
  const bool all_empty = std::all_of(table.results.begin(), table.results.end(), is_empty);
  return std::any_of(table.results.begin(), table.results.end(), [&](const auto& result) {
    return (all_empty || !is_empty(result)) && find_class(result.classes, kAligned) != nullptr;
  });
}

/// Why direct and joint differ on not_aligned lines; "" if they do not.
std::string_view faces_note(const Table2& table) {
  const auto has = [&](std::string_view method) {
    return std::ranges::any_of(table.results,
                               [&](const auto& result) { return result.method == method; });
  };
  if (!table.joint_adjusts_to_faces || !has("direct") || !has("joint")) return "";
  return "joint adjusts lines to the plane faces of the surface beside them (faces_beside); direct "
         "does not. Their not_aligned lines differ for this reason. With the published preset they "
         "are equal.";
}

/// Explains the figure after a + in a cell; "" if there is none.
std::string_view groups_note(const Table2& table) {
  const bool has_groups = std::ranges::any_of(table.results, [](const PatchMethodResult& result) {
    return std::ranges::any_of(result.classes,
                               [](const Summary& s) { return !s.by_group.empty(); });
  });
  if (!has_groups) return "";
  return " These are the lines whose surface was chosen by plan and images; those after the + were "
         "decided by points or the line's own position.";
}

/// The columns with the displacement of a result's lines; empty if they were not moved.
std::string moved_cells(const PatchMethodResult& result) {
  if (!result.moved_m) return ",,,";
  const Eigen::Vector3d& by_m = *result.moved_m;
  return fmt::format(",{},{},{}", metres(by_m.x()), metres(by_m.y()), metres(by_m.z()));
}

/// The footnote as a line starting with `before`; "" without a footnote.
std::string footnote_line(const Table2& table, std::string_view before) {
  const std::string note = footnote(table);
  return note.empty() ? "" : fmt::format("{}{}\n", before, note);
}

}  // namespace

Table2Layout lay_out(const Table2& table) {
  Table2Layout layout;
  std::vector<std::string> patches;
  for (const PatchMethodResult& result : table.results) {
    append_new(patches, result.patch);
    append_new(layout.methods, result.method);
  }
  if (has_classes(table)) layout.classes = {std::string(kNotAligned), std::string(kAligned)};
  layout.classes.emplace_back(kTotal);
  for (const std::string& patch : patches) {
    Table2Layout::LayoutRow row{patch, {}};
    for (const std::string& method : layout.methods) {
      for (const std::string& line_class : layout.classes) {
        row.cells.push_back(find_cell(table, patch, method, line_class));
      }
    }
    layout.rows.push_back(std::move(row));
  }
  return layout;
}

Table2 make_table2(std::span<const Evaluation> evaluations, bool joint_adjusts_to_faces) {
  Table2 table;
  table.joint_adjusts_to_faces = joint_adjusts_to_faces;
  table.moved = moved_notes(evaluations);
  for (const Evaluation& e : evaluations) {
    PatchMethodResult& result =
        table.results.emplace_back(PatchMethodResult{e.patch, e.method, e.classes});
    if (e.shift && e.shift->applied) result.moved_m = -e.shift->shift_m;
  }
  return table;
}

std::string footnote(const Table2& table) {
  std::vector<std::string> notes = table.moved;
  if (const std::string_view faces = faces_note(table); !faces.empty()) notes.emplace_back(faces);
  return fmt::format("{}", fmt::join(notes, " "));
}

std::string to_markdown(const Table2& table) {
  return fmt::format(
      "RMS of the lines' mean orthogonal distances in m (lines evaluated / all "
      "lines).{}\n\n{}{}\nMetres. Bias, std and NMAD refer to signed distances; median, quantiles "
      "and maximum to mean absolute distances.\n\n{}\n{}{}\n",
      groups_note(table), published_form_markdown(table), footnote_line(table, "\n"),
      companions_markdown(table), parts_markdown(table), kFixedSentence);
}

std::string to_csv(const Table2& table) {
  std::string text =
      "patch,method,class,n_lines,n_evaluated,rms_m,ci95_low_m,ci95_high_m,median_m,nmad_m,"
      "q95_m,n_plan_images,rms_plan_images_m,n_points_place,rms_points_place_m";
  const bool has_moved = std::ranges::any_of(
      table.results, [](const PatchMethodResult& result) { return result.moved_m.has_value(); });
  text += has_moved ? ",moved_x_m,moved_y_m,moved_z_m\n" : "\n";
  const auto number = [](std::optional<double> value_m) { return metres(value_m, ""); };
  for (const PatchMethodResult& result : table.results) {
    for (const Summary& s : result.classes) {
      const Summary of_images = s.of_group(DecidedGroup::kPlanImages);
      const Summary of_place = s.of_group(DecidedGroup::kPointsPlace);
      const std::optional<double> low = s.ci95_m ? std::optional(s.ci95_m->low) : std::nullopt;
      const std::optional<double> high = s.ci95_m ? std::optional(s.ci95_m->high) : std::nullopt;
      text += fmt::format(
          "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}{}\n", escape_csv(result.patch),
          escape_csv(result.method), escape_csv(s.line_class), s.n_lines, s.n_evaluated,
          number(s.rms_m), number(low), number(high), number(s.median_m), number(s.nmad_m),
          number(s.q95_m), of_images.n_evaluated, number(of_images.rms_m), of_place.n_evaluated,
          number(of_place.rms_m), has_moved ? moved_cells(result) : "");
    }
  }
  return text;
}

std::string parts_to_csv(const Table2& table) {
  std::string text =
      "patch,method,class,n_ridges,rmse_horizontal_m,rmse_vertical_m,mean_vertical_m\n";
  for (const PatchMethodResult& result : table.results) {
    for (const Summary& s : result.classes) {
      text +=
          fmt::format("{},{},{},{},{},{},{}\n", escape_csv(result.patch), escape_csv(result.method),
                      escape_csv(s.line_class), s.n_parts, metres(s.rmse_horizontal_m, ""),
                      metres(s.rmse_vertical_m, ""), metres(s.mean_vertical_m, ""));
    }
  }
  return text;
}

std::string to_json(const Table2& table) {
  Json rows = Json::array();
  for (const PatchMethodResult& result : table.results) {
    for (const Summary& s : result.classes) {
      Json row{{"patch", result.patch}, {"method", result.method}, {"class", s.line_class}};
      row.update(class_json(s));
      rows.push_back(std::move(row));
    }
  }
  const std::string note = footnote(table);
  return dump(Json{{"rows", std::move(rows)},
                   {"note", kFixedSentence},
                   {"footnote", note.empty() ? Json(nullptr) : Json(note)}});
}

std::string to_latex(const Table2& table) {
  const Table2Layout layout = lay_out(table);
  const std::size_t n_classes = layout.classes.size();
  std::string methods = "Patch";
  std::string classes;
  for (const std::string& method : layout.methods) {
    methods += fmt::format(" & \\multicolumn{{{}}}{{c}}{{{}}}", n_classes, escape_latex(method));
    for (const std::string& c : layout.classes) classes += " & " + escape_latex(c);
  }
  std::string text = fmt::format(
      "% RMS (m) of the mean orthogonal distances, in parentheses lines evaluated / all lines.{}\n"
      "% {}\n{}\\begin{{tabular}}{{l{}}}\n\\toprule\n{} \\\\\n{} \\\\\n\\midrule\n",
      groups_note(table), kFixedSentence, footnote_line(table, "% "),
      std::string(layout.methods.size() * n_classes, 'r'), methods, classes);
  for (const Table2Layout::LayoutRow& row : layout.rows) {
    text += escape_latex(row.patch);
    for (const Summary* cell : row.cells) text += " & " + headline_text(cell);
    text += " \\\\\n";
  }
  return text + "\\bottomrule\n\\end{tabular}\n";
}

}  // namespace ridgeline::evaluate
