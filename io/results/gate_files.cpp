// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/gate_files.h"

#include "io/error.h"
#include "io/project/gates_file.h"
#include "io/results/result_folder_reader.h"

#include <fmt/core.h>

#include <stdexcept>
#include <vector>

namespace ridgeline::results {
namespace {

evaluate::DecidedGroup decided_group_named(const std::string& text) {
  for (const evaluate::DecidedGroup group : evaluate::kDecidedGroups) {
    if (text == name(group)) return group;
  }
  throw std::invalid_argument("decided_by: " + text + "; must be plan_images or points_place");
}

evaluate::Gate gate_of(const io::GateEntry& entry) {
  evaluate::Gate gate;
  gate.patch = entry.patch;
  gate.method = entry.method;
  if (entry.line_class) gate.line_class = *entry.line_class;
  gate.n_images = entry.n_images;
  if (entry.decided_by) gate.decided_by = decided_group_named(*entry.decided_by);
  gate.within_m = entry.within_m;
  if (entry.metric) gate.metric = *entry.metric;
  gate.kind = entry.kind;
  gate.distance_m = entry.distance_m;
  if (entry.bound == name(evaluate::GateBound::kUpper95))
    gate.bound = evaluate::GateBound::kUpper95;
  gate.max = entry.max;
  gate.min = entry.min;
  gate.max_ratio_to_class = entry.max_ratio_to_class;
  if (entry.ratio) gate.ratio = *entry.ratio;
  if (entry.max_increase_over_baseline) {
    gate.max_increase_over_baseline =
        evaluate::BaselineIncrease{entry.max_increase_over_baseline->value};
  }
  gate.max_decrease_below_baseline = entry.max_decrease_below_baseline;
  if (entry.n_min) gate.n_min = static_cast<std::size_t>(*entry.n_min);
  return gate;
}

std::vector<evaluate::Gate> gates_of(const std::vector<io::GateEntry>& entries,
                                     const std::string& file) {
  std::vector<evaluate::Gate> gates;
  for (const io::GateEntry& entry : entries) {
    try {
      gates.push_back(gate_of(entry));
      validate(gates.back());
    } catch (const std::invalid_argument& error) {
      throw io::IoError(file, fmt::format("line {}: {}", entry.line, error.what()));
    }
  }
  return gates;
}

}  // namespace

std::vector<evaluate::Gate> read_gates(const std::string& file) {
  return gates_of(io::read_gates_file(file), file);
}

std::vector<evaluate::Gate> parse_gates(const std::string& content, const std::string& name) {
  return gates_of(io::parse_gates(content, name), name);
}

evaluate::GateReport apply_gate_files(const std::string& gates_file,
                                      const std::string& results_folder,
                                      const std::string& baseline_folder) {
  const std::vector<evaluate::Gate> gates = read_gates(gates_file);
  const evaluate::ResultFolder results = read_result_folder(results_folder);
  if (baseline_folder.empty()) return evaluate::apply_gates(gates, results);
  const evaluate::ResultFolder baseline = read_result_folder(baseline_folder);
  return evaluate::apply_gates(gates, results, &baseline);
}

}  // namespace ridgeline::results
