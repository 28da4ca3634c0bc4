// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/gdal/ogr_support.h"
#include "io/images/image.h"

#include <gdal_priv.h>

#include <string>

namespace ridgeline::io {

/// Sets GDAL up for reading images, for one thread and the lifetime of the object.
class ImageSession {
 public:
  ImageSession();
  ~ImageSession();
  ImageSession(const ImageSession&) = delete;
  ImageSession& operator=(const ImageSession&) = delete;

  /// Throws IoError for anything but an image in a known format.
  [[nodiscard]] GDALDatasetUniquePtr open(const std::string& path) const;

  /// Throws IoError with GDAL's messages.
  [[noreturn]] void fail_to_decode(const std::string& path) const;

 private:
  QuietGdal quiet_;
};

/// Throws IoError for unsupported images; see image_facts().
ImageFacts facts_of(const std::string& path, GDALDataset& dataset);

}  // namespace ridgeline::io
