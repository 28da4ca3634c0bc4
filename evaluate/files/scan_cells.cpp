// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/scan_cells.h"

#include "evaluate/files/merge_cells.h"
#include "evaluate/files/point_budget.h"
#include "io/error.h"
#include "reconstruct/geometry/interruption.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>
#include <set>
#include <utility>
#include <vector>

namespace ridgeline::results {
namespace {

using evaluate::ScanEdges;

/// Coordinates are whole multiples of 2^-14 m, about 0.06 mm, from the corner of a cell.
constexpr int kStepBits = 14;
/// Results are whole multiples of 2^-20 m, so that whole metres can be added without rounding.
constexpr int kResultBits = 20;

/// A rectangle of cells, the last ones included.
struct CellRange {
  MapCell first, last;

  [[nodiscard]] std::int64_t n_rows() const { return last.row - first.row + 1; }
  [[nodiscard]] std::int64_t n_columns() const { return last.column - first.column + 1; }
  [[nodiscard]] bool contains(const MapCell& cell) const {
    return cell.row >= first.row && cell.row <= last.row && cell.column >= first.column &&
           cell.column <= last.column;
  }
};

std::int64_t cell_at(double x_in_world) {
  return static_cast<std::int64_t>(std::floor(x_in_world / static_cast<double>(kCell_m)));
}

CellRange cells_around(const Eigen::AlignedBox2d& box_in_world) {
  return {{cell_at(box_in_world.min().y()), cell_at(box_in_world.min().x())},
          {cell_at(box_in_world.max().y()), cell_at(box_in_world.max().x())}};
}

/// The halves of a rectangle, cut across its longer side.
std::pair<CellRange, CellRange> halves(const CellRange& range) {
  std::pair<CellRange, CellRange> parts{range, range};
  const auto side = range.n_rows() >= range.n_columns() ? &MapCell::row : &MapCell::column;
  const std::int64_t middle = range.first.*side + (range.last.*side - range.first.*side) / 2;
  parts.first.last.*side = middle;
  parts.second.first.*side = middle + 1;
  return parts;
}

/// A mask that contains the rectangle and its margin.
io::PlanMask mask_of(const CellRange& range, const LocalFrame& frame) {
  constexpr std::int64_t kMaxStrips = 64;
  const Eigen::Vector2d origin = frame.origin_m.head<2>();
  const Eigen::AlignedBox2d box(box_of(range.first, {}, kCellMargin_m).min() - origin,
                                box_of(range.last, {}, kCellMargin_m).max() - origin);
  // narrow ones, because the mask reaches beyond their ends by half their height
  const std::int64_t n_strips = std::min(4 * range.n_rows(), kMaxStrips);
  const double height_m = box.sizes().y() / static_cast<double>(n_strips);
  std::vector<Segment2> strips;
  for (std::int64_t i = 0; i < n_strips; ++i) {
    const double y = box.min().y() + (static_cast<double>(i) + 0.5) * height_m;
    strips.push_back({{box.min().x(), y}, {box.max().x(), y}});
  }
  return {strips, 0.5 * height_m};
}

/// The planes and edges moved by whole metres.
ScanEdges moved(ScanEdges found, const Eigen::Vector3d& by_m) {
  const auto move = [&](Eigen::Vector3d& x) {
    for (int axis = 0; axis < 3; ++axis) {
      x[axis] = std::ldexp(std::round(std::ldexp(x[axis], kResultBits)), -kResultBits) + by_m[axis];
    }
  };
  for (evaluate::ScanPlane& plane : found.planes) {
    move(plane.fit.centroid);
    plane.fit.plane = Plane3(plane.fit.plane.normal(), plane.fit.centroid);
    for (auto& ring : plane.rings) {
      for (Eigen::Vector3d& x : ring) move(x);
    }
  }
  for (evaluate::ScanEdge& edge : found.edges) {
    move(edge.segment.start);
    move(edge.segment.end);
  }
  return found;
}

/// The points of one reading by cell.
class PointsByCell {
 public:
  explicit PointsByCell(const io::PointCloud& cloud) : cloud_(cloud) {
    for (int axis = 0; axis < 3; ++axis) {
      origin_[static_cast<std::size_t>(axis)] =
          std::llround(std::ldexp(cloud.frame.origin_m[axis], kStepBits));
    }
    for (std::size_t i = 0; i < cloud.points.size(); ++i) {
      cells_[cell_of(steps_of(cloud.points[i]))].push_back(static_cast<std::uint32_t>(i));
    }
  }

  [[nodiscard]] std::vector<MapCell> cells_in(const CellRange& range) const {
    std::vector<MapCell> cells;
    for (const auto& [cell, points] : cells_) {
      if (range.contains(cell)) cells.push_back(cell);
    }
    return cells;
  }

