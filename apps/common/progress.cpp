// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/progress.h"

#include <fmt/core.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace ridgeline::apps {

Progress::Progress(std::size_t n_steps)
    : n_steps_(std::max<std::size_t>(n_steps, 1)),
      shown_(isatty(STDERR_FILENO) != 0 && spdlog::should_log(spdlog::level::info)) {}

Progress::~Progress() { clear(); }

void Progress::begin(std::string_view what) {
  show(std::min(n_begun_++, n_steps_), n_steps_, what);
}

void Progress::show(std::size_t n_done, std::size_t n_steps, std::string_view what) const {
  constexpr std::size_t kWidth = 30;
  if (!shown_) return;
  const std::size_t filled = kWidth * n_done / n_steps;
  fmt::print(stderr, "\r\033[K[{}{}] {:3} % {}", std::string(filled, '#'),
             std::string(kWidth - filled, '.'), 100 * n_done / n_steps, what);
  std::fflush(stderr);
}

void Progress::clear() const {
  if (!shown_) return;
  fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
}

}  // namespace ridgeline::apps
