// SPDX-License-Identifier: BSD-3-Clause
// Which edges of the scan the lines show: the files, the map, gates and areas.
#include "tests/cli/cli_fixture.h"
#include "tests/support/sqlite.h"

#include <algorithm>
#include <string>
#include <vector>

namespace ridgeline::cli {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

class CompletenessOfLines : public Cli {
 protected:
  /// Judges a line file with --completeness into `out`.
  [[nodiscard]] ProgramResult compare(const std::string& lines,
                                      const std::string& out,
                                      std::vector<std::string> more = {}) const {
    more.insert(more.end(), {"--completeness", "--decoys", "0"});
    return evaluate(lines, out, more);
  }

  /// The row of a kind, all lengths.
  [[nodiscard]] json row_of(const std::string& evaluation, const std::string& kind) const {
    const json found = read_json(path(evaluation)).at("completeness");
    for (const json& row : found.at("rows")) {
      if (row["kind"] == kind && row["length"] == "all") return row;
    }
    return nullptr;
  }
};

}  // namespace
}  // namespace ridgeline::cli
