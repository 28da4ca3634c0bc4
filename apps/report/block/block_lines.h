// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace ridgeline::apps {

/// A small set of distinct texts, each identified by a number.
class Words {
 public:
  std::uint8_t number_of(const std::string& word);
  [[nodiscard]] const std::string& operator[](std::uint8_t number) const { return words_[number]; }

 private:
  std::vector<std::string> words_;
};

/// A line of a block. A block has hundreds of thousands of lines, so their texts are stored as
/// numbers in Words.
struct ShownLine {
  std::string id;  ///< within its patch
  std::uint32_t patch = 0;
  std::uint8_t line_class = 0, kind = 0, status = 0, n_images = 0;
  std::optional<float> mean_m, max_m;  ///< from the LIDAR planes, if the line was judged
  float length_m = 0.0F;
  Segment3 segment_m{};  ///< relative to BlockFolder::origin_m
};

/// The lines of a block from one method.
struct ShownLines {
  std::string method;
  Words words;
  std::vector<ShownLine> lines;
};

/// The indices of at most `n_most` lines, in ascending order: the `n_most` / 10 worst lines and an
/// even selection of the others.
std::vector<std::size_t> thinned_lines(const std::vector<ShownLine>& lines, std::size_t n_most);

/// The indices of the at most `n_most` judged lines farthest from their planes, the worst first;
/// ties are in the order of their indices.
std::vector<std::size_t> worst_lines(const std::vector<ShownLine>& lines, std::size_t n_most);

/// Reads the lines from the map at `path`. Lines whose id does not begin with that of one of the
/// patches are omitted. Throws IoError under the same conditions as io::for_each_map_line().
ShownLines read_shown_lines(const std::string& path,
                            const std::string& method,
                            const Eigen::Vector2d& origin_m,
                            const std::unordered_map<std::string, std::uint32_t>& patch_of_id);

}  // namespace ridgeline::apps
