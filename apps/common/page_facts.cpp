// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/page_facts.h"

namespace ridgeline::apps {

void add_page_options(CLI::App& app, PageFacts& facts) {
  const char* const group = "Report";
  app.add_option("--title", facts.title, "of the report")->group(group);
  app.add_option("--project", facts.project, "named in the report")->group(group);
  app.add_option("--operator", facts.operator_name, "named in the report")->group(group);
  app.add_option("--date", facts.date, "named in the report, as it is written here")->group(group);
}

nlohmann::ordered_json to_json(const PageFacts& facts) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) json[name] = value;
  };
  add("title", facts.title);
  add("project", facts.project);
  add("operator", facts.operator_name);
  add("date", facts.date);
  return json;
}

}  // namespace ridgeline::apps
