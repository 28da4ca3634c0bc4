// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// The warnings about the files that `info` shows. Those of a single file are printed with its
/// facts. Those of several files are collected, so that a warning that many of them share is
/// printed once.
class InfoWarnings {
 public:
  explicit InfoWarnings(std::size_t n_files) : is_single_(n_files == 1) {}

  void add(const std::string& path, const std::string& warning);

  /// Prints the collected warnings as io::shared_warnings().
  void print() const;

 private:
  bool is_single_;
  std::vector<std::string> collected_;
};

}  // namespace ridgeline::apps
