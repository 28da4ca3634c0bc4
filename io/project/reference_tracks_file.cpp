// SPDX-License-Identifier: BSD-3-Clause
#include "io/project/reference_tracks_file.h"

#include "io/error.h"
#include "io/files/csv_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

namespace ridgeline::io {

std::vector<ReferenceTrack> read_reference_tracks(const std::string& path,
                                                  std::span<const std::string> images,
                                                  bool passes_over_others) {
  const CsvTable table(path, FileGroup::kReferenceTracks);
  const std::size_t edge = table.column("edge");
  const std::size_t image = table.column("image");
  const std::size_t x1 = table.column("x1_px");
  const std::size_t y1 = table.column("y1_px");
  const std::size_t x2 = table.column("x2_px");
  const std::size_t y2 = table.column("y2_px");
  std::vector<ReferenceTrack> tracks;
  std::map<std::string, std::size_t> place_of_edge;
  for (std::size_t row = 0; row < table.size(); ++row) {
    const std::string name(table.text(row, edge));
    const auto [place, is_new] = place_of_edge.try_emplace(name, tracks.size());
    if (is_new) {
      ReferenceTrack& track = tracks.emplace_back();
      track.edge = name;
      if (table.has("kind")) track.kind = table.text(row, table.column("kind"));
    }
    const auto view = std::ranges::find(images, table.text(row, image));
    if (view == images.end()) {
      if (passes_over_others) continue;
      throw IoError(table.place_of(row),
                    fmt::format("image '{}'; must be one of {}", table.text(row, image),
                                fmt::join(images, ", ")));
    }
    tracks[place->second].observations.push_back(
        {{static_cast<std::size_t>(view - images.begin()), -1},
         {{table.number(row, x1), table.number(row, y1)},
          {table.number(row, x2), table.number(row, y2)}}});
  }
  return tracks;
}

}  // namespace ridgeline::io
