// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/results/judge_files.h"

#include <nlohmann/json.hpp>

namespace ridgeline::apps {

/// The options of an evaluation for run.json, from which its report reads the cloud again.
nlohmann::ordered_json echo(const results::JudgeFilesOptions& options);

}  // namespace ridgeline::apps
