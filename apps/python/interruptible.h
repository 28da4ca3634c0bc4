// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/interruption.h"

#include <pybind11/pybind11.h>

#include <chrono>
#include <future>
#include <type_traits>
#include <utility>

namespace ridgeline::python {

/// Does the work in a thread of its own without the GIL, so that Python's other threads go on and its signal handlers
/// run: Ctrl-C stops the work and raises KeyboardInterrupt. The work must not touch Python's objects.
template <typename Work>
std::invoke_result_t<Work> interruptibly(Work&& work) {
  namespace py = pybind11;
  constexpr std::chrono::milliseconds kBetweenLooks{50};
  const py::gil_scoped_release release;
  auto result = std::async(std::launch::async, std::forward<Work>(work));
  while (result.wait_for(kBetweenLooks) != std::future_status::ready) {
    const py::gil_scoped_acquire acquire;
    if (PyErr_CheckSignals() == 0) continue;
    const py::error_already_set raised;
    {
      const py::gil_scoped_release released;
      Interruption::request();
      result.wait();
      Interruption::clear();
    }
    throw py::error_already_set(raised);
  }
  return result.get();
}

}  // namespace ridgeline::python
