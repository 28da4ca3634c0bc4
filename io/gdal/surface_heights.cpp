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
#include <cstdint>
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

struct Cells {
  int column = 0, row = 0;    ///< of the first one
  int width = 0, height = 0;  ///< more than 0
};

/// The values of cells, or of evenly distributed ones if there are many.
template <typename T>
std::vector<T> values_of(GDALRasterBand& band,
                         const Cells& cells,
                         GDALDataType type,
                         const std::string& path,
                         const QuietGdal& quiet) {
  constexpr int kMaxSide_px = 2000;
  const int width = std::min(cells.width, kMaxSide_px);
  const int height = std::min(cells.height, kMaxSide_px);
  std::vector<T> values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  if (band.RasterIO(GF_Read, cells.column, cells.row, cells.width, cells.height, values.data(),
                    width, height, type, 0, 0, nullptr) != CE_None)
    throw IoError(path, "cannot be decoded: " + quiet.complaints("its cells are damaged"));
  return values;
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

bool is_possible_height(double height_m) {
  constexpr double kMinPossible_m = -500.0;  // the shore of the Dead Sea is at -440 m
  constexpr double kMaxPossible_m = 9000.0;
  return height_m >= kMinPossible_m && height_m <= kMaxPossible_m;
}

SurfaceHeights read_surface_heights(const std::string& path, const Eigen::AlignedBox2d& bounds) {
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
  SurfaceHeights found{{}, 0, crs_of(dataset->GetSpatialRef())};
  const CrsFacts crs = describe(found.crs);
  const double unit_m = crs.vertical_name.empty() ? 1.0 : crs.vertical_unit_m;
  const Cells cells{columns[0], rows[0], columns[1] - columns[0], rows[1] - rows[0]};
  if (cells.width <= 0 || cells.height <= 0) return found;
  GDALRasterBand& band = *dataset->GetRasterBand(1);
  const std::vector<double> heights = values_of<double>(band, cells, GDT_Float64, path, quiet);
  const std::vector<std::uint8_t> is_stated =
      values_of<std::uint8_t>(*band.GetMaskBand(), cells, GDT_Byte, path, quiet);
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (is_stated[i] == 0 || std::isnan(heights[i])) continue;
    const double height_m = unit_m * heights[i];
    if (is_possible_height(height_m)) {
      found.heights_m.push_back(height_m);
    } else {
      ++found.n_impossible;
    }
  }
  return found;
}

}  // namespace ridgeline::io
