// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/decoys.h"

#include "evaluate/judge/judge_line.h"
#include "evaluate/statistics/random.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/geometry/plane.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ridgeline::evaluate {
namespace {

/// The segment starting at the end that comes first in x, then y, then z.
Segment3 in_order(const Segment3& segment) {
  const bool is_in_order = std::ranges::lexicographical_compare(segment.start, segment.end);
  return is_in_order ? segment : Segment3{segment.end, segment.start};
}

Segment3 moved_by(const Segment3& segment, const Eigen::Vector3d& by_m) {
  return {segment.start + by_m, segment.end + by_m};
}

/// Unit vector to the left of the line in plan; empty if it has no direction in plan.
std::optional<Eigen::Vector3d> left_of(const Segment3& segment) {
  const Segment3 s = in_order(segment);
  const Eigen::Vector2d along = (s.end - s.start).head<2>();
  if (along.isZero(0.0)) return std::nullopt;
  return Eigen::Vector3d(-along.y(), along.x(), 0.0) / along.norm();
}

/// The point `up_m` above `x` on the ray along which a camera sees `x`.
Eigen::Vector3d along_ray(const ProjectionMatrix& camera, const Eigen::Vector3d& x, double up_m) {
  return point_on_plane(camera, project(camera, x),
                        Plane3(Eigen::Vector3d::UnitZ(), -(x.z() + up_m)));
}

/// What a false match would show instead of `seen`: the projection of the moved line plus the
/// residual of the original line.
Segment2 false_match(const ImageObservation& seen, const Segment3& line, const Segment3& moved) {
  Segment2 before = project(seen.image_from_local, line);
  Segment2 after = project(seen.image_from_local, moved);
  if ((seen.px.end - seen.px.start).dot(before.end - before.start) < 0.0) {
    std::swap(before.start, before.end);
    std::swap(after.start, after.end);
  }
  return {after.start + (seen.px.start - before.start), after.end + (seen.px.end - before.end)};
}

bool all_in_range(const Segment3& segment, const std::array<double, 2>& heights_m) {
  const auto is_in = [&](double z_m) { return z_m >= heights_m[0] && z_m <= heights_m[1]; };
  return is_in(segment.start.z()) && is_in(segment.end.z());
}

std::optional<JudgedLine> matched_falsely(const JudgedLine& line, double up_m) {
  constexpr double kMaxShiftPerHeight = 10.0;
  if (!line.images) return std::nullopt;
  JudgedLine decoy = line;
  const ProjectionMatrix& base = decoy.images->base().image_from_local;
  decoy.segment = {along_ray(base, line.segment.start, up_m),
                   along_ray(base, line.segment.end, up_m)};
  const double farthest_m = std::max((decoy.segment.start - line.segment.start).norm(),
                                     (decoy.segment.end - line.segment.end).norm());
  const bool is_near = farthest_m <= kMaxShiftPerHeight * std::abs(up_m);  // false for NaN
  if (!is_near || !all_in_range(decoy.segment, line.images->height_range_m)) return std::nullopt;
  for (ImageObservation& other : std::span(decoy.images->observations).subspan(1)) {
    other.px = false_match(other, line.segment, decoy.segment);
    if (!other.px.start.allFinite() || !other.px.end.allFinite()) return std::nullopt;
  }
  return decoy;
}

/// The line moved in plan together with its cameras, so that its images show it in the new
/// position.
JudgedLine moved_with_cameras(JudgedLine line, const Eigen::Vector2d& by_m) {
  const Eigen::Vector3d by(by_m.x(), by_m.y(), 0.0);
  line.segment = moved_by(line.segment, by);
  if (!line.images) return line;
  for (ImageObservation& seen : line.images->observations) {
    seen.image_from_local = image_from_local(seen.image_from_local, -by);
  }
  return line;
}

/// A hash of a line's position, to a tenth of a millimetre.
std::uint64_t key_of(const Segment3& segment) {
  constexpr double kPerMetre = 1e4;
  const Segment3 s = in_order(segment);
  std::uint64_t key = 0;
  for (const Eigen::Vector3d& end : {s.start, s.end}) {
    for (const double x : end) {
      key = KeyedRandom(key, static_cast<std::uint64_t>(std::llround(kPerMetre * x))).next();
    }
  }
  return key;
}

/// A line that can be moved.
struct Movable {
  std::uint64_t key;
  std::size_t line;
  auto operator<=>(const Movable&) const = default;
};

/// The first `n` lines that can be judged, in the order of their keys; only one line per key.
std::vector<Movable> drawn(std::span<const JudgedLine> lines, std::size_t n) {
  std::vector<Movable> all;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!refusal_of(lines[i])) all.push_back({key_of(lines[i].segment), i});
  }
  std::ranges::sort(all);
  const auto has_same_key = [](const Movable& a, const Movable& b) { return a.key == b.key; };
  all.erase(std::unique(all.begin(), all.end(), has_same_key), all.end());
  if (all.size() > n) all.resize(n);
  return all;
}

