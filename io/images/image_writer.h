// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <memory>
#include <string>

namespace ridgeline::io {

/// How the pixels of a TIFF lie in its file; bands are interleaved.
enum class TiffLayout : std::uint8_t {
  kStrips,  ///< some rows after another, deflate with a predictor
  kTiles,   ///< squares of kTile_px, not compressed: a window of a large image is read without the
            ///< rest
};

/// The side of a tile.
inline constexpr int kTile_px = 256;

/// Writes an image as TIFF from top to bottom, whole or not at all: without commit() nothing is
/// left. In tiles it needs the memory of the rows that are written at once, whatever the height of
/// the image.
class TiffWriter {
 public:
  /// `type`: CV_8UC(n) or CV_16UC(n), n = 1..4, the bands in the order of the file. Throws IoError
  /// if the file cannot be written, std::invalid_argument for another type or an empty image.
  TiffWriter(const std::string& path, const cv::Size& size_px, int type, TiffLayout layout);
  ~TiffWriter();
  TiffWriter(const TiffWriter&) = delete;
  TiffWriter& operator=(const TiffWriter&) = delete;

  /// The next rows, as wide as the image; in tiles a multiple of kTile_px but for the last ones.
  /// Throws IoError if they cannot be written, std::invalid_argument for rows that are not the next
  /// ones of the image.
  void write_rows(const cv::Mat& rows);

  /// Puts the file in place. Throws IoError if it cannot, std::invalid_argument if rows are
  /// missing.
  void commit();

 private:
  struct OpenFile;
  std::unique_ptr<OpenFile> file_;
};

/// Writes an image in strips. `image`, errors: as TiffWriter.
void write_tiff(const std::string& path, const cv::Mat& image);

}  // namespace ridgeline::io
