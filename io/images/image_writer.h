// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <memory>
#include <string>

namespace ridgeline::io {

/// Layout of the pixels in a TIFF; bands are interleaved.
enum class TiffLayout : std::uint8_t {
  kStrips,  ///< groups of rows, deflate with a predictor
  kTiles,  ///< squares of kTile_px, uncompressed: a window of a large image can be read without the
           ///< rest
};

/// The side of a tile.
inline constexpr int kTile_px = 256;

/// Writes an image as TIFF from top to bottom, completely or not at all: without commit() no file
/// is left behind. A tiled image needs memory only for the rows that are written at once, whatever
/// its height.
class TiffWriter {
 public:
  /// `type`: CV_8UC(n) or CV_16UC(n), n = 1..4, with bands in file order. Throws IoError if the
  /// file cannot be written, std::invalid_argument for another type or an empty image.
  TiffWriter(const std::string& path, const cv::Size& size_px, int type, TiffLayout layout);
  ~TiffWriter();
  TiffWriter(const TiffWriter&) = delete;
  TiffWriter& operator=(const TiffWriter&) = delete;

  /// Writes the next rows, as wide as the image; for tiles their number must be a multiple of
  /// kTile_px, except at the end. Throws IoError if they cannot be written, std::invalid_argument
  /// for rows that do not fit as the next ones of the image.
  void write_rows(const cv::Mat& rows);

  /// Moves the file into place. Throws IoError if that fails, std::invalid_argument if rows are
  /// missing.
  void commit();

 private:
  struct OpenFile;
  std::unique_ptr<OpenFile> file_;
};

/// Writes an image in strips. Type of `image` and errors: as for TiffWriter.
void write_tiff(const std::string& path, const cv::Mat& image);

}  // namespace ridgeline::io
