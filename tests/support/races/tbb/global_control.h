// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tbb/threads.h"

namespace tbb {

class global_control {
 public:
  enum parameter { max_allowed_parallelism };
  global_control(parameter /*of*/, std::size_t threads)
      : before_(races::allowed_threads.exchange(threads)) {}
  ~global_control() { races::allowed_threads = before_; }
  global_control(const global_control&) = delete;
  global_control& operator=(const global_control&) = delete;

 private:
  std::size_t before_;
};

}  // namespace tbb
