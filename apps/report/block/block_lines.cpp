// SPDX-License-Identifier: BSD-3-Clause
#include "apps/report/block/block_lines.h"

#include "io/lines/map_lines.h"
#include "reconstruct/geometry/check.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace ridgeline::apps {
namespace {

std::optional<float> as_float(const std::optional<double>& value) {
  return value ? std::optional(static_cast<float>(*value)) : std::nullopt;
}

}  // namespace

std::uint8_t Words::number_of(const std::string& word) {
  const auto found = std::ranges::find(words_, word);
  const auto number = static_cast<std::size_t>(found - words_.begin());
  check(number <= std::numeric_limits<std::uint8_t>::max(), "a column of the map holds ",
        words_.size(), " different values, must be at most 256");
  if (found == words_.end()) words_.push_back(word);
  return static_cast<std::uint8_t>(number);
}

std::vector<std::size_t> worst_lines(const std::vector<ShownLine>& lines, std::size_t n_most) {
  std::vector<std::size_t> judged;
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (lines[i].mean_m) judged.push_back(i);
  const auto middle = judged.begin() + static_cast<std::ptrdiff_t>(std::min(n_most, judged.size()));
  std::ranges::partial_sort(judged, middle, [&](std::size_t a, std::size_t b) {
    return lines[a].mean_m != lines[b].mean_m ? *lines[a].mean_m > *lines[b].mean_m : a < b;
  });
  judged.erase(middle, judged.end());
  return judged;
}

std::vector<std::size_t> thinned_lines(const std::vector<ShownLine>& lines, std::size_t n_most) {
  std::vector<std::size_t> all(lines.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  if (all.size() <= n_most) return all;
  std::vector<std::size_t> chosen = worst_lines(lines, n_most / 10);
  std::vector<char> is_chosen(lines.size(), 0);
  for (const std::size_t i : chosen) is_chosen[i] = 1;
  std::erase_if(all, [&](std::size_t i) { return is_chosen[i] != 0; });
  const std::size_t n_others = n_most - chosen.size();
  for (std::size_t k = 0; k < n_others; ++k) chosen.push_back(all[k * all.size() / n_others]);
  std::ranges::sort(chosen);
  return chosen;
}

ShownLines read_shown_lines(const std::string& path,
                            const std::string& method,
                            const Eigen::Vector2d& origin_m,
                            const std::unordered_map<std::string, std::uint32_t>& patch_of_id) {
  ShownLines shown;
  shown.method = method;
  const Eigen::Vector3d origin(origin_m.x(), origin_m.y(), 0.0);
  io::for_each_map_line(path, [&](const io::MapLine& line) {
    const std::size_t slash = line.id.find('/');
    const auto patch = patch_of_id.find(line.id.substr(0, slash));
    if (slash == std::string::npos || patch == patch_of_id.end()) return;
    ShownLine& one = shown.lines.emplace_back();
    one.id = line.id.substr(slash + 1);
    one.patch = patch->second;
    one.line_class = shown.words.number_of(line.line_class);
    one.kind = shown.words.number_of(line.kind);
    one.status = shown.words.number_of(line.status);
    one.n_images = static_cast<std::uint8_t>(std::clamp(line.n_images.value_or(0), 0, 255));
    one.mean_m = as_float(line.mean_distance_m);
    one.max_m = as_float(line.max_distance_m);
    one.segment_m = {line.segment_in_map.start - origin, line.segment_in_map.end - origin};
    one.length_m = static_cast<float>(
        line.length_m.value_or((one.segment_m.end - one.segment_m.start).norm()));
  });
  return shown;
}

}  // namespace ridgeline::apps
