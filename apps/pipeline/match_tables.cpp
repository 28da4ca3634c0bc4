// SPDX-License-Identifier: BSD-3-Clause
#include "apps/pipeline/match_tables.h"

#include "reconstruct/geometry/degrees.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <array>

namespace ridgeline::apps {
namespace {

constexpr std::array kAxes{"x", "y", "z"};
constexpr std::array kEnds{"start", "end"};

std::string header() {
  std::string text =
      "left_id,right_id,linked_right_ids,process,neighbour_left_id,neighbour_height_m,"
      "height_limit_m,n_pieces,mean_rate,rate_sigma,azimuth_deg,mean_height_m,height_sigma_m";
  for (const char* prefix : {"", "sigma_"}) {
    for (const char* end : kEnds) {
      for (const char* axis : kAxes) text += fmt::format(",{}{}_{}_m", prefix, end, axis);
    }
  }
  return text + "\n";
}

/// The fields for the neighbour, its height and the height limit; empty in the first process.
std::string constraint_fields(const reconstruct::Acquired& acquired, double origin_z_m) {
  if (acquired.neighbour < 0) return ",,";
  return fmt::format("{},{:.3f},{:.3f}", acquired.neighbour, acquired.height_m + origin_z_m,
                     acquired.limit_m);
}

std::string line_fields(const std::optional<reconstruct::FittedLine>& line,
                        const LocalFrame& frame) {
  if (!line) return std::string(12, ',');
  std::string text;
  for (const Eigen::Vector3d& x : {line->segment.start, line->segment.end}) {
    const Eigen::Vector3d in_world = frame.world_from_local(x);
    for (Eigen::Index axis = 0; axis < 3; ++axis) text += fmt::format(",{:.3f}", in_world[axis]);
  }
  for (Eigen::Index k = 0; k < 6; ++k) {
    text += fmt::format(",{:.4f}", std::sqrt(line->cov_m2(k, k)));
  }
  return text;
}

}  // namespace

std::string unmatched_csv(const reconstruct::MatchList& list) {
  std::string text = "left_id,reason\n";
  for (std::size_t i = 0; i < list.reasons.size(); ++i) {
    if (list.reasons[i] == "matched") continue;
    text += fmt::format("{},{}\n", i, list.reasons[i]);
  }
  return text;
}

std::string chio_csv(const reconstruct::ChioResult& result, const LocalFrame& frame) {
  std::string text = header();
  const double origin_z_m = frame.origin_m.z();
  for (const reconstruct::ChioLine& line : result.lines) {
    const reconstruct::ChainSummary& chain = line.chain;
    text += fmt::format("{},{},{},{},{},{},{:.4f},{:.4f},{:.2f},{:.3f},{:.3f}{}\n", line.match.base,
                        line.match.other, fmt::join(line.fragments, " "), line.acquired.process,
                        constraint_fields(line.acquired, origin_z_m), chain.n_reliable,
                        chain.mean_rate, chain.rate_sigma, chain.azimuth_rad / kRadPerDeg,
                        chain.mean_height_m + origin_z_m, chain.height_sigma_m,
                        line_fields(line.line, frame));
  }
  return text;
}

}  // namespace ridgeline::apps
