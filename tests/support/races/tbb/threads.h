// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// ThreadSanitizer does not see how TBB, which is not compiled with it, hands work over, and takes
// every such hand-over for a race. The build for it uses the parts of TBB that are in this folder.
// They start threads of the standard library, whose hand-over it sees.

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace tbb::races {

inline std::atomic<std::size_t> allowed_threads{4};
inline thread_local bool is_worker = false;

/// Calls f(0) ... f(n - 1) from several threads and throws what one of them throws. Loops within
/// loops stay in their thread. The counter orders nothing else (memory_order_relaxed), so that it
/// hides no race.
template <typename F>
void for_each_index(std::size_t n, const F& f) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr error;
  std::mutex of_error;
  const auto work = [&] {
    try {
      for (std::size_t i; (i = next.fetch_add(1, std::memory_order_relaxed)) < n;) f(i);
    } catch (...) {
      const std::lock_guard lock(of_error);
      error = std::current_exception();
      next.store(n, std::memory_order_relaxed);
    }
  };
  std::vector<std::thread> threads;
  if (!is_worker) {
    for (std::size_t t = 1; t < allowed_threads; ++t) {
      threads.emplace_back([&] {
        is_worker = true;
        work();
      });
    }
  }
  work();
  for (std::thread& thread : threads) thread.join();
  if (error) std::rethrow_exception(error);
}

}  // namespace tbb::races
