// SPDX-License-Identifier: BSD-3-Clause
// What a user of the edges of a scan relies on: they are there, they are right, and their intervals
// hold. Constants of evaluate/scan were chosen on villages of seeds 1 to 8 and 21 to 33; those
// below are held out.

#include "apps/simulate/als.h"
#include "apps/simulate/village.h"
#include "evaluate/scan/find_edges.h"
#include "evaluate/statistics/compare_with_scan.h"
#include "reconstruct/geometry/degrees.h"
#include "tests/support/random.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace ridgeline::test {
namespace {

using evaluate::ScanEdge;

constexpr std::uint64_t kFirstSeed = 101;
constexpr int kVillages = 10;
constexpr double kMinLength_m = 2.0, kLong_m = 4.0, kMinSupport = 0.8;
constexpr double kNear_m = 0.3, kMaxAngle_deg = 5.0;  // found and right
constexpr double kGross_m = 1.0;                      // the RMS is over all closer ones

/// The part of a segment's length, 0 to its length, next to which another one lies, and the
/// displacement from it in the middle of this part.
struct Overlap {
  double low_m = 0.0, high_m = 0.0;
  Eigen::Vector3d off_m = Eigen::Vector3d::Zero();
};

Overlap overlap(const Segment3& edge, const Segment3& other, double near_m, double angle_deg) {
  const Eigen::Vector3d d = (edge.end - edge.start).normalized(), e = other.end - other.start;
  if (acute_angle_rad(d, e) > angle_deg * kRadPerDeg) return {};
  const double s0 = d.dot(other.start - edge.start), s1 = d.dot(other.end - edge.start);
  Overlap o{std::max(0.0, std::min(s0, s1)), std::min(length(edge), std::max(s0, s1)), {}};
  if (o.high_m <= o.low_m) return {};
  const auto off = [&](double s) -> Eigen::Vector3d {
    const Eigen::Vector3d x = other.start + (s - s0) / (s1 - s0) * e - edge.start;
    return x - d.dot(x) * d;
  };
  if (std::max(off(o.low_m).norm(), off(o.high_m).norm()) > near_m) return {};
  o.off_m = off(0.5 * (o.low_m + o.high_m));
  return o;
}

/// The share of an edge's length that others lie next to.
double covered(const Segment3& edge, const std::vector<Segment3>& others) {
  std::vector<std::pair<double, double>> parts;
  for (const Segment3& other : others) {
    const Overlap o = overlap(edge, other, kNear_m, kMaxAngle_deg);
    if (o.high_m > o.low_m) parts.emplace_back(o.low_m, o.high_m);
  }
  std::ranges::sort(parts);
  double sum = 0.0, end = 0.0;
  for (const auto& [low, high] : parts) {
    sum += std::max(0.0, high - std::max(low, end));
    end = std::max(end, high);
  }
  return sum / length(edge);
}

struct Tally {
  int n_true = 0, n_found = 0, n_edges = 0, n_right = 0;
  int n_tested = 0, n_in_interval = 0;
  std::vector<double> errors_m, outwards_m;
  std::vector<double> long_errors_m, long_outwards_m;

  [[nodiscard]] double found() const { return static_cast<double>(n_found) / n_true; }
  [[nodiscard]] double right() const { return static_cast<double>(n_right) / n_edges; }
  [[nodiscard]] double in_interval() const { return static_cast<double>(n_in_interval) / n_tested; }
};

double rms(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double x : values) sum += x * x;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double x : values) sum += x;
  return sum / static_cast<double>(values.size());
}

bool is_seam(const std::string& kind) {
  return kind == "ridge" || kind == "hip" || kind == "valley";
}

/// The direction in which the covariance of the middle of an edge is largest, and its sigma.
std::pair<Eigen::Vector3d, double> least_known(const ScanEdge& edge) {
  Eigen::Matrix<double, 3, 6> to_middle;
  to_middle << 0.5 * Eigen::Matrix3d::Identity(), 0.5 * Eigen::Matrix3d::Identity();
  const Eigen::Vector3d d = (edge.segment.end - edge.segment.start).normalized();
  const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - d * d.transpose();
  const Eigen::Matrix3d c =
      across * to_middle * edge.covariance_m2 * to_middle.transpose() * across;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(c);
  return {solver.eigenvectors().col(2), std::sqrt(solver.eigenvalues()(2))};
}