struct ShiftWay {
  DecoyKind kind;
  double distance_m;  ///< signed
};

std::vector<ShiftWay> ways_of(const JudgedLine& line) {
  std::vector<ShiftWay> ways;
  for (const DecoyKind kind : kDecoyKinds) {
    if (kind == DecoyKind::kMatch && !line.images) continue;
    for (const double distance_m : kDecoyDistances_m) {
      ways.push_back({kind, distance_m});
      ways.push_back({kind, -distance_m});
    }
  }
  return ways;
}

std::string decoy_id(std::uint64_t key, DecoyKind kind, double distance_m) {
  return fmt::format("{:016x} {} {:+g} m", key, name(kind), distance_m);
}

/// The first of eight steps in all directions that keeps `x` in the box, starting with one chosen
/// by the key.
std::optional<Eigen::Vector2d> step_within(const Eigen::AlignedBox2d& box,
                                           const Eigen::Vector2d& x,
                                           double distance_m,
                                           std::uint64_t key) {
  constexpr std::uint64_t kSides = 8;
  const std::uint64_t first = KeyedRandom(key, 1).below(kSides);
  for (std::uint64_t i = 0; i < kSides; ++i) {
    const double angle =
        2.0 * std::numbers::pi * static_cast<double>((first + i) % kSides) / kSides;
    const Eigen::Vector2d step(distance_m * std::cos(angle), distance_m * std::sin(angle));
    if (box.contains(x + step)) return step;
  }
  return std::nullopt;
}

}  // namespace

const char* name(DecoyKind kind) {
  switch (kind) {
    case DecoyKind::kHeight:
      return "height";
    case DecoyKind::kAcross:
      return "across";
    case DecoyKind::kMatch:
      return "match";
    case DecoyKind::kElsewhere:
      return "elsewhere";
  }
  return "unknown";
}

std::optional<JudgedLine> moved_line(const JudgedLine& line, DecoyKind kind, double distance_m) {
  check(kind != DecoyKind::kElsewhere, "moved_line: elsewhere, must be a kind of decoy");
  if (kind == DecoyKind::kMatch) return matched_falsely(line, distance_m);
  const std::optional<Eigen::Vector3d> direction =
      kind == DecoyKind::kHeight ? Eigen::Vector3d::UnitZ().eval() : left_of(line.segment);
  if (!direction) return std::nullopt;
  JudgedLine moved = line;
  moved.segment = moved_by(line.segment, distance_m * *direction);
  return moved;
}

std::size_t default_n_decoys(std::size_t n_lines) {
  return std::clamp(n_lines / 2, std::size_t{200}, std::size_t{2000});
}

std::vector<Decoy> make_decoys(std::span<const JudgedLine> lines, std::size_t n_decoys) {
  constexpr std::size_t kStride = 7;  // has no common divisor with 16 and 24, the numbers of ways
  const std::vector<Movable> parents = drawn(lines, n_decoys);
  std::vector<Decoy> decoys;
  for (std::size_t p = 0; p < parents.size(); ++p) {
    const auto [key, number] = parents[p];
    const std::vector<ShiftWay> ways = ways_of(lines[number]);
    const std::size_t first = KeyedRandom(key, 0).below(ways.size());
    const std::size_t n_moves = n_decoys / parents.size() + (p < n_decoys % parents.size() ? 1 : 0);
    for (std::size_t i = 0; i < std::min(n_moves, ways.size()); ++i) {
      const auto [kind, distance_m] = ways[(first + i * kStride) % ways.size()];
      std::optional<JudgedLine> moved = moved_line(lines[number], kind, distance_m);
      if (!moved) continue;
      moved->id = decoy_id(key, kind, distance_m);
      decoys.push_back({number, kind, std::abs(distance_m), std::move(*moved)});
    }
  }
  return decoys;
}

std::vector<Decoy> move_elsewhere(std::span<const JudgedLine> lines) {
  constexpr std::size_t kMoves = 200;
  const std::vector<Movable> parents = drawn(lines, kMoves);
  Eigen::AlignedBox2d box;
  for (const Movable& parent : parents) {
    box.extend(plan(lines[parent.line].segment).start).extend(plan(lines[parent.line].segment).end);
  }
  std::vector<Decoy> moved;
  for (std::size_t i = 0; i < std::min(kMoves, kElsewhere_m.size() * parents.size()); ++i) {
    const auto [key, number] = parents[i % parents.size()];
    const double distance_m = kElsewhere_m[(key + i / parents.size()) % kElsewhere_m.size()];
    const std::optional<Eigen::Vector2d> step_m =
        step_within(box, midpoint(plan(lines[number].segment)), distance_m, key);
    if (!step_m) continue;
    JudgedLine line = moved_with_cameras(lines[number], *step_m);
    line.id = decoy_id(key, DecoyKind::kElsewhere, distance_m);
    moved.push_back({number, DecoyKind::kElsewhere, distance_m, std::move(line)});
  }
  return moved;
}

}  // namespace ridgeline::evaluate
