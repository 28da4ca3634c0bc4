// SPDX-License-Identifier: BSD-3-Clause
// Prints the hypotheses about the surface of true lines, for the fit of the weights.
#include "evaluate/judge/candidate_planes.h"
#include "evaluate/judge/point_grid.h"
#include "evaluate/judge/surface_decision.h"
#include "tests/acceptance/hard_survey.h"

#include <fmt/core.h>

#include <cmath>
#include <cstdlib>

using namespace ridgeline;
using namespace ridgeline::evaluate;

int main(int argc, char** argv) {
  const double density = std::atof(argv[1]);
  const double jitter_m = std::atof(argv[2]);
  const test::Renderer renderer =
      argv[3][0] == 'o' ? test::Renderer::kOther : test::Renderer::kVillage;
  const JudgeOptions options;
  for (int a = 4; a < argc; ++a) {
    const test::HardSurvey survey =
        test::hard_survey(std::strtoull(argv[a], nullptr, 10), density, renderer);
    const auto grid =
        PointGrid::build(survey.points.size(), [&](std::size_t i) { return survey.points[i]; });
    for (std::size_t i = 0; i < survey.lines.size(); ++i) {
      const auto& truth = survey.lines[i];
      if (length(plan(truth.segment)) < 0.05 * length(truth.segment)) continue;
      // right lines lie to a decimetre where they should, in plan as well
      Segment3 line = truth.segment;
      const Eigen::Vector2d along = (plan(line).end - plan(line).start).normalized();
      const double move_m = jitter_m * std::sin(12.9898 * static_cast<double>(i + 1));
      const Eigen::Vector3d move(-along.y() * move_m, along.x() * move_m, 0.0);
      line = {line.start + move, line.end + move};
      const Footprint footprint = footprint_of(line);
      const auto zone =
          points_beside(grid, footprint, options.fit_half_width_m, options.fit_half_width_m);
      const auto candidates = candidate_planes(zone, footprint, options);
      const auto hypotheses = surface_hypotheses(zone, candidates, footprint, line, {}, options);
      for (const SurfaceHypothesis& h : hypotheses) {
        double off = 0.0, signed_off = 0.0, nz = 0.0, sigma = 0.0;
        for (const std::size_t k : h.planes) {
          const SegmentPlaneDistance d = orthogonal_distance(line, candidates[k].fit.plane);
          off += d.mean_abs / h.planes.size();
          signed_off += d.mean / h.planes.size();
          nz += candidates[k].fit.plane.normal().z() / h.planes.size();
          sigma = std::max(sigma, candidates[k].fit.sigma_at(midpoint(truth.segment)));
        }
        fmt::print("{}_{} {} {:.3f} {} {} {:.4f} {:.4f} {:.4f} {:.4f}", argv[a], i, truth.kind,
                   length(truth.segment), truth.planes.size(), name(h.surface), off, signed_off, nz,
                   sigma);
        for (const double v : h.plan) fmt::print(" {:.4f}", v);
        fmt::print(" {:.4f}", h.accompanied);
        fmt::print(" {:.3f} {:.3f}\n", h.heights_m.x(), h.heights_m.y());
      }
    }
  }
}
