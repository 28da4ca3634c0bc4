// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/interruption.h"

#include <pybind11/pybind11.h>

#include <chrono>
#include <future>
#include <thread>
#include <type_traits>

namespace ridgeline::python {

/// Whether this is the thread in which Python runs its signal handlers.
inline bool is_main_thread() {
  const auto threading = pybind11::module_::import("threading");
  return threading.attr("current_thread")().is(threading.attr("main_thread")());
}

/// Does the work outside of the main thread. If a Ctrl-C for the work of the main thread stops it, it begins anew.
template <typename Work>
std::invoke_result_t<Work> uninterrupted(const Work& work) {
  constexpr std::chrono::milliseconds kBetweenLooks{1};
  for (;;) {
    try {
      return work();
    } catch (const Interrupted&) {
      while (Interruption::is_standing()) std::this_thread::sleep_for(kBetweenLooks);
    }
  }
}

/// Does the work in a thread of its own; meanwhile Python's signal handlers run, and if one raises, the work is stopped.
/// The caller must not hold the GIL.
template <typename Work>
std::invoke_result_t<Work> in_a_thread(const Work& work) {
  namespace py = pybind11;
  constexpr std::chrono::milliseconds kBetweenLooks{50};
  auto result = std::async(std::launch::async, work);
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

/// Does the work without the GIL, so that Python's other threads go on. In the main thread Ctrl-C stops it and raises
/// KeyboardInterrupt. The work must not touch Python's objects, and must be able to begin anew.
template <typename Work>
std::invoke_result_t<Work> interruptibly(const Work& work) {
  const bool is_main = is_main_thread();
  const pybind11::gil_scoped_release release;
  return is_main ? in_a_thread(work) : uninterrupted(work);
}

}  // namespace ridgeline::python
