// SPDX-License-Identifier: BSD-3-Clause
#include "apps/python/bindings.h"
#include "apps/python/in_memory.h"
#include "apps/python/judged.h"
#include "evaluate/files/gate_files.h"
#include "evaluate/files/result_folder_reader.h"
#include "evaluate/gates/gate_report.h"

#include <fmt/chrono.h>

#include <ctime>
#include <optional>
#include <string>
#include <vector>

namespace ridgeline::python {
namespace py = pybind11;
namespace {

evaluate::ResultFolder result_folder(const py::object& results) {
  if (py::isinstance<py::str>(results)) {
    return results::read_result_folder(results.cast<std::string>());
  }
  evaluate::ResultFolder folder;
  folder.name = "result";
  folder.is_of_line_files = true;
  folder.evaluations = {results.cast<const Judged&>().evaluation()};
  return folder;
}

/// Applies gates to results. The gates come from `gates_text`, or from `gates_file` if the text is
/// empty. `results`, `baseline`: folder or Judged.
py::dict gate(const py::object& results,
              const std::string& gates_file,
              const std::string& gates_text,
              const py::object& baseline) {
  const std::vector<evaluate::Gate> gates = gates_text.empty()
                                                ? results::read_gates(gates_file)
                                                : results::parse_gates(gates_text, kGatesInMemory);
  const evaluate::ResultFolder folder = result_folder(results);
  std::optional<evaluate::ResultFolder> before;
  if (!baseline.is_none()) before = result_folder(baseline);
  const evaluate::GateReport report =
      evaluate::apply_gates(gates, folder, before ? &*before : nullptr);
  const std::string now = fmt::format("{:%FT%T}", fmt::gmtime(std::time(nullptr)));
  py::dict d;
  d["passed"] = report.passed();
  d["json"] = evaluate::to_json(report);
  d["junit"] = evaluate::to_junit(report, now);
  d["markdown"] = evaluate::to_markdown(report);
  d["text"] = evaluate::to_terminal(report);
  return d;
}

}  // namespace

void add_gates(py::module_& core) {
  core.def("gate", &gate, py::arg("results"), py::arg("gates_file"), py::arg("gates_text"),
           py::arg("baseline"));
}

}  // namespace ridgeline::python
