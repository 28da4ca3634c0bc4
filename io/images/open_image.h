// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/gdal/ogr_support.h"
#include "io/images/image.h"

#include <gdal_priv.h>

#include <string>

namespace ridgeline::io {

/// GDAL as images are read with it; for one thread, while the object lives.
class ImageSession {
 public:
  ImageSession();
  ~ImageSession();
  ImageSession(const ImageSession&) = delete;
  ImageSession& operator=(const ImageSession&) = delete;

  /// Throws IoError for what is no image of a known format.
  [[nodiscard]] GDALDatasetUniquePtr open(const std::string& path) const;

  /// Throws IoError with GDAL's complaints.
  [[noreturn]] void fail_to_decode(const std::string& path) const;

 private:
  QuietGdal quiet_;
};

/// Throws IoError for images that are not read; see image_facts().
ImageFacts facts_of(const std::string& path, GDALDataset& dataset);

}  // namespace ridgeline::io
