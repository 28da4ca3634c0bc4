// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/files/judge_files.h"
#include "evaluate/files/run_record.h"

#include <pybind11/pybind11.h>

#include <vector>

namespace ridgeline::python {

/// The result of evaluate() for one set of lines, wrapped by ridgeline.Result.
struct Judged {
  results::JudgedFiles files;
  results::RunRecord record{"evaluate"};
  std::vector<results::InputFile> inputs{};

  [[nodiscard]] const evaluate::Evaluation& evaluation() const { return files.evaluations.front(); }
};

/// Adds the class `Judged`: figures as dicts and tables, and methods that write files.
void add_judged(pybind11::module_& core);

}  // namespace ridgeline::python
