// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/common/outcome.h"
#include "apps/run/patch_run.h"
#include "reconstruct/geometry/correspondence.h"
#include "reconstruct/geometry/edge_segment.h"
#include "reconstruct/reconstruct.h"

#include <nlohmann/json.hpp>

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::apps {

/// A stage of a run. It reads its inputs from files, including those of earlier stages, even if
/// these ran in the same process, so that a resumed run is byte-identical.
struct Stage {
  std::string name;
  std::string key;                 ///< key_of() everything that its result depends on
  std::vector<std::string> files;  ///< files that it may write, relative to the patch's folder
  /// Runs the stage and adds any further files that it writes to `files`.
  std::function<void(std::vector<std::string>& files)> work;
};

/// The stages from the images to the lines: "check pairs", "extract", "match", "surface" and one
/// "reconstruct METHOD" per method, with their files.
class PatchStages {
 public:
  /// The files are in the subfolder of `out` named after the patch's id. `record` contains the
  /// inputs with their hashes and receives the warnings.
  PatchStages(const io::Patch& patch,
              const RunOptions& options,
              const results::OutputFolder& out,
              results::RunRecord& record);

  /// The stages in order. This object must outlive them.
  [[nodiscard]] std::vector<Stage> table();
  static std::string line_file(reconstruct::Method method, std::string_view extension = ".geojson");

  [[nodiscard]] PatchCounts counts() const;
  /// For each image: the width of its edges, derived from the scale at which they were found, and
  /// its noise.
  [[nodiscard]] nlohmann::ordered_json edge_facts();
  /// The row of Table 1; empty without reference matches. Writes the verdict on each match to
  /// verdicts.csv.
  [[nodiscard]] std::optional<evaluate::Table1Row> score_matches() const;
  /// The comparison of the tracks with the reference tracks; empty if the patch has none.
  [[nodiscard]] std::optional<evaluate::PatchTracks> score_tracks() const;

 private:
  [[nodiscard]] std::string views_key() const;
  [[nodiscard]] std::string extraction_key() const;

  void check_pairs();
  void extract();
  void match(std::vector<std::string>& files);
  void keep_surface();
  void reconstruct(reconstruct::Method method);

  [[nodiscard]] std::vector<std::string> edge_files() const;
  [[nodiscard]] std::vector<std::string> segment_files() const;
  /// The files of match() and score_matches(), except those of further pairs.
  [[nodiscard]] std::vector<std::string> match_files() const;
  [[nodiscard]] std::vector<std::string> line_files(reconstruct::Method method) const;
  [[nodiscard]] std::vector<io::LineFormatInfo> more_line_formats() const;
  /// Throws IoError if the file is an input.
  [[nodiscard]] std::string path(const std::string& file) const;
  void read_images();
  [[nodiscard]] std::array<std::vector<EdgeSegment>, 2> segments_of_pair() const;
  /// Reads the images and, from these files, the segments of each.
  void read_views(const std::vector<std::string>& files);
  [[nodiscard]] std::vector<ViewPair> pairs() const;
  [[nodiscard]] std::string pair_folder(const ViewPair& pair) const;
  [[nodiscard]] std::vector<Track> tracks() const;
  const std::vector<std::optional<reconstruct::Surface>>& surfaces();

  const io::Patch& patch_;
  const RunOptions& options_;
  const results::OutputFolder& out_;
  results::RunRecord& record_;
  nlohmann::ordered_json parameters_;  ///< echo of the parameters, by group
  reconstruct::Scene scene_;           ///< images are read when first needed
  std::vector<std::optional<reconstruct::Surface>>
      surfaces_;  ///< by pair, computed when first needed
};

/// Removes the lines, tables, maps and figures of other methods from an earlier run.
/// @param subfolder  of the results: "" or ending in a slash
void remove_other_methods(std::span<const reconstruct::Method> methods,
                          const results::OutputFolder& out,
                          const std::string& subfolder);

}  // namespace ridgeline::apps
