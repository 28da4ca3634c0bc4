// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/gates/gate.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::evaluate {

/// JUnit XML, one testcase per result. The failure's body repeats every number, because some
/// viewers drop its message. `timestamp` is ISO 8601 without zone, as the JUnit schema asks for.
std::string to_junit(const GateReport& report, std::string_view timestamp);

/// GitHub aborts the upload of a job summary above 1024 KiB.
inline constexpr std::size_t kMaxSummaryBytes = std::size_t{900} * 1024;

/// Verdict, gate table (failures first), warnings. Rows beyond `max_bytes` are left out; a note
/// then gives their number and where to find all rows.
std::string to_markdown(const GateReport& report, std::size_t max_bytes = kMaxSummaryBytes);

/// Verdict and gate table in aligned columns, with all rows and the reason for a failure below its
/// row. The warnings are left out, because a terminal shows them as messages.
std::string to_terminal(const GateReport& report);

/// {"passed": ..., "gates": [{rule, patch, method, class, metric, value, limit, ...}],
/// "warnings": [...]}.
std::string to_json(const GateReport& report);

/// GitHub workflow commands, at most 10 errors and 10 warnings: the limit per step.
std::vector<std::string> to_annotations(const GateReport& report);

/// Escapes text for the data of a workflow command, i.e. %, CR and LF.
std::string escape_annotation(std::string_view text);

/// Escapes text for a property of a workflow command, i.e. %, CR, LF, colon and comma.
std::string escape_annotation_property(std::string_view text);

}  // namespace ridgeline::evaluate
