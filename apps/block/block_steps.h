// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/block/foreseen.h"

#include <cstddef>
#include <string>

namespace ridgeline::apps {

/// The steps of a block. Each may run in a process of its own, on any host that sees the same
/// folders; tasks in any order and at the same time. The results have the same bytes in every case.
class BlockSteps {
 public:
  virtual ~BlockSteps() = default;

  /// Writes the plan into the folder of the block. A plan that stands there and was made of the
  /// same inputs stays; one of other inputs is an IoError.
  virtual void plan() = 0;

  /// The number of tasks. There must be a plan.
  [[nodiscard]] virtual std::size_t n_tasks() const = 0;
  /// What messages call a task, 0 <= i < n_tasks().
  [[nodiscard]] virtual std::string name_of(std::size_t i) const = 0;

  /// What a task is expected to need, 0 <= i < n_tasks().
  [[nodiscard]] virtual Foreseen foreseen_of_task(std::size_t i) const = 0;
  /// What the merge is expected to need. There must be a plan.
  [[nodiscard]] virtual Foreseen foreseen_of_merge() const = 0;

  /// Does a task unless its results are there. Throws IoError for a fault of its inputs, also if
  /// they have changed since the plan.
  virtual void run_task(std::size_t i) = 0;

  /// Merges the results of all tasks. Says which tasks have none. Their parts are left out where
  /// the results of the others stand by themselves; else, as for lines that are judged, nothing is
  /// written.
  /// @return the number of tasks without results
  virtual std::size_t merge() = 0;
};

}  // namespace ridgeline::apps
