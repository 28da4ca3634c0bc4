// SPDX-License-Identifier: BSD-3-Clause
// What the judge makes of the true lines of scenes with annexes, dormers, cars, garden walls and
// feet of walls, without images:
//   judge_figures village|other POINTS_PER_M2 truth|decoys|ladder|noise SEED...
#include "evaluate/judge/judge_lines.h"
#include "reconstruct/geometry/transformed.h"
#include "tests/acceptance/hard_survey.h"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace ridgeline::test {
namespace {

using evaluate::DecidedBy;
using evaluate::JudgedLine;
using evaluate::LineEvaluation;
using evaluate::Status;
using Moves = std::vector<Eigen::Vector3d>;

struct HardScene {
  HardSurvey survey;
  evaluate::PointGrid grid;
};
using HardScenes = std::vector<HardScene>;

HardScene scene_of(HardSurvey survey) {
  auto grid = evaluate::PointGrid::build(survey.points.size(),
                                         [&](std::size_t i) { return survey.points[i]; });
  return {std::move(survey), std::move(grid)};
}

Segment3 moved(const Segment3& s, const Eigen::Vector3d& by_m) {
  return {s.start + by_m, s.end + by_m};
}

Moves heights(const HardScene& scene, double by_m) {
  return Moves(scene.survey.lines.size(), Eigen::Vector3d(0.0, 0.0, by_m));
}

std::vector<LineEvaluation> judge(const HardScene& scene, const Moves& moves_m) {
  std::vector<JudgedLine> lines(moves_m.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    lines[i].id = std::to_string(i);
    lines[i].segment = moved(scene.survey.lines[i].segment, moves_m[i]);
  }
  return transformed(evaluate::judge_lines(scene.grid, lines, {}),
                     &evaluate::JudgedResult::evaluation);
}

bool is_evaluated(const LineEvaluation& e) { return e.status == Status::kEvaluated; }
/// Of a line that is evaluated.
bool is_headline(const LineEvaluation& e) { return *e.decided_by <= DecidedBy::kImages; }
double percent(double part, double whole) { return whole > 0.0 ? 100.0 * part / whole : 0.0; }

struct Tally {
  int n = 0, n_evaluated = 0, n_within_5_cm = 0, n_above_30_cm = 0;
  double squares_m2 = 0.0;

