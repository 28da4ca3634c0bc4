// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/interruption.h"

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <future>
#include <thread>
#include <type_traits>

namespace ridgeline::python {

/// A call that works without the GIL; it is made and destroyed while its thread has the GIL, which
/// guards the count.
///
/// Python does not wait for daemon threads. If one of them worked in C++ while the process ends,
/// its TBB tasks would use globals of libraries that are destroyed already, and taking the GIL
/// again would end the thread amid C++ frames: either crashes the process. Therefore end_others()
/// runs at exit, while threads can still take the GIL.
class RunningCall {
 public:
  /// Throws Interrupted if is_over().
  RunningCall();
  ~RunningCall() { --n_running; }
  RunningCall(const RunningCall&) = delete;
  RunningCall& operator=(const RunningCall&) = delete;

  /// Stops the calls of all other threads for good, and returns when they have left C++.
  static void end_others();
  /// For a forked process, which has none of the other threads.
  static void forget_others();
  /// Whether another thread ends Python, so that this one must not work any more.
  [[nodiscard]] static bool is_over();

 private:
  static inline int n_running = 0;
  static inline std::atomic<std::thread::id> ending_thread;
};

/// Whether this is the thread in which Python runs its signal handlers.
inline bool is_main_thread() {
  const auto threading = pybind11::module_::import("threading");
  return threading.attr("current_thread")().is(threading.attr("main_thread")());
}

/// Does the work outside of the main thread. If a Ctrl-C for the work of the main thread stops it,
/// it begins anew. Throws Interrupted if Python ends meanwhile.
template <typename Work>
std::invoke_result_t<Work> uninterrupted(const Work& work) {
  constexpr std::chrono::milliseconds kBetweenAppearances{1};
  for (;;) {
    try {
      Interruption::check();
      return work();
    } catch (const Interrupted&) {
      while (Interruption::is_standing()) {
        if (RunningCall::is_over()) throw;
        std::this_thread::sleep_for(kBetweenAppearances);
      }
    }
  }
}

/// Does the work in a thread of its own; meanwhile Python's signal handlers run, and if one raises,
/// the work is stopped. The caller must not hold the GIL.
template <typename Work>
std::invoke_result_t<Work> in_a_thread(const Work& work) {
  namespace py = pybind11;
  constexpr std::chrono::milliseconds kBetweenAppearances{50};
  auto result = std::async(std::launch::async, work);
  while (result.wait_for(kBetweenAppearances) != std::future_status::ready) {
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

/// Does the work without the GIL, so that Python's other threads go on. In the main thread Ctrl-C
/// stops it and raises KeyboardInterrupt. In any other thread the end of Python stops it:
/// Interrupted is thrown, which becomes SystemExit. All work without the GIL must go through here.
/// The work must not touch Python's objects, and must be able to begin anew.
template <typename Work>
std::invoke_result_t<Work> interruptibly(const Work& work) {
  const RunningCall running;
  const bool is_main = is_main_thread();
  const pybind11::gil_scoped_release release;
  return is_main ? in_a_thread(work) : uninterrupted(work);
}

}  // namespace ridgeline::python
