// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/quiet_pcl.h"

#include <pcl/console/print.h>

#include <mutex>

namespace ridgeline::evaluate {
namespace {

struct Holders {
  std::mutex mutex;
  int count = 0;
  pcl::console::VERBOSITY_LEVEL level = pcl::console::L_INFO;  ///< before it was silenced
};

Holders& holders() {
  static Holders all;
  return all;
}

}  // namespace

QuietPcl::QuietPcl() {
  const std::scoped_lock lock(holders().mutex);
  if (holders().count++ > 0) return;
  holders().level = pcl::console::getVerbosityLevel();
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
}

QuietPcl::~QuietPcl() {
  const std::scoped_lock lock(holders().mutex);
  if (--holders().count == 0) pcl::console::setVerbosityLevel(holders().level);
}

}  // namespace ridgeline::evaluate