  void add(const LineEvaluation& e) {
    ++n;
    if (!is_evaluated(e)) return;
    ++n_evaluated;
    n_within_5_cm += *e.mean_distance_m <= 0.05 ? 1 : 0;
    n_above_30_cm += *e.mean_distance_m > 0.3 ? 1 : 0;
    squares_m2 += *e.mean_distance_m * *e.mean_distance_m;
  }
  void print(const std::string& name) const {
    fmt::print(
        "{:10} {:6} lines, evaluated {:5.1f} %, within 5 cm {:5.1f} %, above 0.3 m {:5.2f} %, RMS "
        "{:.3f} m\n",
        name, n, percent(n_evaluated, n), percent(n_within_5_cm, n_evaluated),
        percent(n_above_30_cm, n_evaluated), std::sqrt(squares_m2 / std::max(1, n_evaluated)));
  }
};

struct StatedBin {
  int n = 0, n_right = 0;
  double stated = 0.0;
};

const char* length_class(double length_m) {
  if (length_m >= 2.0) return "2 m, more";
  return length_m >= 1.0 ? "1 to 2 m" : "below 1 m";
}

/// True lines as they are, by length and kind, and how often stated probabilities are right.
void print_truth(const HardScenes& scenes) {
  constexpr std::array kBins{0.92, 0.95, 0.98, 0.995};
  std::map<std::string, Tally> tallies;
  std::map<std::size_t, StatedBin> bins;
  for (const HardScene& scene : scenes) {
    const std::vector<LineEvaluation> judged = judge(scene, heights(scene, 0.0));
    for (std::size_t i = 0; i < judged.size(); ++i) {
      const HardLine& line = scene.survey.lines[i];
      if (judged[i].length_m >= 1.0) tallies["  " + line.kind].add(judged[i]);
      if (line.planes.empty()) continue;
      tallies[length_class(judged[i].length_m)].add(judged[i]);
      if (!is_evaluated(judged[i])) continue;
      const double p = *judged[i].surface_probability;
      StatedBin& bin = bins[static_cast<std::size_t>(
          std::upper_bound(kBins.begin(), kBins.end(), p) - kBins.begin())];
      ++bin.n;
      bin.stated += p;
      bin.n_right += *judged[i].mean_distance_m <= 0.1 ? 1 : 0;
    }
  }
  for (const auto& [name, tally] : tallies) tally.print(name);
  for (const auto& [place, bin] : bins) {
    fmt::print("stated {:.3f}, right {:.3f}, {} lines\n", bin.stated / bin.n,
               static_cast<double>(bin.n_right) / bin.n, bin.n);
  }
}

/// Lines moved in height, of which a judge should say so.
void print_decoys(const HardScenes& scenes) {
  constexpr double kPass_m = 0.2;
  for (const double by_m : {-5.0, -2.0, -1.0, -0.5, 0.5, 1.0, 2.0, 5.0}) {
    int n = 0, n_pass = 0, n_pass_headline = 0, n_withheld = 0;
    for (const HardScene& scene : scenes) {
      const std::vector<LineEvaluation> parents = judge(scene, heights(scene, 0.0));
      const std::vector<LineEvaluation> judged = judge(scene, heights(scene, by_m));
      for (std::size_t i = 0; i < judged.size(); ++i) {
        if (!is_evaluated(parents[i])) continue;
        ++n;
        n_withheld += is_evaluated(judged[i]) ? 0 : 1;
        const bool passes = is_evaluated(judged[i]) && *judged[i].mean_distance_m < kPass_m;
        n_pass += passes ? 1 : 0;
        n_pass_headline += passes && is_headline(judged[i]) ? 1 : 0;
      }
    }
    fmt::print("{:+.1f} m: {:.2f} % of {} pass ({:.2f} % by plan), {:.1f} % withheld\n", by_m,
               percent(n_pass, n), n, percent(n_pass_headline, n), percent(n_withheld, n));
  }
}

struct Rms {
  int n = 0;
  double squares_m2 = 0.0;
  void add(double v_m) {
    ++n;
    squares_m2 += v_m * v_m;
  }
  [[nodiscard]] double m() const { return std::sqrt(squares_m2 / std::max(1, n)); }
};

/// The RMS that the judge gives lines whose heights have errors, against that of these errors.
void print_ladder(const HardScenes& scenes) {
  for (const double sigma_m : {0.05, 0.1, 0.2, 0.5, 1.0, 2.0}) {
    std::mt19937 random(7);
    std::normal_distribution<double> error_m(0.0, sigma_m);
    Rms added, headline, all;
    for (const HardScene& scene : scenes) {
      Moves moves = heights(scene, 0.0);
      for (Eigen::Vector3d& move : moves) move.z() = error_m(random);
      const std::vector<LineEvaluation> judged = judge(scene, moves);
      for (std::size_t i = 0; i < judged.size(); ++i) {
        const HardLine& line = scene.survey.lines[i];
        const auto true_m = true_mean_distance_m(line, moved(line.segment, moves[i]));
        if (!true_m) continue;
        added.add(*true_m);
        if (!is_evaluated(judged[i])) continue;
        all.add(*judged[i].mean_distance_m);
        if (is_headline(judged[i])) headline.add(*judged[i].mean_distance_m);
      }
    }
    fmt::print(
        "{:.2f} m: added {:.3f} m, headline {:.3f} times of {:.0f} %, all {:.3f} times of {:.0f} "
        "%\n",
        sigma_m, added.m(), headline.m() / added.m(), percent(headline.n, added.n),
        all.m() / added.m(), percent(all.n, added.n));
  }
}

/// What noise of a millimetre on points and lines changes.
void print_noise(const HardScenes& scenes) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise_m(0.0, 0.001);
  const auto any = [&] {
    return Eigen::Vector3d(noise_m(random), noise_m(random), noise_m(random));
  };
  int n = 0, n_status = 0, n_distance = 0;
  Rms before, after;
  for (const HardScene& scene : scenes) {
    HardSurvey noisy = scene.survey;
    for (Eigen::Vector3d& x : noisy.points) x += any();
    Moves moves = heights(scene, 0.0);
    const std::vector<LineEvaluation> a = judge(scene, moves);
    for (Eigen::Vector3d& move : moves) move += any();
    const std::vector<LineEvaluation> b = judge(scene_of(std::move(noisy)), moves);
    for (std::size_t i = 0; i < a.size(); ++i) {
      ++n;
      n_status += a[i].status != b[i].status ? 1 : 0;
      if (is_evaluated(a[i])) before.add(*a[i].mean_distance_m);
      if (is_evaluated(b[i])) after.add(*b[i].mean_distance_m);
      if (!is_evaluated(a[i]) || !is_evaluated(b[i])) continue;
      n_distance += std::abs(*a[i].mean_distance_m - *b[i].mean_distance_m) > 0.01 ? 1 : 0;
    }
  }
  fmt::print(
      "of {} lines {:.2f} % change their status, {:.2f} % their distance by 1 cm; RMS {:.4f} and "
      "{:.4f} m\n",
      n, percent(n_status, n), percent(n_distance, n), before.m(), after.m());
}

int run(int argc, char** argv) {
  if (argc < 5) {
    fmt::print(stderr,
               "judge_figures village|other POINTS_PER_M2 truth|decoys|ladder|noise SEED...\n");
    return 1;
  }
  const std::map<std::string, void (*)(const HardScenes&)> figures{{"truth", print_truth},
                                                                   {"decoys", print_decoys},
                                                                   {"ladder", print_ladder},
                                                                   {"noise", print_noise}};
  const Renderer renderer = std::string(argv[1]) == "other" ? Renderer::kOther : Renderer::kVillage;
  HardScenes scenes;
  for (int i = 4; i < argc; ++i) {
    scenes.push_back(
        scene_of(hard_survey(std::strtoull(argv[i], nullptr, 10), std::atof(argv[2]), renderer)));
  }
  figures.at(argv[3])(scenes);
  return 0;
}

}  // namespace
}  // namespace ridgeline::test

int main(int argc, char** argv) { return ridgeline::test::run(argc, argv); }
