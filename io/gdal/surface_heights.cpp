// SPDX-License-Identifier: BSD-3-Clause
#include "io/gdal/surface_heights.h"

#include "io/error.h"
#include "io/gdal/ogr_support.h"

#include <cpl_string.h>
#include <fmt/format.h>
#include <gdal_priv.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

namespace ridgeline::io {
namespace {

GDALDatasetUniquePtr open_raster(const std::string& path, const QuietGdal& quiet) {
  if (!std::filesystem::exists(path)) throw MissingFileError(path, "does not exist");
  register_gdal_drivers();
  const char* const drivers[] = {"GTiff", "AAIGrid", nullptr};
  GDALDatasetUniquePtr dataset(
      GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers));
  if (!dataset) {
    throw IoError(path, "is not a readable surface model (GeoTIFF or ASCII grid): " +
                            quiet.complaints("the content has none of these formats"));
  }
  if (dataset->GetRasterCount() != 1)
    throw IoError(path,
                  fmt::format("has {} bands; a surface model must have a single band of heights",
                              dataset->GetRasterCount()));
  return dataset;
}

/// First cell and end of the cells whose centres lie within [low, high], where the centre of cell i
/// is at origin + (i + 1/2) step.
std::array<int, 2> cells_within(double origin, double step, double low, double high, int n) {
  const double a = (low - origin) / step - 0.5;
  const double b = (high - origin) / step - 0.5;
  const auto inside = [n](double cell) {
    return static_cast<int>(std::clamp(cell, 0.0, double(n)));
  };
  return {inside(std::ceil(std::min(a, b))), inside(std::floor(std::max(a, b)) + 1.0)};
}

}  // namespace

std::vector<std::string> files_beside_surface_model(const std::string& path) {
  const QuietGdal quiet;
  const CPLStringList all(open_raster(path, quiet)->GetFileList());
  std::vector<std::string> beside;
  for (int i = 0; i < all.size(); ++i) {
    if (all[i] != path) beside.emplace_back(all[i]);
  }
  return beside;
}

SurfaceHeights read_surface_heights(const std::string& path, const Eigen::AlignedBox2d& bounds) {
  constexpr int kMaxSide_px = 2000;
  const QuietGdal quiet;
  const GDALDatasetUniquePtr dataset = open_raster(path, quiet);
  std::array<double, 6> t{};  // x = t0 + t1 column + t2 row, y = t3 + t4 column + t5 row
  if (dataset->GetGeoTransform(t.data()) != CE_None || t[2] != 0.0 || t[4] != 0.0 || t[1] == 0.0 ||
      t[5] == 0.0)
    throw IoError(path, "has no georeference, or a rotated one");
  const auto columns =
      cells_within(t[0], t[1], bounds.min().x(), bounds.max().x(), dataset->GetRasterXSize());
  const auto rows =
      cells_within(t[3], t[5], bounds.min().y(), bounds.max().y(), dataset->GetRasterYSize());
  const int width = columns[1] - columns[0];
  const int height = rows[1] - rows[0];
  SurfaceHeights found{{}, crs_of(dataset->GetSpatialRef())};
  GDALRasterBand& band = *dataset->GetRasterBand(1);
  if (width > 0 && height > 0) {
    const int read_width = std::min(width, kMaxSide_px);
    const int read_height = std::min(height, kMaxSide_px);
    std::vector<double> cells(static_cast<std::size_t>(read_width) *
                              static_cast<std::size_t>(read_height));
    if (band.RasterIO(GF_Read, columns[0], rows[0], width, height, cells.data(), read_width,
                      read_height, GDT_Float64, 0, 0, nullptr) != CE_None)
      throw IoError(path, "cannot be decoded: " + quiet.complaints("its cells are damaged"));
    int has_no_data = 0;
    const double no_data = band.GetNoDataValue(&has_no_data);
    for (const double z : cells)
      if (std::isfinite(z) && !(has_no_data != 0 && z == no_data)) found.heights_m.push_back(z);
  }
  if (found.heights_m.empty())
    throw IoError(
        path, fmt::format("has no heights within x {:.1f} .. {:.1f}, y {:.1f} .. {:.1f}",
                          bounds.min().x(), bounds.max().x(), bounds.min().y(), bounds.max().y()));
  return found;
}

}  // namespace ridgeline::io