  /// All cells with points; std::nullopt if there are none.
  [[nodiscard]] std::optional<CellRange> range() const {
    if (cells_.empty()) return std::nullopt;
    CellRange range{cells_.begin()->first, cells_.begin()->first};
    for (const auto& [cell, points] : cells_) {
      range.first.row = std::min(range.first.row, cell.row);
      range.first.column = std::min(range.first.column, cell.column);
      range.last.row = std::max(range.last.row, cell.row);
      range.last.column = std::max(range.last.column, cell.column);
    }
    return range;
  }

  /// The points of a cell and its margin, from the lower corner of the cell and height 0.
  [[nodiscard]] std::vector<Eigen::Vector3d> around(const MapCell& cell) const {
    constexpr double kStep_m = 1.0 / (1 << kStepBits);
    const Eigen::AlignedBox2d box = box_of(cell, cell, kCellMargin_m);
    const std::array<std::int64_t, 3> corner{(cell.column * kCell_m) << kStepBits,
                                             (cell.row * kCell_m) << kStepBits, 0};
    std::vector<Eigen::Vector3d> points;
    for (std::int64_t row = cell.row - 1; row <= cell.row + 1; ++row) {
      for (std::int64_t column = cell.column - 1; column <= cell.column + 1; ++column) {
        const auto it = cells_.find({row, column});
        if (it == cells_.end()) continue;
        for (const std::uint32_t i : it->second) {
          const auto steps = steps_of(cloud_.points[i]);
          const Eigen::Vector3d x(kStep_m * static_cast<double>(steps[0] - corner[0]),
                                  kStep_m * static_cast<double>(steps[1] - corner[1]),
                                  kStep_m * static_cast<double>(steps[2] - corner[2]));
          if (box.contains(x.head<2>())) points.push_back(x);
        }
      }
    }
    return points;
  }

 private:
  [[nodiscard]] std::array<std::int64_t, 3> steps_of(const io::CloudPoint& p) const {
    return {std::llround(std::ldexp(p.x, kStepBits)) + origin_[0],
            std::llround(std::ldexp(p.y, kStepBits)) + origin_[1],
            std::llround(std::ldexp(p.z, kStepBits)) + origin_[2]};
  }

  /// The shift of a negative number rounds down.
  static MapCell cell_of(const std::array<std::int64_t, 3>& steps) {
    const auto index = [](std::int64_t step) {
      const std::int64_t metres = step >> kStepBits;
      return (metres >= 0 ? metres : metres - kCell_m + 1) / kCell_m;
    };
    return {index(steps[1]), index(steps[0])};
  }

  const io::PointCloud& cloud_;
  std::array<std::int64_t, 3> origin_{};
  std::map<MapCell, std::vector<std::uint32_t>> cells_;
};

class CellReader {
 public:
  CellReader(io::CloudFiles& cloud,
             std::uint64_t max_points,
             const CellProgress& progress,
             const evaluate::ScanOptions& options)
      : cloud_(cloud), max_points_(max_points), progress_(progress), options_(options) {}

  /// Finds the edges of all cells of the cloud.
  void find_all() {
    if (std::optional<io::PointCloud> all = cloud_.read_at_most({}, max_points_)) {
      return find_in(std::move(*all), std::nullopt);
    }
    const Eigen::AlignedBox3d extent = cloud_.extent_in_world();
    find(cells_around({extent.min().head<2>(), extent.max().head<2>()}));
  }

  /// Finds the edges of the cells of a rectangle, or of its halves one after the other.
  void find(const CellRange& range) {
    const io::PlanMask mask = mask_of(range, cloud_.frame());
    std::optional<io::PointCloud> points = cloud_.read_at_most(mask, max_points_);
    if (!points && range.n_rows() * range.n_columns() > 1) {
      const auto [first, second] = halves(range);
      find(first);
      find(second);
      return;
    }
    if (!points) points = read_beyond_limit(mask);
    find_in(std::move(*points), range);
  }

  [[nodiscard]] EdgesOfCloud take() {
    EdgesOfCloud result{.edges = {}, .readings = std::move(readings_)};
    if (found_.empty()) return result;
    MapCell base = found_.front().cell;
    for (const FoundInCell& of_cell : found_) {
      base.row = std::min(base.row, of_cell.cell.row);
      base.column = std::min(base.column, of_cell.cell.column);
    }
    for (FoundInCell& of_cell : found_) {
      of_cell.found = moved(std::move(of_cell.found), corner_of(of_cell.cell, base));
    }
    result.edges =
        moved(merge_cells(std::move(found_), base), corner_of(base, {}) - cloud_.frame().origin_m);
    return result;
  }

 private:
  static Eigen::Vector3d corner_of(const MapCell& cell, const MapCell& base) {
    const Eigen::Vector2d corner = box_of(cell, base, 0.0).min();
    return {corner.x(), corner.y(), 0.0};
  }

