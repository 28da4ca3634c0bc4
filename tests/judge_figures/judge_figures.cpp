// SPDX-License-Identifier: BSD-3-Clause
// What the judge makes of the true lines of scenes with annexes, dormers, cars, garden walls and feet of walls:
//   judge_figures village|other DENSITY SEED...
#include "evaluate/judge/judge_lines.h"
#include "tests/acceptance/hard_survey.h"

#include <fmt/core.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace ridgeline::test {
namespace {

using evaluate::JudgedLine;
using evaluate::LineEvaluation;
using evaluate::Status;

struct Scene {
  HardSurvey survey;
  evaluate::PointGrid grid;
};

Scene scene_of(std::uint64_t seed, double density_per_m2, Renderer renderer) {
  HardSurvey survey = hard_survey(seed, density_per_m2, renderer);
  auto grid = evaluate::PointGrid::build(survey.points.size(),
                                         [&](std::size_t i) { return survey.points[i]; });
  return {std::move(survey), std::move(grid)};
}

Segment3 moved(const Segment3& s, const Eigen::Vector3d& by_m) {
  return {s.start + by_m, s.end + by_m};
}

std::vector<LineEvaluation> judge(const Scene& scene,
                                  const std::vector<Eigen::Vector3d>& moves_m,
                                  const evaluate::JudgeOptions& options = {}) {
  std::vector<JudgedLine> lines(moves_m.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    lines[i].id = std::to_string(i);
    lines[i].segment = moved(scene.survey.lines[i].segment, moves_m[i]);
  }
  std::vector<LineEvaluation> evaluations;
  for (auto& r : evaluate::judge_lines(scene.grid, lines, options))
    evaluations.push_back(std::move(r.evaluation));
  return evaluations;
}

double distance_m(const LineEvaluation& e) { return *e.mean_distance_m; }

struct Tally {
  int n = 0, evaluated = 0, within_5_cm = 0, beyond_30_cm = 0, object = 0;
  double squares = 0.0;
  void add(const LineEvaluation& e) {
    ++n;
    object += e.surface == evaluate::Surface::kObject && e.status != Status::kEvaluated ? 1 : 0;
    if (e.status != Status::kEvaluated) return;
    ++evaluated;
    within_5_cm += distance_m(e) <= 0.05 ? 1 : 0;
    beyond_30_cm += distance_m(e) > 0.3 ? 1 : 0;
    squares += distance_m(e) * distance_m(e);
  }
  void print(const std::string& name) const {
    fmt::print(
        "{:12} n {:5} evaluated {:5.1f} %  within 5 cm {:5.1f} %  above 0.3 m {:3} = {:.2f} %  RMS "
        "{:.3f}  object {:.1f} %\n",
        name, n, 100.0 * evaluated / std::max(1, n), 100.0 * within_5_cm / std::max(1, evaluated),
        beyond_30_cm, 100.0 * beyond_30_cm / std::max(1, evaluated),
        std::sqrt(squares / std::max(1, evaluated)), 100.0 * object / std::max(1, n));
  }
};

std::vector<Eigen::Vector3d> heights(std::size_t n, double by_m) {
  return std::vector<Eigen::Vector3d>(n, Eigen::Vector3d(0.0, 0.0, by_m));
}

bool has_surface(const HardLine& line) { return !line.planes.empty(); }

void truth(const std::vector<Scene>& scenes) {
  std::map<std::string, Tally> by_kind;
  Tally longer, medium, shorter;
  std::map<std::string, int> reasons, by;
  struct Bin {
    int n = 0, right = 0;
    double stated = 0.0;
  };
  std::map<int, Bin> bins;
  for (const Scene& scene : scenes) {
    const auto judged = judge(scene, heights(scene.survey.lines.size(), 0.0));
    for (std::size_t i = 0; i < judged.size(); ++i) {
      const HardLine& line = scene.survey.lines[i];
      const LineEvaluation& e = judged[i];
      if (e.length_m >= 1.0) by_kind[line.kind].add(e);
      if (!has_surface(line)) continue;
      (e.length_m >= 2.0 ? longer : e.length_m >= 1.0 ? medium : shorter).add(e);
      if (e.status != Status::kEvaluated)
        ++reasons[std::string(name(e.status)) + " " + e.reason.substr(0, 30)];
      if (e.decided_by) ++by[name(*e.decided_by)];
      if (e.status == Status::kEvaluated) {
        const double p = *e.surface_probability;
        Bin& bin = bins[p < 0.92 ? 0 : p < 0.95 ? 1 : p < 0.98 ? 2 : p < 0.995 ? 3 : 4];
        ++bin.n;
        bin.stated += p;
        bin.right += distance_m(e) <= 0.1 ? 1 : 0;
      }
    }
  }
  longer.print(">= 2 m");
  medium.print("1 to 2 m");
  shorter.print("< 1 m");
  for (const auto& [kind, tally] : by_kind) tally.print("  " + kind);
  for (const auto& [b, n] : by) fmt::print("  decided by {} {}\n", b, n);
  for (const auto& [b, bin] : bins)
    fmt::print("  stated {:.3f} right {:.3f} of {}\n", bin.stated / bin.n, 1.0 * bin.right / bin.n,
               bin.n);
  for (const auto& [reason, n] : reasons)
    if (n > 20) fmt::print("  {} {}\n", n, reason);
}

void decoys(const std::vector<Scene>& scenes) {
  for (const double by_m : {0.5, 1.0, 2.0, 5.0}) {
    int n = 0, pass = 0, withheld = 0, pass_headline = 0;
    std::map<std::string, int> kinds;
    for (const Scene& scene : scenes) {
      const std::size_t lines = scene.survey.lines.size();
      const auto parents = judge(scene, heights(lines, 0.0));
      for (const double sign : {-1.0, 1.0}) {
        const auto judged = judge(scene, heights(lines, sign * by_m));
        for (std::size_t i = 0; i < lines; ++i) {
          if (parents[i].status != Status::kEvaluated) continue;
          ++n;
          if (judged[i].status != Status::kEvaluated) {
            ++withheld;
            continue;
          }
          if (distance_m(judged[i]) >= 0.2) continue;
          ++pass;
          ++kinds[scene.survey.lines[i].kind];
          pass_headline += *judged[i].decided_by == evaluate::DecidedBy::kPlan ? 1 : 0;
        }
      }
    }
    fmt::print("decoys height {:.1f} m: {:.2f} % of {} pass ({} by plan), withheld {:.1f} %  ",
               by_m, 100.0 * pass / n, n, pass_headline, 100.0 * withheld / n);
    for (const auto& [kind, k] : kinds) fmt::print("{} {} ", kind, k);
    fmt::print("\n");
  }
}

void ladder(const std::vector<Scene>& scenes) {
  for (const double sigma_m : {0.05, 0.1, 0.2, 0.5, 1.0, 2.0}) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal(0.0, sigma_m);
    double added = 0.0, headline = 0.0, all = 0.0, added_judged = 0.0;
    int n = 0, n_headline = 0, n_all = 0;
    for (const Scene& scene : scenes) {
      auto moves = heights(scene.survey.lines.size(), 0.0);
      for (auto& m : moves) m.z() = normal(random);
      const auto judged = judge(scene, moves);
      for (std::size_t i = 0; i < judged.size(); ++i) {
        const auto true_m = true_mean_distance_m(scene.survey.lines[i],
                                                 moved(scene.survey.lines[i].segment, moves[i]));
        if (!true_m) continue;
        ++n;
        added += *true_m * *true_m;
        if (judged[i].status != Status::kEvaluated) continue;
        ++n_all;
        all += distance_m(judged[i]) * distance_m(judged[i]);
        if (*judged[i].decided_by > evaluate::DecidedBy::kImages) continue;
        ++n_headline;
        headline += distance_m(judged[i]) * distance_m(judged[i]);
        added_judged += *true_m * *true_m;
      }
    }
    fmt::print(
        "ladder {:.2f}: added {:.4f} headline {:.4f} ratio {:.3f} (same lines {:.3f}, {:.1f} %) "
        "all {:.4f} ratio {:.3f} ({:.1f} %)\n",
        sigma_m, std::sqrt(added / n), std::sqrt(headline / n_headline),
        std::sqrt(headline / n_headline / (added / n)), std::sqrt(headline / added_judged),
        100.0 * n_headline / n, std::sqrt(all / n_all), std::sqrt(all / n_all / (added / n)),
        100.0 * n_all / n);
  }
}