void add_errors(const evaluate::ScanEdges& scan,
                const ScanEdge& edge,
                const std::vector<Segment3>& truth,
                bool is_right,
                Tally& tally) {
  const Overlap* best = nullptr;
  std::vector<Overlap> overlaps;
  for (const Segment3& line : truth)
    overlaps.push_back(overlap(edge.segment, line, kGross_m, 10.0));
  for (const Overlap& o : overlaps) {
    if (o.high_m - o.low_m < 0.5 * length(edge.segment)) continue;
    if (best == nullptr || o.off_m.norm() < best->off_m.norm()) best = &o;
  }
  if (best == nullptr) return;
  const bool is_long = length(edge.segment) >= kLong_m;
  (is_long ? tally.long_errors_m : tally.errors_m).push_back(best->off_m.norm());
  Eigen::Vector3d out = midpoint(edge.segment) - scan.planes[edge.planes[0]].fit.centroid;
  out.z() = 0.0;
  if (edge.planes.size() == 1)
    (is_long ? tally.long_outwards_m : tally.outwards_m)
        .push_back(-best->off_m.dot(out.normalized()));
  if (!is_right) return;
  const auto [direction, sigma_m] = least_known(edge);
  ++tally.n_tested;
  tally.n_in_interval += std::abs(best->off_m.dot(direction)) <= 1.96 * sigma_m ? 1 : 0;
}

struct Tallies {
  Tally seams, borders;
};

struct Village {
  simulate::SyntheticScene scene;
  evaluate::ScanEdges scan;
};

Village make_scanned_village(std::uint64_t seed) {
  simulate::VillageOptions options;
  options.seed = seed;
  options.with_feet = true;
  Village village{simulate::make_village(options), {}};
  simulate::AlsOptions als;
  als.seed = 1000 + seed;
  std::vector<Eigen::Vector3d> points;
  constexpr std::uint8_t kLowNoise = 7;  // dropped by every reader
  for (const io::CloudPoint& p : simulate::scan_als(village.scene, als).points)
    if (p.classification != kLowNoise) points.emplace_back(p.x, p.y, p.z);
  village.scan = evaluate::find_edges(points);
  return village;
}

/// Made once for all tests.
const Village& village_of(std::uint64_t seed) {
  static std::map<std::uint64_t, Village> villages;
  const auto it = villages.find(seed);
  return it != villages.end() ? it->second
                              : villages.emplace(seed, make_scanned_village(seed)).first->second;
}

/// The kind of a roof edge; empty for other true lines. Borders of level roofs are steps of a scan.
std::string kind_of(const simulate::SceneLine& line) {
  const std::string kind = simulate::name(line.kind);
  return is_seam(kind) || kind == "eave" || kind == "verge" ? kind : "";
}

void add_village(const Village& village, Tallies& tallies) {
  std::vector<Segment3> found, truth;
  for (const ScanEdge& edge : village.scan.edges) found.push_back(edge.segment);
  for (const simulate::SceneLine& line : village.scene.lines) truth.push_back(line.segment);
  for (const simulate::SceneLine& line : village.scene.lines) {
    const std::string kind = kind_of(line);
    if (kind.empty() || length(line.segment) < kMinLength_m) continue;
    Tally& tally = is_seam(kind) ? tallies.seams : tallies.borders;
    ++tally.n_true;
    tally.n_found += covered(line.segment, found) >= 0.5 ? 1 : 0;
  }
  for (const ScanEdge& edge : village.scan.edges) {
    if (length(edge.segment) < kMinLength_m || edge.support < kMinSupport) continue;
    Tally& tally = is_seam(edge.kind) ? tallies.seams : tallies.borders;
    const bool is_right = covered(edge.segment, truth) >= 0.5;
    ++tally.n_edges;
    tally.n_right += is_right ? 1 : 0;
    add_errors(village.scan, edge, truth, is_right, tally);
  }
}

const Tallies& villages() {
  static const Tallies tallies = [] {
    Tallies sum;
    for (int i = 0; i < kVillages; ++i) add_village(village_of(kFirstSeed + i), sum);
    return sum;
  }();
  return tallies;
}

TEST(ScanEdgesAccuracy, RidgesHipsAndValleysAreFoundAndRight) {
  const Tally& seams = villages().seams;
  std::vector<double> errors_m = seams.errors_m;
  errors_m.insert(errors_m.end(), seams.long_errors_m.begin(), seams.long_errors_m.end());
  RecordProperty("found", std::to_string(seams.found()));
  RecordProperty("right", std::to_string(seams.right()));
  RecordProperty("rms_m", std::to_string(rms(errors_m)));
  EXPECT_GE(seams.found(), 0.95) << seams.n_found << " of " << seams.n_true;
  EXPECT_GE(seams.right(), 0.97) << seams.n_right << " of " << seams.n_edges;
  EXPECT_LE(rms(errors_m), 0.05);
}