  io::PointCloud read_beyond_limit(const io::PlanMask& mask) {
    io::PointCloud points = cloud_.read(mask);
    points.warnings.push_back(
        fmt::format("{}: the {} points of a cell of {} m take {} MiB, more than `cloud_memory_mib`",
                    cloud_.path(), points.points.size(), kCell_m,
                    points.points.size() * kBytesPerPoint >> 20U));
    return points;
  }

  /// `range`: std::nullopt for all cells with points.
  void find_in(io::PointCloud cloud, std::optional<CellRange> range) {
    const std::size_t n_kept = cloud.points.size();
    const PointsByCell points(cloud);
    if (!range) range = points.range();
    const std::vector<MapCell> cells = range ? points.cells_in(*range) : std::vector<MapCell>();
    const std::size_t n_before = found_.size();
    found_.resize(n_before + cells.size());
    tbb::parallel_for(std::size_t{0}, cells.size(), [&](std::size_t i) {
      Interruption::check();
      found_[n_before + i] = {cells[i], evaluate::find_edges(points.around(cells[i]), options_)};
      report();
    });
    cloud.points = {};
    add_reading(std::move(cloud), n_kept, readings_);
  }

  void report() {
    const std::lock_guard lock(reporting_);
    ++n_done_;
    if (progress_) progress_(n_done_, found_.size());
  }

  io::CloudFiles& cloud_;
  std::uint64_t max_points_;
  const CellProgress& progress_;
  const evaluate::ScanOptions& options_;
  std::vector<FoundInCell> found_;
  CloudReadings readings_;
  std::mutex reporting_;
  std::size_t n_done_ = 0;
};

/// Keeps the edges whose middle lies in an area, and the planes that they bound or whose centroid
/// lies there.
ScanEdges in_area(ScanEdges all, const Eigen::AlignedBox2d& area) {
  const auto lies_there = [&](const Eigen::Vector3d& x) {
    return (x.head<2>().array() >= area.min().array()).all() &&
           (x.head<2>().array() < area.max().array()).all();
  };
  std::erase_if(all.edges, [&](const evaluate::ScanEdge& edge) {
    return !lies_there(midpoint(edge.segment));
  });
  std::vector<bool> is_kept;
  for (const evaluate::ScanPlane& plane : all.planes) {
    is_kept.push_back(lies_there(plane.fit.centroid));
  }
  for (const evaluate::ScanEdge& edge : all.edges) {
    for (const std::size_t plane : edge.planes) is_kept[plane] = true;
  }
  ScanEdges kept;
  std::vector<std::size_t> index;
  for (std::size_t p = 0; p < all.planes.size(); ++p) {
    index.push_back(kept.planes.size());
    if (is_kept[p]) kept.planes.push_back(std::move(all.planes[p]));
  }
  for (evaluate::ScanEdge& edge : all.edges) {
    for (std::size_t& plane : edge.planes) plane = index[plane];
  }
  kept.edges = std::move(all.edges);
  return kept;
}

}  // namespace

EdgesOfCloud edges_of_cloud(io::CloudFiles& cloud,
                            const std::optional<Eigen::AlignedBox2d>& area_in_world_m,
                            std::uint64_t max_memory_bytes,
                            const CellProgress& progress,
                            const evaluate::ScanOptions& options) {
  const std::uint64_t max_points = max_memory_bytes / kBytesPerPoint;
  if (!area_in_world_m) {
    CellReader reader(cloud, max_points, progress, options);
    reader.find_all();
    return reader.take();
  }
  const Eigen::Vector2d margin_m = Eigen::Vector2d::Constant(static_cast<double>(kCell_m));
  const CellRange cells =
      cells_around({area_in_world_m->min() - margin_m, area_in_world_m->max() + margin_m});
  const auto find_there = [&] {
    CellReader reader(cloud, max_points, progress, options);
    reader.find(cells);
    return reader.take();
  };
  EdgesOfCloud found = find_there();
  if (found.readings.n_kept == 0 && !cloud.unread_paths().empty()) {
    cloud.distrust_headers();
    found = find_there();
  }
  const Eigen::Vector2d origin = cloud.frame().origin_m.head<2>();
  found.edges = in_area(std::move(found.edges),
                        {area_in_world_m->min() - origin, area_in_world_m->max() - origin});
  return found;
}

bool keeps_only_buildings(const io::ReadOptions& options) {
  constexpr std::uint8_t kBuildings = 6;
  return options.classes == std::set{kBuildings};
}

void require_points(const CloudReadings& readings, const io::CloudFiles& cloud) {
  require_points(readings.cloud, cloud.path());
  if (readings.n_kept > 0) return;
  throw io::IoError(cloud.path(), no_point_in_bounds(cloud));
}

}  // namespace ridgeline::results
