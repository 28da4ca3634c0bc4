// SPDX-License-Identifier: BSD-3-Clause
#include "apps/pipeline/evaluation_echo.h"

#include "apps/pipeline/parameters.h"

#include <vector>

namespace ridgeline::apps {

nlohmann::ordered_json echo(const results::JudgeFilesOptions& options) {
  const io::ReadOptions& cloud = options.cloud;
  nlohmann::ordered_json json;
  json["lines"] = options.line_paths;
  json["cloud"] = options.cloud_paths;
  json["patch"] = options.patch ? options.patch->path : "";
  json["classes"] = cloud.classes ? std::vector<int>(cloud.classes->begin(), cloud.classes->end())
                                  : std::vector<int>{};
  json["exclude_withheld"] = cloud.exclude_withheld;
  json["last_returns"] = cloud.last_returns;
  json["bounds"] = nlohmann::ordered_json::array();
  if (const auto& box = cloud.bounds_in_file) {
    json["bounds"] = {box->min().x(), box->min().y(), box->max().x(), box->max().y()};
  }
  json["max_resolution_m"] = cloud.max_resolution_m;
  json["assume_crs"] = cloud.assume_crs.definition;
  json["scale_to_ground"] = options.scale_to_ground;
  json["vertex_pairs"] = options.lines.vertex_pairs;
  json["reconstruct"]["max_aligned_angle_deg"] = options.max_aligned_angle_deg;
  json["judge"] = echo(Parameters{{}, options.judge})["judge"];
  json["gross_m"] = options.summary.gross_m;
  json["sigma_sys_m"] = options.summary.sigma_sys_m;
  json["bootstrap_replicates"] = options.summary.bootstrap.replicates;
  json["bootstrap_seed"] = options.summary.bootstrap.seed;
  return json;
}

}  // namespace ridgeline::apps
