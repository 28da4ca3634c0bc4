// SPDX-License-Identifier: BSD-3-Clause
// Prints the hypotheses about the surfaces of true lines, for fit_weights.py:
//   dump_hypotheses POINTS_PER_M2 JITTER_M village|other|plain SEED...
// Lines are moved in plan by up to JITTER_M, as right lines are, too.
#include "evaluate/judge/candidate_planes.h"
#include "evaluate/judge/point_grid.h"
#include "evaluate/judge/surface_decision.h"
#include "tests/acceptance/hard_survey.h"

#include <fmt/core.h>

#include <cmath>
#include <cstdlib>
#include <string>

namespace ridgeline::test {
namespace {

using evaluate::CandidatePlane;
using evaluate::SurfaceHypothesis;

/// A line moved across in plan, by up to `most_m`; the n-th line always by the same.
Segment3 jittered(const Segment3& line, double most_m, std::size_t n) {
  const Eigen::Vector2d along = (plan(line).end - plan(line).start).normalized();
  const double by_m = most_m * std::sin(12.9898 * static_cast<double>(n + 1));
  const Eigen::Vector3d move(-along.y() * by_m, along.x() * by_m, 0.0);
  return {line.start + move, line.end + move};
}

/// Mean distance of the true line, signed distance of the moved one, vertical part of the normal
/// and sigma of the planes, then all terms.
void print(const SurfaceHypothesis& h,
           const Segment3& truth,
           const Segment3& line,
           const std::vector<CandidatePlane>& candidates) {
  Eigen::Vector3d sums = Eigen::Vector3d::Zero();
  double sigma_m = 0.0;
  for (const std::size_t k : h.planes) {
    const evaluate::PlaneFit& fit = candidates[k].fit;
    const SegmentPlaneDistance d = orthogonal_distance(line, fit.plane);
    sums += Eigen::Vector3d(orthogonal_distance(truth, fit.plane).mean_abs, d.mean,
                            fit.plane.normal().z()) /
            static_cast<double>(h.planes.size());
    sigma_m = std::max(sigma_m, fit.sigma_at(midpoint(line)));
  }
  fmt::print(" {} {:.4f} {:.4f} {:.4f} {:.4f}", name(h.surface), sums.x(), sums.y(), sums.z(),
             sigma_m);
  for (const double term : h.plan) fmt::print(" {:.4f}", term);
  fmt::print(" {:.4f} {:.3f} {:.3f}\n", h.accompanied, h.heights_m.x(), h.heights_m.y());
}

void dump(const std::string& seed, const HardSurvey& survey, double jitter_m) {
  const evaluate::JudgeOptions options;
  const auto grid = evaluate::PointGrid::build(survey.points.size(),
                                               [&](std::size_t i) { return survey.points[i]; });
  for (std::size_t i = 0; i < survey.lines.size(); ++i) {
    const HardLine& truth = survey.lines[i];
    if (length(plan(truth.segment)) < 0.05 * length(truth.segment)) continue;
    const Segment3 line = jittered(truth.segment, jitter_m, i);
    const evaluate::Footprint footprint = evaluate::footprint_of(line);
    const auto zone =
        points_beside(grid, footprint, options.fit_half_width_m, options.fit_half_width_m);
    const auto candidates = candidate_planes(zone, footprint, options);
    for (const SurfaceHypothesis& h :
         surface_hypotheses(zone, candidates, footprint, line, {}, options)) {
      fmt::print("{}_{} {} {:.3f} {}", seed, i, truth.kind, length(line), truth.planes.size());
      print(h, truth.segment, line, candidates);
    }
  }
}

int run(int argc, char** argv) {
  if (argc < 5) {
    fmt::print(stderr, "dump_hypotheses POINTS_PER_M2 JITTER_M village|other|plain SEED...\n");
    return 1;
  }
  const std::string scene = argv[3];
  const double density_per_m2 = std::atof(argv[1]);
  for (int i = 4; i < argc; ++i) {
    const auto seed = std::strtoull(argv[i], nullptr, 10);
    simulate::VillageOptions plain;
    plain.seed = seed;
    dump(argv[i],
         scene == "plain" ? survey_of_village(plain, density_per_m2)
                          : hard_survey(seed, density_per_m2,
                                        scene == "other" ? Renderer::kOther : Renderer::kVillage),
         std::atof(argv[2]));
  }
  return 0;
}

}  // namespace
}  // namespace ridgeline::test

int main(int argc, char** argv) { return ridgeline::test::run(argc, argv); }