void chance(const std::vector<Scene>& scenes) {
  for (int seed = 2; seed <= 5; ++seed) {
    int n = 0, status = 0, distance = 0;
    double a2 = 0.0, b2 = 0.0;
    for (const Scene& scene : scenes) {
      evaluate::JudgeOptions options;
      const auto a = judge(scene, heights(scene.survey.lines.size(), 0.05));
      options.max_iterations += seed;
      const auto b = judge(scene, heights(scene.survey.lines.size(), 0.05), options);
      for (std::size_t i = 0; i < a.size(); ++i) {
        ++n;
        status += a[i].status != b[i].status ? 1 : 0;
        if (a[i].status == Status::kEvaluated) a2 += distance_m(a[i]) * distance_m(a[i]);
        if (b[i].status == Status::kEvaluated) b2 += distance_m(b[i]) * distance_m(b[i]);
        if (a[i].status == Status::kEvaluated && b[i].status == Status::kEvaluated)
          distance += std::abs(distance_m(a[i]) - distance_m(b[i])) > 0.01 ? 1 : 0;
      }
    }
    fmt::print("seed {}: status {} distance {} of {} squares {:.4f}\n", seed, status, distance, n,
               b2 / a2);
  }
  std::mt19937 random(3);
  std::normal_distribution<double> normal(0.0, 0.001);
  int n = 0, status = 0, distance = 0;
  double a2 = 0.0, b2 = 0.0;
  for (const Scene& scene : scenes) {
    const auto a = judge(scene, heights(scene.survey.lines.size(), 0.05));
    HardSurvey noisy = scene.survey;
    for (auto& p : noisy.points)
      p += Eigen::Vector3d(normal(random), normal(random), normal(random));
    auto grid = evaluate::PointGrid::build(noisy.points.size(),
                                           [&](std::size_t i) { return noisy.points[i]; });
    const Scene other{std::move(noisy), std::move(grid)};
    auto moves = heights(a.size(), 0.05);
    for (auto& m : moves) m += Eigen::Vector3d(normal(random), normal(random), normal(random));
    const auto b = judge(other, moves);
    for (std::size_t i = 0; i < a.size(); ++i) {
      ++n;
      status += a[i].status != b[i].status ? 1 : 0;
      if (a[i].status == Status::kEvaluated) a2 += distance_m(a[i]) * distance_m(a[i]);
      if (b[i].status == Status::kEvaluated) b2 += distance_m(b[i]) * distance_m(b[i]);
      if (a[i].status == Status::kEvaluated && b[i].status == Status::kEvaluated)
        distance += std::abs(distance_m(a[i]) - distance_m(b[i])) > 0.01 ? 1 : 0;
    }
  }
  fmt::print("noise 1 mm: status {} distance {} of {} squares {:.4f}\n", status, distance, n,
             b2 / a2);
}

int run(int argc, char** argv) {
  const Renderer renderer = std::string(argv[1]) == "other" ? Renderer::kOther : Renderer::kVillage;
  const std::string what = argv[2];
  const double density_per_m2 = std::atof(argv[3]);
  std::vector<Scene> scenes;
  for (int i = 4; i < argc; ++i)
    scenes.push_back(scene_of(std::strtoull(argv[i], nullptr, 10), density_per_m2, renderer));
  if (what.find('t') != std::string::npos) truth(scenes);
  if (what.find('d') != std::string::npos) decoys(scenes);
  if (what.find('l') != std::string::npos) ladder(scenes);
  if (what.find('c') != std::string::npos) chance(scenes);
  return 0;
}

}  // namespace
}  // namespace ridgeline::test

int main(int argc, char** argv) { return ridgeline::test::run(argc, argv); }
