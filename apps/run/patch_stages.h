// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/common/outcome.h"
#include "apps/run/patch_run.h"
#include "reconstruct/geometry/edge_segment.h"
#include "reconstruct/geometry/line_match.h"
#include "reconstruct/reconstruct.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::apps {

/// The stages of a reconstruction with their files. Every stage reads what it needs from the files of the stages before
/// it, also where these ran in this object, and writes files of its own.
class PatchStages {
 public:
  /// The files are in the subfolder of `out` that is named after the patch's id.
  PatchStages(const CheckedPatch& patch,
              const RunOptions& options,
              const results::OutputFolder& out);

  /// Throws IoError if one of the files that the stages write is an input.
  void check_outputs() const;

  /// By image: the segments that extract() writes.
  [[nodiscard]] std::vector<std::string> edge_files() const;
  /// All that match() writes.
  [[nodiscard]] std::vector<std::string> match_files() const;
  static std::string line_file(reconstruct::Method method, std::string_view extension = ".geojson");
  [[nodiscard]] std::vector<std::string> line_files(reconstruct::Method method) const;

  /// Throws IoError unless the images fit their cameras; see apps::check_pair().
  void check_pair();
  /// Of these images, all at once: of one image, what is traced in the order of lengths would keep one core only.
  void extract(std::span<const std::size_t> images);
  void match();
  /// Keeps points of the pair's surface. What an earlier run has left is taken away.
  /// @return the files written: none for a pair without a surface
  [[nodiscard]] std::vector<std::string> keep_surface();
  void reconstruct(reconstruct::Method method);
  [[nodiscard]] PatchCounts counts() const;
  /// Rows of Table 1, one per matcher and one of both, if the patch has reference
  /// matches; verdicts.csv has what each of them is.
  [[nodiscard]] std::vector<evaluate::Table1Row> score_matches() const;

 private:
  [[nodiscard]] std::vector<std::string> segment_files() const;
  [[nodiscard]] std::vector<std::string> list_names() const;
  [[nodiscard]] std::vector<io::LineFormatInfo> more_line_formats() const;
  void remove_match_lists() const;
  /// Throws IoError if the file is an input.
  [[nodiscard]] std::string path(const std::string& file) const;
  void read_images();
  [[nodiscard]] std::array<std::vector<EdgeSegment>, 2> segments() const;
  /// The pair with the segments of one file an image.
  reconstruct::StereoPair pair(const std::vector<std::string>& files);
  const std::optional<reconstruct::Surface>& surface(const reconstruct::StereoPair& pair);

  const io::PatchFile& patch_;
  const RunOptions& options_;
  const results::OutputFolder& out_;
  reconstruct::Scene scene_;  ///< images are read when first needed
  std::optional<std::optional<reconstruct::Surface>> surface_;  ///< computed when first needed
};

}  // namespace ridgeline::apps
