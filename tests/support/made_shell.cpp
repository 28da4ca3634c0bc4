// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/made_shell.h"

#include <algorithm>
#include <cstddef>
#include <tuple>

namespace ridgeline::test {
namespace {

using Edge = std::pair<Eigen::Vector3d, Eigen::Vector3d>;

std::vector<Edge> half_edges(const std::vector<MadeFace>& faces) {
  std::vector<Edge> edges;
  for (const MadeFace& face : faces) {
    for (const MadeRing& ring : face.rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        edges.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
      }
    }
  }
  return edges;
}

Eigen::Vector3d foot(const Eigen::Vector3d& x) { return {x.x(), x.y(), 0.0}; }

/// Whether a ring turns at its i-th vertex, as seen from above.
bool is_corner(const MadeRing& ring, std::size_t i) {
  constexpr double kStraight_m2 = 1e-9;
  const std::size_t n = ring.size();
  const Eigen::Vector3d in = ring[i] - ring[(i + n - 1) % n];
  const Eigen::Vector3d out = ring[(i + 1) % n] - ring[i];
  return std::abs(in.x() * out.y() - in.y() * out.x()) > kStraight_m2;
}

}  // namespace

MadeRing MadeShell::border() const {
  const std::vector<Edge> all = half_edges(faces);
  std::vector<Edge> open;
  for (const Edge& edge : all) {
    if (std::ranges::find(all, Edge(edge.second, edge.first)) == all.end()) open.push_back(edge);
  }
  MadeRing ring{open.front().first};
  while (ring.size() < open.size()) {
    ring.push_back(std::ranges::find(open, ring.back(), &Edge::first)->second);
  }
  return ring;
}

void MadeShell::close_to_ground() {
  MadeRing top = border();
  std::size_t first = 0;
  while (!is_corner(top, first)) ++first;
  std::rotate(top.begin(), top.begin() + static_cast<std::ptrdiff_t>(first), top.end());
  MadeRing feet;
  MadeRing chain{top.front()};  // from one corner to the next
  for (std::size_t i = 1; i <= top.size(); ++i) {
    const std::size_t at = i % top.size();
    chain.push_back(top[at]);
    if (!is_corner(top, at)) continue;
    MadeRing ring{foot(chain.front()), foot(chain.back())};
    ring.insert(ring.end(), chain.rbegin(), chain.rend());
    feet.push_back(ring.front());
    wall(std::move(ring));
    chain = {top[at]};
  }
  ground(feet);
}

}  // namespace ridgeline::test
