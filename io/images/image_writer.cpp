// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/image_writer.h"

#include "io/error.h"
#include "io/files/atomic_file.h"
#include "io/gdal/ogr_support.h"
#include "reconstruct/geometry/check.h"

#include <cpl_error.h>
#include <cpl_string.h>
#include <gdal_priv.h>

#include <string>

namespace ridgeline::io {
namespace {

CPLStringList options_of(TiffLayout layout, int channels) {
  CPLStringList options;
  if (layout == TiffLayout::kTiles) {
    const std::string side = std::to_string(kTile_px);
    options.SetNameValue("TILED", "YES");
    options.SetNameValue("BLOCKXSIZE", side.c_str());
    options.SetNameValue("BLOCKYSIZE", side.c_str());
  } else {
    options.SetNameValue("COMPRESS", "DEFLATE");
    options.SetNameValue("PREDICTOR", "2");
  }
  options.SetNameValue("INTERLEAVE", "PIXEL");
  options.SetNameValue("PHOTOMETRIC", channels >= 3 ? "RGB" : "MINISBLACK");
  return options;
}

GDALDataType gdal_type(int type) { return CV_MAT_DEPTH(type) == CV_8U ? GDT_Byte : GDT_UInt16; }

GDALDatasetUniquePtr create(const std::string& path,
                            const cv::Size& size_px,
                            int type,
                            TiffLayout layout) {
  register_gdal_drivers();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  const CPLStringList options = options_of(layout, CV_MAT_CN(type));
  return GDALDatasetUniquePtr(driver == nullptr ? nullptr
                                                : driver->Create(path.c_str(), size_px.width,
                                                                 size_px.height, CV_MAT_CN(type),
                                                                 gdal_type(type), options.List()));
}

CPLErr write_pixels(GDALDataset& dataset, int first_row, const cv::Mat& rows) {
  cv::Mat pixels = rows;  // RasterIO requires a non-const buffer
  return dataset.RasterIO(
      GF_Write, 0, first_row, rows.cols, rows.rows, pixels.data, rows.cols, rows.rows,
      gdal_type(rows.type()), rows.channels(), nullptr, static_cast<GSpacing>(rows.elemSize()),
      static_cast<GSpacing>(rows.step[0]), static_cast<GSpacing>(rows.elemSize1()), nullptr);
}

/// Writes and releases the pixels that GDAL has cached. GDALDataset::FlushCache() would also
/// rewrite the header.
CPLErr flush_pixels(GDALDataset& dataset) {
  for (int band = 1; band <= dataset.GetRasterCount(); ++band) {
    if (dataset.GetRasterBand(band)->FlushCache(false) != CE_None) return CE_Failure;
  }
  return CE_None;
}

}  // namespace

struct TiffWriter::OpenFile {
  std::string path;
  cv::Size size_px;
  int type = 0;
  TiffLayout layout = TiffLayout::kStrips;
  AtomicFile file;
  GDALDatasetUniquePtr dataset;
  int next_row = 0;

  [[noreturn]] void fail(const QuietGdal& gdal) const {
    throw IoError(path, "could not be written: " + gdal.complaints("is the disk full?"));
  }
};

TiffWriter::TiffWriter(const std::string& path,
                       const cv::Size& size_px,
                       int type,
                       TiffLayout layout) {
  const bool known_depth = CV_MAT_DEPTH(type) == CV_8U || CV_MAT_DEPTH(type) == CV_16U;
  check(size_px.width > 0 && size_px.height > 0, "TiffWriter: image is empty");
  check(known_depth && CV_MAT_CN(type) <= 4, "TiffWriter: OpenCV type ", type,
        ", must be 8 or 16 bit unsigned with 1 to 4 bands");
  file_.reset(new OpenFile{path, size_px, type, layout, AtomicFile(path), nullptr, 0});
  const QuietGdal gdal;
  file_->dataset = create(file_->file.temporary_path(), size_px, type, layout);
  if (file_->dataset == nullptr) file_->fail(gdal);
}

TiffWriter::~TiffWriter() {
  const QuietGdal gdal;  // for a file that could not be written
  file_.reset();
}

void TiffWriter::write_rows(const cv::Mat& rows) {
  OpenFile& f = *file_;
  const int end_row = f.next_row + rows.rows;
  check(rows.type() == f.type && rows.cols == f.size_px.width && end_row <= f.size_px.height,
        "write_rows: ", rows.rows, " rows of ", rows.cols, " pixels after row ", f.next_row,
        ", must be rows of an image of ", f.size_px.height, " of ", f.size_px.width);
  check(f.layout == TiffLayout::kStrips || rows.rows % kTile_px == 0 || end_row == f.size_px.height,
        "write_rows: ", rows.rows, " rows, must be whole tiles of ", kTile_px);
  const QuietGdal gdal;
  bool good = write_pixels(*f.dataset, f.next_row, rows) == CE_None;
  if (f.layout == TiffLayout::kTiles) good = good && flush_pixels(*f.dataset) == CE_None;
  if (!good) f.fail(gdal);
  f.next_row = end_row;
}

void TiffWriter::commit() {
  check(file_->next_row == file_->size_px.height, "commit: ", file_->next_row, " rows, must be ",
        file_->size_px.height);
  const QuietGdal gdal;
  CPLErrorReset();
  file_->dataset.reset();  // buffered data are written here, so this is where writing can fail
  if (CPLGetLastErrorType() >= CE_Failure) file_->fail(gdal);
  file_->file.commit();
}

void write_tiff(const std::string& path, const cv::Mat& image) {
  check(image.dims == 2, "write_tiff: image is empty");
  TiffWriter writer(path, image.size(), image.type(), TiffLayout::kStrips);
  writer.write_rows(image);
  writer.commit();
}

}  // namespace ridgeline::io
