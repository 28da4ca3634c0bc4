// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/faces/face_seams.h"

#include "reconstruct/geometry/box_index.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <unordered_map>
#include <utility>

namespace ridgeline {
namespace {

constexpr double kSame = 0.01;  // vertices this close are treated as one; in units of the file

/// Vertices treated as one share a number and the position of the first.
class Nodes {
 public:
  std::size_t number_of(const Eigen::Vector3d& x) {
    const Cell cell = cell_of(x);
    for (std::int64_t i = -1; i <= 1; ++i)
      for (std::int64_t j = -1; j <= 1; ++j)
        for (std::int64_t k = -1; k <= 1; ++k) {
          const auto found = by_cell_.find({cell[0] + i, cell[1] + j, cell[2] + k});
          if (found == by_cell_.end()) continue;
          for (const std::size_t node : found->second)
            if ((places_[node] - x).norm() <= kSame) return node;
        }
    by_cell_[cell].push_back(places_.size());
    places_.push_back(x);
    return places_.size() - 1;
  }

  [[nodiscard]] const Eigen::Vector3d& operator[](std::size_t node) const { return places_[node]; }
  [[nodiscard]] std::size_t size() const { return places_.size(); }

 private:
  using Cell = std::array<std::int64_t, 3>;
  struct Hash {
    std::size_t operator()(const Cell& cell) const {
      std::uint64_t hash = 0;
      for (const std::int64_t c : cell)
        hash = (hash ^ static_cast<std::uint64_t>(c)) * 0x9E3779B97F4A7C15ULL;
      return static_cast<std::size_t>(hash ^ (hash >> 29U));
    }
  };
  static Cell cell_of(const Eigen::Vector3d& x) {
    const auto of = [](double c) { return static_cast<std::int64_t>(std::floor(c / kSame)); };
    return {of(x.x()), of(x.y()), of(x.z())};
  }

  std::unordered_map<Cell, std::vector<std::size_t>, Hash> by_cell_;
  std::vector<Eigen::Vector3d> places_;
};

/// Whether the coordinates in centimetres fit into 64-bit integers.
bool is_usable(const Eigen::Vector3d& x) {
  constexpr double kMaxCoordinate = 1e15;
  return x.allFinite() && x.cwiseAbs().maxCoeff() < kMaxCoordinate;
}

/// An edge of a face, or a part of it without a node between its ends.
struct SeamPiece {
  std::size_t from = 0, to = 0;
  std::vector<std::size_t> faces;  ///< ascending
};

class Seams {
 public:
  explicit Seams(std::span<const Face> faces) {
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (const Ring& ring : faces[i].rings) add_ring(ring, i);
    split_at_nodes();
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      at_node_[pieces_[i].from].push_back(i);
      at_node_[pieces_[i].to].push_back(i);
    }
  }

  std::vector<FaceSeam> join() {
    std::vector<FaceSeam> seams;
    is_joined_.assign(pieces_.size(), false);
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (is_joined_[i] || pieces_[i].faces.empty()) continue;
      is_joined_[i] = true;
      std::vector<std::size_t> chain{pieces_[i].from, pieces_[i].to};
      prolong(i, chain);
      std::ranges::reverse(chain);
      prolong(i, chain);
      seams.push_back({{nodes_[chain.back()], nodes_[chain.front()]}, pieces_[i].faces});
    }
    return seams;
  }

 private:
  void add_ring(const Ring& ring, std::size_t face) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Eigen::Vector3d &start = ring[i], &end = ring[(i + 1) % ring.size()];
      if (!is_usable(start) || !is_usable(end)) continue;
      const std::size_t a = nodes_.number_of(start), b = nodes_.number_of(end);
      if (a != b) edges_.push_back({a, b, {face}});
    }
  }

  void split_at_nodes() {
    std::vector<Eigen::AlignedBox2d> places;
    for (std::size_t node = 0; node < nodes_.size(); ++node)
      places.emplace_back(nodes_[node].head<2>());
    const BoxIndex2 index(std::move(places));
    for (const SeamPiece& edge : edges_) {
      const std::array ends{nodes_[edge.from], nodes_[edge.to]};
      std::vector<std::pair<double, std::size_t>> on_edge;
      for (const std::size_t node : index.near(plan_box_of(ends), kSame))
        if (const auto t = place_on(edge, node)) on_edge.emplace_back(*t, node);
      std::ranges::sort(on_edge);
      std::size_t from = edge.from;
      for (const auto& [t, node] : on_edge)
        add_piece(std::exchange(from, node), node, edge.faces[0]);
      add_piece(from, edge.to, edge.faces[0]);
    }
    edges_.clear();
  }

  /// The parameter of a node that lies within an edge.
  [[nodiscard]] std::optional<double> place_on(const SeamPiece& edge, std::size_t node) const {
    if (node == edge.from || node == edge.to) return std::nullopt;
    const Segment3 segment{nodes_[edge.from], nodes_[edge.to]};
    const double t = parameter_along(segment, nodes_[node]);
    if (t <= 0.0 || t >= 1.0 || (point_at(segment, t) - nodes_[node]).norm() > kSame)
      return std::nullopt;
    return t;
  }

  void add_piece(std::size_t from, std::size_t to, std::size_t face) {
    const auto [entry, is_new] =
        piece_of_.try_emplace({std::min(from, to), std::max(from, to)}, pieces_.size());
    if (is_new) pieces_.push_back({from, to, {}});
    std::vector<std::size_t>& faces = pieces_[entry->second].faces;
    const auto place = std::ranges::lower_bound(faces, face);
    // A face that contains an edge a second time lies on both sides of it.
    if (place != faces.end() && *place == face)
      faces.erase(place);
    else
      faces.insert(place, face);
  }

  /// Appends pieces to the end of the chain as long as they continue straight between the same
  /// faces.
  void prolong(std::size_t first, std::vector<std::size_t>& chain) {
    for (bool is_longer = true; is_longer;) {
      is_longer = false;
      for (const std::size_t i : at_node_[chain.back()]) {
        if (is_joined_[i] || pieces_[i].faces != pieces_[first].faces) continue;
        const std::size_t end = pieces_[i].from == chain.back() ? pieces_[i].to : pieces_[i].from;
        if (!is_straight(chain, end)) continue;
        is_joined_[i] = true;
        chain.push_back(end);
        is_longer = true;
        break;
      }
    }
  }

  /// Whether the chain remains a straight line, without turning back, if it is extended to a node.
  [[nodiscard]] bool is_straight(const std::vector<std::size_t>& chain, std::size_t end) const {
    const Segment3 whole{nodes_[chain.front()], nodes_[end]};
    double last = 0.0;
    for (std::size_t i = 1; i < chain.size(); ++i) {
      const double t = parameter_along(whole, nodes_[chain[i]]);
      if (t <= last || t >= 1.0) return false;
      if ((point_at(whole, t) - nodes_[chain[i]]).norm() > kSame) return false;
      last = t;
    }
    return true;
  }

  Nodes nodes_;
  std::vector<SeamPiece> edges_;
  std::vector<SeamPiece> pieces_;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> piece_of_;
  std::unordered_map<std::size_t, std::vector<std::size_t>> at_node_;
  std::vector<bool> is_joined_;
};

}  // namespace

std::vector<FaceSeam> seams_of(std::span<const Face> faces) { return Seams(faces).join(); }

}  // namespace ridgeline
