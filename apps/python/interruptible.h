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

/// A call that works without the GIL. It is created and destroyed while its thread holds the GIL,
/// which protects the count.
///
/// Python does not wait for daemon threads. If one of them were working in C++ when the process
/// exits, its TBB tasks would use library globals that have already been destroyed, and acquiring
/// the GIL again would terminate the thread within C++ frames: either crashes the process.
/// Therefore end_others() runs at exit, while threads can still acquire the GIL.
class RunningCall {
 public:
  /// Throws Interrupted if is_over().
  RunningCall();
  ~RunningCall() { --n_running; }
  RunningCall(const RunningCall&) = delete;
  RunningCall& operator=(const RunningCall&) = delete;

  /// Stops the calls of all other threads permanently and returns when they have left C++.
  static void end_others();
  /// For a forked process, in which the other threads do not exist.
  static void forget_others();
  /// Whether another thread is shutting Python down, so that this one must stop working.
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

/// Does the work outside the main thread. If it is stopped by a Ctrl-C meant for the main thread,
/// it starts again. Throws Interrupted if Python exits in the meantime.
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

/// Does the work in a separate thread while Python's signal handlers run; if a handler raises, the
/// work is stopped. The caller must not hold the GIL.
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

/// Does the work without the GIL, so that Python's other threads keep running. In the main thread,
/// Ctrl-C stops it and raises KeyboardInterrupt. In any other thread, it is stopped when Python
/// exits: Interrupted is thrown, which becomes SystemExit. All work without the GIL must use this
/// function. The work must not access Python objects and must be restartable.
template <typename Work>
std::invoke_result_t<Work> interruptibly(const Work& work) {
  const RunningCall running;
  const bool is_main = is_main_thread();
  const pybind11::gil_scoped_release release;
  return is_main ? in_a_thread(work) : uninterrupted(work);
}

}  // namespace ridgeline::python
