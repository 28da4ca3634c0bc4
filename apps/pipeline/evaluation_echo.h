// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/results/judge_files.h"

#include <nlohmann/json.hpp>

namespace ridgeline::apps {

/// The options of an evaluation as run.json records them. The report reads the cloud again with them.
nlohmann::ordered_json echo(const results::JudgeFilesOptions& options);

}  // namespace ridgeline::apps
