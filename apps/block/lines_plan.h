// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/results/judge_batches.h"
#include "io/results/judged_parts.h"
#include "io/results/run_record.h"
#include "reconstruct/geometry/local_frame.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// Lines of one task: those with their middle in a cell. Cells lie at whole multiples of their size
/// in the reference system.
struct LinesCell {
  std::int64_t column = 0, row = 0;
  std::size_t n_lines = 0;

  friend bool operator==(const LinesCell&, const LinesCell&) = default;
};

/// The cells that hold lines, by row and column. A line that is not in_range() counts for the first
/// of them.
std::vector<LinesCell> cells_of(const results::LineSets& lines,
                                const LocalFrame& frame,
                                double size_m);

/// The numbers of the lines of each cell. `cells`: cells_of() the lines. Throws
/// std::invalid_argument for other ones.
std::vector<results::LineNumbers> numbers_by_cell(const std::vector<LinesCell>& cells,
                                                  const results::LineSets& lines,
                                                  const LocalFrame& frame,
                                                  double size_m);

/// How the tasks of a block of lines are cut, and what from.
// NOLINTNEXTLINE(bugprone-exception-escape): what moving JSON could throw is an assertion
struct LinesPlan {
  nlohmann::ordered_json made_from;  ///< program, block file, inputs, options
  std::vector<LinesCell> cells;

  /// The text of plan.json, the same for the same inputs and options.
  [[nodiscard]] std::string to_json() const;
};

/// Reads plan.json. Throws IoError if there is none or it is damaged.
LinesPlan read_lines_plan(const std::string& path);

/// Tells whether inputs are still the same. Content decides for files that are read whole, size and
/// time for others. A hash is computed again only if size or time have changed.
class InputStates {
 public:
  /// Program, block file, inputs and options as they are now, for LinesPlan::made_from. Paths are
  /// relative to the folder of the block file. Throws IoError for a file that is gone.
  nlohmann::ordered_json now(const std::string& block_file,
                             const std::vector<results::InputFile>& inputs,
                             nlohmann::ordered_json options);

 private:
  struct Hashed {
    std::uint64_t bytes;
    std::int64_t modified_s;
    std::string sha256;
  };
  void add(const std::string& role,
           const std::string& path,
           const std::string& block_file,
           nlohmann::ordered_json& inputs);

  std::map<std::string, Hashed> hashed_;
};

/// A difference between what a plan was made from and what there is now: what differs, and how.
struct PlanDifference {
  std::string what, how;
};
std::optional<PlanDifference> difference(const nlohmann::ordered_json& planned,
                                         const nlohmann::ordered_json& now);

}  // namespace ridgeline::apps
