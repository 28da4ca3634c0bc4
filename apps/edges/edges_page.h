// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/scan/scan_edges.h"
#include "io/cloud/cloud_files.h"

#include <string>

namespace ridgeline::apps {

/// A page in one file with the plan of the edges on the roof planes, a table by kind, and sections
/// across the longest edges, for which the cloud is read once more. `name`: of the cloud. Throws
/// IoError under the same conditions as read_cloud().
std::string edges_page(const std::string& name,
                       const evaluate::ScanEdges& edges,
                       io::CloudFiles& cloud);

}  // namespace ridgeline::apps
