// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/image_writer.h"

#include "io/error.h"
#include "io/files/atomic_file.h"
#include "io/gdal/ogr_support.h"
#include "reconstruct/geometry/check.h"

#include <cpl_error.h>
#include <cpl_string.h>
#include <fmt/format.h>
#include <gdal_priv.h>

namespace ridgeline::io {
namespace {

GDALDatasetUniquePtr create(const std::string& path, const cv::Mat& image) {
  register_gdal_drivers();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  CPLStringList options;
  options.SetNameValue("COMPRESS", "DEFLATE");
  options.SetNameValue("PREDICTOR", "2");
  options.SetNameValue("INTERLEAVE", "PIXEL");
  options.SetNameValue("PHOTOMETRIC", image.channels() >= 3 ? "RGB" : "MINISBLACK");
  const GDALDataType type = image.depth() == CV_8U ? GDT_Byte : GDT_UInt16;
  return GDALDatasetUniquePtr(driver == nullptr
                                  ? nullptr
                                  : driver->Create(path.c_str(), image.cols, image.rows,
                                                   image.channels(), type, options.List()));
}

CPLErr write_pixels(GDALDataset& dataset, const cv::Mat& image) {
  const GDALDataType type = image.depth() == CV_8U ? GDT_Byte : GDT_UInt16;
  cv::Mat pixels = image;  // RasterIO takes no constant buffer
  return dataset.RasterIO(
      GF_Write, 0, 0, image.cols, image.rows, pixels.data, image.cols, image.rows, type,
      image.channels(), nullptr, static_cast<GSpacing>(image.elemSize()),
      static_cast<GSpacing>(image.step[0]), static_cast<GSpacing>(image.elemSize1()), nullptr);
}

}  // namespace

void write_tiff(const std::string& path, const cv::Mat& image) {
  const bool known_depth = image.depth() == CV_8U || image.depth() == CV_16U;
  check(!image.empty() && image.dims == 2, "write_tiff: image is empty");
  check(known_depth && image.channels() <= 4, "write_tiff: OpenCV type ", image.type(),
        ", must be 8 or 16 bit unsigned with 1 to 4 bands");
  AtomicFile file(path);
  CPLErrorReset();
  GDALDatasetUniquePtr dataset = create(file.temporary_path(), image);
  bool good = dataset != nullptr && write_pixels(*dataset, image) == CE_None;
  dataset.reset();  // what is still buffered is written here, and fails here
  good = good && CPLGetLastErrorType() < CE_Failure;
  if (!good) throw IoError(path, fmt::format("could not be written: {}", CPLGetLastErrorMsg()));
  file.commit();
}

}  // namespace ridgeline::io
