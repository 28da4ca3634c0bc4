// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/line_area.h"

#include "evaluate/files/judged_lines.h"
#include "reconstruct/geometry/box_index.h"
#include "reconstruct/geometry/transformed.h"

#include <optional>
#include <span>
#include <string>
#include <unordered_set>
#include <utility>

namespace ridgeline::results {
namespace {

using evaluate::JudgedLine;
using Middles = std::vector<std::optional<Eigen::Vector2d>>;

/// Whether each place is in the area; a missing place is assumed to be at the centre of all places.
std::vector<bool> are_in(const Eigen::AlignedBox2d& area, const Middles& places) {
  Eigen::AlignedBox2d all;
  for (const auto& place : places) {
    if (place) all.extend(*place);
  }
  const Eigen::Vector2d middle = all.isEmpty() ? Eigen::Vector2d::Zero().eval() : all.center();
  std::vector<bool> is_in;
  for (const auto& place : places) {
    const Eigen::Array2d x = place.value_or(middle);
    is_in.push_back((x >= area.min().array()).all() && (x < area.max().array()).all());
  }
  return is_in;
}

std::vector<bool> are_buildings_in(const Eigen::AlignedBox2d& area,
                                   const io::LineSet& set,
                                   const LocalFrame& frame) {
  const Eigen::Vector3d unit_m = unit_m_of(set);
  std::vector<Eigen::AlignedBox2d> outlines(set.model->buildings.size());
  for (const Face& face : set.model->faces) {
    for (const Ring& ring : face.rings) {
      for (const Eigen::Vector3d& x : ring) {
        outlines[face.building].extend(
            frame.local_from_world(x.cwiseProduct(unit_m)).head<2>().eval());
      }
    }
  }
  Middles places;
  for (const Eigen::AlignedBox2d& outline : outlines) {
    places.push_back(outline.isEmpty() ? std::nullopt : std::optional(outline.center().eval()));
  }
  return are_in(area, places);
}

std::vector<bool> are_lines_in(const Eigen::AlignedBox2d& area,
                               const io::LineSet& set,
                               const std::vector<JudgedLine>& lines,
                               const LocalFrame& frame) {
  if (set.model) {
    const std::vector<bool> buildings = are_buildings_in(area, set, frame);
    std::vector<bool> is_in;
    for (const io::Line& line : set.lines) is_in.push_back(buildings[line.row]);
    return is_in;
  }
  Middles places;
  for (const JudgedLine& line : lines) {
    places.push_back(evaluate::in_range(line.segment) ? std::optional(midpoint(plan(line.segment)))
                                                      : std::nullopt);
  }
  return are_in(area, places);
}

/// The lines of the area and all lines whose planes may share points with theirs.
std::vector<bool> are_near(const std::vector<bool>& is_own,
                           const std::vector<JudgedLine>& lines,
                           const evaluate::JudgeOptions& options) {
  const auto boxes =
      transformed(lines, [&](const JudgedLine& line) { return surroundings_of(line, options); });
  std::vector<Eigen::AlignedBox2d> own;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (is_own[i]) own.push_back(boxes[i]);
  }
  const BoxIndex2 index{std::span<const Eigen::AlignedBox2d>(own)};
  std::vector<bool> is_near = is_own;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!is_own[i]) is_near[i] = !index.near(boxes[i], 0.0).empty();
  }
  return is_near;
}

void mark_repeated_ids(std::vector<JudgedLine>& lines) {
  std::unordered_set<std::string> seen;
  for (JudgedLine& line : lines) line.repeats_id = !seen.insert(line.id).second;
}

template <typename T>
void keep(const std::vector<bool>& is_kept, std::vector<T>& values) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (is_kept[i] && n++ != i) values[n - 1] = std::move(values[i]);
  }
  values.resize(n);
}

/// Drops decoys of lines that are not kept and gives the others the new numbers of their lines.
void keep_decoys(const std::vector<bool>& is_kept, std::vector<evaluate::Decoy>& decoys) {
  std::vector<std::size_t> number(is_kept.size(), 0);
  for (std::size_t i = 0, n = 0; i < is_kept.size(); ++i) {
    if (is_kept[i]) number[i] = n++;
  }
  for (std::size_t i = 0; i < decoys.size(); ++i) decoys[i].number = i;
  std::erase_if(decoys, [&](const evaluate::Decoy& decoy) { return !is_kept[decoy.parent]; });
  for (evaluate::Decoy& decoy : decoys) decoy.parent = number[decoy.parent];
}

}  // namespace

Eigen::AlignedBox2d area_in_local(const Eigen::AlignedBox2d& area, const io::CloudFiles& cloud) {
  const Eigen::Vector2d unit_m = cloud.unit_m().head<2>();
  const Eigen::Vector2d origin_m = cloud.frame().origin_m.head<2>();
  return {area.min().cwiseProduct(unit_m) - origin_m, area.max().cwiseProduct(unit_m) - origin_m};
}

std::vector<std::size_t> buildings_in(const Eigen::AlignedBox2d& area_in_local,
                                      const io::LineSet& set,
                                      const LocalFrame& frame) {
  const std::vector<bool> is_in = are_buildings_in(area_in_local, set, frame);
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < is_in.size(); ++i) {
    if (is_in[i]) numbers.push_back(i);
  }
  return numbers;
}

std::vector<AreaLines> keep_area(const JudgeFilesOptions& options,
                                 const io::CloudFiles& cloud,
                                 PreparedLines& prepared,
                                 DecoySets& decoys) {
  const Eigen::AlignedBox2d& in_file = *options.area;
  const Eigen::AlignedBox2d area = area_in_local(in_file, cloud);
  std::vector<AreaLines> kept(prepared.lines.size());
  for (std::size_t i = 0; i < prepared.lines.size(); ++i) {
    std::vector<JudgedLine>& lines = prepared.lines[i];
    io::LineSet& set = prepared.judged.line_sets[i];
    mark_repeated_ids(lines);
    const std::vector<bool> is_own = are_lines_in(area, set, lines, cloud.frame());
    const std::vector<bool> is_kept = are_near(is_own, lines, options.judge);
    evaluate::AreaPart& part = prepared.judged.areas.emplace_back();
    part.bounds = {in_file.min().x(), in_file.min().y(), in_file.max().x(), in_file.max().y()};
    part.n_lines = lines.size();
    for (std::size_t k = 0; k < lines.size(); ++k) {
      if (is_own[k]) part.numbers.push_back(k);
      if (!is_kept[k]) continue;
      kept[i].numbers.push_back(k);
      kept[i].is_own.push_back(is_own[k]);
    }
    keep(is_kept, lines);
    keep(is_kept, set.lines);
    if (!decoys.empty()) keep_decoys(is_own, decoys[i]);
  }
  return kept;
}

void drop_neighbours(const std::vector<AreaLines>& kept,
                     PreparedLines& prepared,
                     JudgedBatches& batches) {
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const auto& [numbers, is_own] = kept[i];
    for (evaluate::JudgedResult& result : batches.results[i]) {
      for (evaluate::JudgingPlane& plane : result.evaluation.planes) {
        for (evaluate::SharedPoints& shared : plane.points.shared) {
          shared.line = numbers[shared.line];
        }
      }
    }
    keep(is_own, batches.results[i]);
    keep(is_own, prepared.lines[i]);
    keep(is_own, prepared.judged.line_sets[i].lines);
  }
}

}  // namespace ridgeline::results