TEST(ScanEdgesAccuracy, EavesVergesAndStepsAreFoundWithoutBias) {
  const Tally& borders = villages().borders;
  RecordProperty("found", std::to_string(borders.found()));
  RecordProperty("right", std::to_string(borders.right()));
  RecordProperty("rms_short_m", std::to_string(rms(borders.errors_m)));
  RecordProperty("rms_long_m", std::to_string(rms(borders.long_errors_m)));
  RecordProperty("bias_long_m", std::to_string(mean(borders.long_outwards_m)));
  EXPECT_GE(borders.found(), 0.90) << borders.n_found << " of " << borders.n_true;
  EXPECT_GE(borders.right(), 0.95) << borders.n_right << " of " << borders.n_edges;
  EXPECT_LE(rms(borders.errors_m), 0.20);
  EXPECT_LE(rms(borders.long_errors_m), 0.10);
  EXPECT_LE(std::abs(mean(borders.long_outwards_m)), 0.03);
}

TEST(ScanEdgesAccuracy, IntervalsOf95PercentHold) {
  const Tally &seams = villages().seams, &borders = villages().borders;
  RecordProperty("seams", std::to_string(seams.in_interval()));
  RecordProperty("borders", std::to_string(borders.in_interval()));
  for (const Tally* tally : {&seams, &borders}) {
    EXPECT_GE(tally->in_interval(), 0.92) << tally->n_tested;
    EXPECT_LE(tally->in_interval(), 0.98) << tally->n_tested;
  }
}

/// Numbers of lines by kind, and of those that another set of lines shows.
using Recall = std::map<std::string, std::pair<int, int>>;

double share(const Recall& recall, const std::string& kind) {
  const auto& [n, n_found] = recall.at(kind);
  return static_cast<double>(n_found) / n;
}

/// The true lines of the village that a tool has found, 70 % of them, 5 cm off.
std::vector<Segment3> found_by_a_tool(const simulate::SyntheticScene& scene, Random& random) {
  constexpr double kShare = 0.7, kSigma_m = 0.05;
  std::vector<Segment3> lines;
  for (const simulate::SceneLine& line : scene.lines) {
    const auto noise = [&] {
      return Eigen::Vector3d(random.normal(kSigma_m), random.normal(kSigma_m),
                             random.normal(kSigma_m));
    };
    if (random.uniform(0.0, 1.0) < kShare)
      lines.push_back({line.segment.start + noise(), line.segment.end + noise()});
  }
  return lines;
}

TEST(ScanEdgesAccuracy, CompletenessAgainstTheScanIsThatAgainstTrueLines) {
  constexpr double kTolerance = 0.03;
  constexpr int kTools = 10;  // of 55 valleys, two alone are 3.6 %
  Recall of_truth, of_scan;
  for (int i = 0; i < kVillages * kTools; ++i) {
    const Village& village = village_of(kFirstSeed + i / kTools);
    Random random(kFirstSeed + i);
    const std::vector<Segment3> lines = found_by_a_tool(village.scene, random);
    for (const simulate::SceneLine& line : village.scene.lines) {
      const std::string kind = kind_of(line);
      if (kind.empty() || length(line.segment) < kMinLength_m) continue;
      auto& [n, n_found] = of_truth[kind];
      ++n;
      n_found += covered(line.segment, lines) >= 0.5 ? 1 : 0;
    }
    const evaluate::ScanScope everywhere{.contains = [](const Eigen::Vector2d&) { return true; }};
    for (const evaluate::ExpectedEdge& edge :
         evaluate::expected_edges(lines, village.scan, everywhere)) {
      auto& [n, n_found] = of_scan[edge.kind];
      ++n;
      n_found += edge.is_found() ? 1 : 0;
    }
  }
  for (const char* kind : {"ridge", "hip", "valley", "eave", "verge"}) {
    RecordProperty(std::string(kind) + "_true", std::to_string(share(of_truth, kind)));
    RecordProperty(std::string(kind) + "_scan", std::to_string(share(of_scan, kind)));
    EXPECT_NEAR(share(of_scan, kind), share(of_truth, kind), kTolerance)
        << kind << ": " << of_scan[kind].first << " edges, " << of_truth[kind].first << " lines";
  }
}

}  // namespace
}  // namespace ridgeline::test
