// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/common/outcome.h"
#include "apps/run/patch_run.h"
#include "reconstruct/geometry/edge_segment.h"
#include "reconstruct/geometry/line_match.h"
#include "reconstruct/geometry/local_frame.h"

#include <opencv2/core/mat.hpp>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::apps {

/// The stages of a reconstruction with their files. Every stage reads what it needs from the files
/// of the stages before it, unless they ran in this object.
class PatchStages {
 public:
  /// The files are in the subfolder of `out` that is named after the patch's id.
  PatchStages(const io::PatchFile& patch,
              const RunOptions& options,
              const results::OutputFolder& out);

  [[nodiscard]] const LocalFrame& frame() const { return frame_; }

  /// Throws IoError if one of the files that the stages write is an input.
  void check_outputs() const;

  [[nodiscard]] std::vector<std::string> segment_files() const;
  [[nodiscard]] std::vector<std::string> match_files() const;
  static std::string line_file(reconstruct::Method method, std::string_view extension = ".geojson");
  [[nodiscard]] std::vector<std::string> line_files(reconstruct::Method method) const;

  void extract();
  /// Keeps points of the pair's surface. What an earlier run has left is taken away.
  /// @return the files written: none for a pair without a surface
  [[nodiscard]] std::vector<std::string> keep_surface();
  void match();
  void reconstruct(reconstruct::Method method);
  [[nodiscard]] PatchCounts counts() const;
  /// Rows of Table 1, one per matcher and one of both, if the patch has reference
  /// matches; verdicts.csv has what each of them is.
  [[nodiscard]] std::vector<evaluate::Table1Row> score_matches() const;

 private:
  [[nodiscard]] std::vector<std::string> list_names() const;
  [[nodiscard]] std::vector<io::LineFormatInfo> more_line_formats() const;
  void remove_match_lists() const;
  /// Throws IoError if the file is an input.
  [[nodiscard]] std::string path(const std::string& file) const;
  const cv::Mat& image(std::size_t i);
  [[nodiscard]] std::array<std::vector<EdgeSegment>, 2> segments() const;
  reconstruct::StereoPair pair();
  const std::optional<reconstruct::Surface>& surface(const reconstruct::StereoPair& pair);

  const io::PatchFile& patch_;
  const RunOptions& options_;
  const results::OutputFolder& out_;
  LocalFrame frame_;
  std::array<cv::Mat, 2> images_;  ///< normalised; read when first needed
  std::optional<std::optional<reconstruct::Surface>> surface_;  ///< computed when first needed
};

}  // namespace ridgeline::apps
