// SPDX-License-Identifier: BSD-3-Clause
#include "apps/gate/gate_files.h"

#include "apps/common/result_folder_reader.h"
#include "io/error.h"
#include "io/gates_file.h"

#include <optional>
#include <stdexcept>
#include <vector>

namespace ridgeline::apps {
namespace {

std::optional<evaluate::BaselineAllowance> allowance(
    const std::optional<io::GateEntry::Allowance>& entry) {
  if (!entry) return std::nullopt;
  return evaluate::BaselineAllowance{entry->value};
}

evaluate::Gate gate_of(const io::GateEntry& entry) {
  evaluate::Gate gate;
  gate.patch = entry.patch;
  gate.method = entry.method;
  if (entry.line_class) gate.line_class = *entry.line_class;
  if (entry.metric) gate.metric = *entry.metric;
  gate.max = entry.max;
  gate.min = entry.min;
  gate.max_ratio_to_class = entry.max_ratio_to_class;
  if (entry.ratio) gate.ratio = *entry.ratio;
  gate.max_increase_over_baseline = allowance(entry.max_increase_over_baseline);
  gate.max_decrease_below_baseline = allowance(entry.max_decrease_below_baseline);
  if (entry.n_min) gate.n_min = static_cast<std::size_t>(*entry.n_min);
  return gate;
}

}  // namespace

evaluate::GateReport apply_gate_files(const std::string& gates_file,
                                      const std::string& results_folder,
                                      const std::string& baseline_folder) {
  std::vector<evaluate::Gate> gates;
  for (const io::GateEntry& entry : io::read_gates_file(gates_file)) {
    gates.push_back(gate_of(entry));
  }
  const evaluate::ResultFolder results = read_result_folder(results_folder);
  try {
    if (baseline_folder.empty()) return evaluate::apply_gates(gates, results);
    const evaluate::ResultFolder baseline = read_result_folder(baseline_folder);
    return evaluate::apply_gates(gates, results, &baseline);
  } catch (const std::invalid_argument& error) {
    throw io::IoError(gates_file, error.what());
  }
}

}  // namespace ridgeline::apps
