// SPDX-License-Identifier: BSD-3-Clause
#include "apps/python/interruptible.h"

#include "apps/python/bindings.h"

namespace ridgeline::python {
namespace py = pybind11;

RunningCall::RunningCall() {
  if (is_over()) throw Interrupted();
  ++n_running;
}

bool RunningCall::is_over() {
  const std::thread::id ending = ending_thread;
  return ending != std::thread::id() && ending != std::this_thread::get_id();
}

void RunningCall::end_others() {
  constexpr std::chrono::milliseconds kBetweenAppearances{1};
  ending_thread = std::this_thread::get_id();
  Interruption::request();
  while (n_running > 0) {
    {
      const py::gil_scoped_release release;
      std::this_thread::sleep_for(kBetweenAppearances);
    }
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();  // Ctrl-C ends the wait
  }
  Interruption::clear();  // this thread may still make calls
}

void RunningCall::forget_others() {
  n_running = 0;
  Interruption::clear();
}

/// Registers handlers for when Python exits or forks.
void add_endings() {
  py::module_::import("atexit").attr("register")(py::cpp_function(&RunningCall::end_others));
  const py::cpp_function forget(&RunningCall::forget_others);
  py::module_::import("os").attr("register_at_fork")(py::arg("after_in_child") = forget);
}

}  // namespace ridgeline::python
