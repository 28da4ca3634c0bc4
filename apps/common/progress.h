// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string_view>

namespace ridgeline::apps {

/// A progress bar on stderr for the steps of a long run. Silent if stderr is not a terminal or the
/// log level is above `info` (--quiet).
class Progress {
 public:
  explicit Progress(std::size_t n_steps);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  Progress(Progress&&) = delete;
  Progress& operator=(Progress&&) = delete;

  /// Ends the current step and begins one named `what`.
  void begin(std::string_view what);
  /// Shows how many of the steps of one kind are done.
  void show(std::size_t n_done, std::size_t n_steps, std::string_view what) const;
  /// Removes the bar from the terminal, so that other text can be printed.
  void clear() const;

 private:
  std::size_t n_steps_, n_begun_ = 0;
  bool shown_;
};

}  // namespace ridgeline::apps
