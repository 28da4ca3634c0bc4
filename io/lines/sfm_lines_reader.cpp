// SPDX-License-Identifier: BSD-3-Clause
// Line3D++, LIMAP and ELSR++ text results. None of them has a header or states a CRS or a version.
#include "io/error.h"
#include "io/files/input_file.h"
#include "io/kinds/folder_kind.h"
#include "io/kinds/recognise.h"
#include "io/lines/polyline.h"
#include "io/lines/readers.h"
#include "io/text/text.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace ridgeline::io {
namespace {

Eigen::Vector3d point_at(const std::vector<double>& numbers, std::size_t first) {
  return {numbers[first], numbers[first + 1], numbers[first + 2]};
}

std::size_t count_at(const std::vector<std::string_view>& words,
                     std::size_t i,
                     const std::string& where) {
  const std::optional<long> count = i < words.size() ? to_integer(words[i]) : std::nullopt;
  if (!count || *count < 0) {
    throw IoError(
        where, fmt::format("word {} is not a count; the row is truncated or not a result", i + 1));
  }
  return static_cast<std::size_t>(*count);
}

void expect_words(const std::vector<std::string_view>& words,
                  std::size_t count,
                  const std::string& where) {
  if (words.size() == count) return;
  throw IoError(where, fmt::format("{} fields; {} are expected", words.size(), count));
}

/// The number of images in the supports (camera, segment, 4 coordinates each).
int count_images(const std::vector<std::string_view>& words, std::size_t first) {
  std::set<std::string_view> cameras;
  for (std::size_t i = first; i < words.size(); i += 6) cameras.insert(words[i]);
  return static_cast<int>(cameras.size());
}

bool exceeds_six_digits(const LineSet& set) {
  constexpr double kLimit = 1e5;  // the sixth significant digit is then a metre
  return std::any_of(set.lines.begin(), set.lines.end(), [](const Line& line) {
    return line.segment_in_world.start.cwiseAbs().maxCoeff() >= kLimit ||
           line.segment_in_world.end.cwiseAbs().maxCoeff() >= kLimit;
  });
}

/// Row-wise access that turns the end of the file into an error.
class RowReader {
 public:
  RowReader(const std::string& path, std::string_view content)
      : path_(path), rows_(rows_of(content)) {}

  [[nodiscard]] bool at_end() const { return next_ == rows_.size(); }

  /// Words of the next row. `what` names the row for messages.
  std::vector<std::string_view> words(std::string_view what) {
    if (at_end()) throw IoError(path_, fmt::format("ends before {}", what));
    where_ = place(path_, rows_[next_].number);
    return words_of(rows_[next_++].text);
  }
  std::vector<double> numbers(std::string_view what, std::size_t count) {
    const std::vector<std::string_view> row = words(what);
    expect_words(row, count, where_);
    return to_doubles(row, where_);
  }
  [[nodiscard]] const std::string& where() const { return where_; }

 private:
  std::string path_;
  std::string where_;
  std::vector<TextRow> rows_;
  std::size_t next_ = 0;
};

int count_distinct(const std::vector<std::string_view>& words) {
  return static_cast<int>(std::set<std::string_view>(words.begin(), words.end()).size());
}

/// The number K of track_K.txt; std::nullopt for other names.
std::optional<long> track_number(const std::filesystem::path& path) {
  const std::string stem = path.stem().string();
  if (path.extension() != ".txt" || !stem.starts_with("track_")) return std::nullopt;
  return to_integer(std::string_view(stem).substr(6));
}

/// The number of cameras of each line, from cams.txt next to ELSR++'s spaceLines.txt; empty if that
/// file does not exist.
std::vector<int> images_per_line(const std::filesystem::path& space_lines) {
  const std::filesystem::path cameras = space_lines.parent_path() / "cams.txt";
  if (!std::filesystem::exists(cameras)) return {};
  const std::string content = read_input(cameras.string());
  return transformed(rows_of(content),
                     [&](const TextRow& row) { return count_distinct(words_of(row.text)); });
}

[[noreturn]] void refuse_folder_of_others(const std::string& path) {
  const FileKind kind = kind_of_folder(path);
  if (kind.group != FileGroup::kFolder) throw IoError(path, refusal(kind, FileGroup::kLines));
  const std::string advice = kind.advice.empty() ? "" : "; " + kind.advice;
  throw IoError(path, fmt::format("is {}, without the track_K.txt of LIMAP{}", kind.what, advice));
}

}  // namespace

