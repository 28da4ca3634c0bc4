// SPDX-License-Identifier: BSD-3-Clause
#include "io/project/tracks_file.h"

#include "io/error.h"
#include "io/files/atomic_file.h"
#include "io/files/csv_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace ridgeline::io {
namespace {

std::size_t view_of(const CsvTable& table,
                    std::size_t row,
                    const std::string& image,
                    std::span<const std::string> images) {
  const auto found = std::ranges::find(images, image);
  if (found == images.end()) {
    throw IoError(table.place_of(row),
                  fmt::format("image '{}'; must be one of {}", image, fmt::join(images, ", ")));
  }
  return static_cast<std::size_t>(found - images.begin());
}

}  // namespace

void write_tracks(const std::string& path,
                  std::span<const Track> tracks,
                  std::span<const std::string> images) {
  std::string text = "track,image,segment\n";
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    for (const Observation& s : tracks[t].observations)
      text += fmt::format("{},{},{}\n", t, images[s.view], s.segment);
  }
  write_file(path, text);
}

std::vector<Track> read_tracks(const std::string& path, std::span<const std::string> images) {
  const CsvTable table(path);
  const std::size_t track = table.column("track");
  const std::size_t image = table.column("image");
  const std::size_t segment = table.column("segment");
  std::vector<Track> tracks;
  for (std::size_t row = 0; row < table.size(); ++row) {
    const auto number = static_cast<std::size_t>(table.index(row, track));
    if (number > table.size()) {
      throw IoError(table.place_of(row),
                    fmt::format("track {}, must be below the number of rows", number));
    }
    if (number >= tracks.size()) tracks.resize(number + 1);
    tracks[number].observations.push_back(
        {view_of(table, row, std::string(table.text(row, image)), images),
         table.index(row, segment)});
  }
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    const bool has_two = tracks[t].observations.size() >= 2;
    if (has_two && tracks[t].base().view != tracks[t].other().view) continue;
    throw IoError(path, fmt::format("track {} must begin with segments of two images", t));
  }
  return tracks;
}

}  // namespace ridgeline::io
