// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string_view>

namespace ridgeline::apps {

/// A bar on stderr over the steps of a long run. Silent where stderr is no terminal or the log
/// level is above `info` (--quiet).
class Progress {
 public:
  explicit Progress(std::size_t n_steps);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  Progress(Progress&&) = delete;
  Progress& operator=(Progress&&) = delete;

  /// Ends the step in progress and begins one that is named `what`.
  void begin(std::string_view what);
  /// Takes the bar off the terminal, so that other text can be printed.
  void clear() const;

 private:
  std::size_t n_steps_, n_begun_ = 0;
  bool shown_;
};

}  // namespace ridgeline::apps
