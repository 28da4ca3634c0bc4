// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/results/judge_batches.h"
#include "reconstruct/geometry/local_frame.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <string_view>

namespace ridgeline::results {

/// Some of all lines, ready for judge_part(), with what the other lines decide.
struct LinesPart {
  LocalFrame frame;
  Eigen::Vector2d plan_scale = Eigen::Vector2d::Ones();  ///< io::CloudFiles::plan_scale()
  LineSets lines;
};

// Parts as bytes, without loss: every number comes back bit by bit, NaN and infinities too.
std::string to_bytes(const LinesPart& part);
std::string to_bytes(const JudgedBatches& part);
// The inverse. Throws std::invalid_argument for other bytes.
LinesPart lines_part_of(std::string_view bytes);
JudgedBatches judged_part_of(std::string_view bytes);

// Writes a part to a file, whole or not at all. `key`: a hash of what the part was made from.
// Throws IoError if the file cannot be written.
void write_part(const std::string& path, const std::string& key, const LinesPart& part);
void write_part(const std::string& path, const std::string& key, const JudgedBatches& part);

/// Whether the file is there, whole, and was made from what `key` stands for.
bool is_part(const std::string& path, const std::string& key);

// The part in a file; nothing unless is_part().
std::optional<LinesPart> read_lines_part(const std::string& path, const std::string& key);
std::optional<JudgedBatches> read_judged_part(const std::string& path, const std::string& key);

}  // namespace ridgeline::results
