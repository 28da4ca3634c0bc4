// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/schema_option.h"

namespace ridgeline::apps {

void add_schema_option(CLI::App& app, std::string& schema) {
  app.add_option(
         "--schema", schema,
         "of the map's lines; fkb: with objtype and accuracies in cm as FKB-Bygning names them")
      ->check(CLI::IsMember({"plain", "fkb"}))
      ->capture_default_str();
}

}  // namespace ridgeline::apps