LineSet read_line3dpp(const std::string& path, std::string_view content) {
  LineSet set = lines_for_file(path, "Line3D++", content.size());
  std::int64_t number = 0;
  for (const TextRow& row : rows_of(content)) {
    const std::string where = place(path, row.number);
    const std::vector<std::string_view> words = words_of(row.text);
    const std::size_t n_segments = count_at(words, 0, where);
    const std::size_t n_supports = count_at(words, 1 + 6 * n_segments, where);
    expect_words(words, 2 + 6 * (n_segments + n_supports), where);
    const std::vector<double> numbers = to_doubles(words, where);
    Line line;
    line.n_images = count_images(words, 2 + 6 * n_segments);
    std::vector<Vertices> parts;
    for (std::size_t i = 0; i < n_segments; ++i) {
      parts.push_back({point_at(numbers, 1 + 6 * i), point_at(numbers, 4 + 6 * i)});
    }
    append_feature(line, parts, number++, set);
  }
  if (exceeds_six_digits(set)) {
    set.warnings.emplace_back(
        "coordinates of 1e5 and more with six digits have lost their decimetres; shift to a local "
        "origin before running Line3D++");
  }
  return set;
}

LineSet read_limap_tracks(const std::string& path, std::string_view content) {
  LineSet set = lines_for_file(path, "LIMAP tracks", content.size());
  RowReader rows(path, content);
  const std::size_t n_tracks = count_at(rows.words("the number of tracks"), 0, rows.where());
  for (std::size_t i = 0; i < n_tracks; ++i) {
    const std::vector<std::string_view> head = rows.words("a track's id and counts");
    expect_words(head, 3, rows.where());
    Line line;
    line.id = std::string(head[0]);
    const std::vector<double> start = rows.numbers("a track's start", 3);
    const std::vector<double> end = rows.numbers("a track's end", 3);
    line.n_images = count_distinct(rows.words("a track's image ids"));
    rows.words("a track's line ids");
    append_segment(line, {point_at(start, 0), point_at(end, 0)}, i, set);
  }
  if (!rows.at_end()) {
    rows.words("the end");
    throw IoError(rows.where(), fmt::format("continues after the {} declared tracks", n_tracks));
  }
  return set;
}

LineSet read_limap_track(const std::string& path, std::string_view content) {
  LineSet set;
  set.format = "LIMAP track";
  RowReader rows(path, content);
  const std::vector<double> ends = rows.numbers("the segment", 6);
  rows.words("the counts");
  Line line;
  std::vector<std::string_view> images = rows.words("image_id_list");
  if (!images.empty()) images.erase(images.begin());  // the keyword
  line.n_images = count_distinct(images);
  const std::optional<long> number = track_number(path);
  if (number) line.id = std::to_string(*number);
  append_segment(line, {point_at(ends, 0), point_at(ends, 3)}, 0, set);
  return set;
}

LineSet read_limap_folder(const std::string& path) {
  if (std::filesystem::exists(std::filesystem::path(path) / "structures")) {
    throw IoError(path,
                  "is a result of LIMAP 2.0, whose layout is not supported; give alltracks.txt");
  }
  std::vector<std::pair<long, std::string>> tracks;
  for (const auto& entry : std::filesystem::directory_iterator(path)) {
    const std::optional<long> number = track_number(entry.path());
    if (number) tracks.emplace_back(*number, entry.path().string());
  }
  if (tracks.empty()) refuse_folder_of_others(path);
  std::sort(tracks.begin(), tracks.end());
  LineSet set;
  set.format = "LIMAP tracks";
  for (const auto& [number, file] : tracks) {
    LineSet track = read_limap_track(file, read_input(file));
    std::move(track.lines.begin(), track.lines.end(), std::back_inserter(set.lines));
  }
  return set;
}

LineSet read_space_lines(const std::string& path, std::string_view content) {
  LineSet set = lines_for_file(path, "ELSR++", content.size());
  RowReader rows(path, content);
  const std::vector<int> n_images = images_per_line(path);
  for (std::size_t i = 0; !rows.at_end(); ++i) {
    const std::vector<double> ends = rows.numbers("a segment", 6);
    Line line;
    if (i < n_images.size()) line.n_images = n_images[i];
    append_segment(line, {point_at(ends, 0), point_at(ends, 3)}, i, set);
  }
  return set;
}

}  // namespace ridgeline::io
