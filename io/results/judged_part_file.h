// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/results/judge_batches.h"

#include <optional>
#include <string>
#include <string_view>

namespace ridgeline::results {

/// What judge_part() gave as bytes, without loss: every number comes back bit by bit, NaN and infinities too.
std::string to_bytes(const JudgedBatches& part);
/// Reads what to_bytes() wrote. Throws std::invalid_argument for other bytes.
JudgedBatches judged_part_of(std::string_view bytes);

/// Writes a part to a file, whole or not at all. `key`: what the part was made from, as a hash.
/// Throws IoError if the file cannot be written.
void write_judged_part(const std::string& path, const std::string& key, const JudgedBatches& part);

/// Whether the file is there, whole, and was made from what `key` stands for.
bool is_judged_part(const std::string& path, const std::string& key);

/// The part in a file; nothing unless is_judged_part().
std::optional<JudgedBatches> read_judged_part(const std::string& path, const std::string& key);

}  // namespace ridgeline::results
