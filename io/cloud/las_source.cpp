// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/las_source.h"

#include "io/cloud/las_crs.h"
#include "io/cloud/las_header.h"
#include "io/cloud/las_records.h"
#include "io/cloud/laz/laz_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

namespace ridgeline::io {

namespace {

class LasSource : public CloudSource {
 public:
  LasSource(MappedFile file, LasHeader header, CloudFileInfo file_info)
      : CloudSource(std::move(file_info)), file_(std::move(file)), header_(std::move(header)) {}

  [[nodiscard]] std::size_t n_blocks() const override {
    return (header_.n_points + kBlockSize - 1) / kBlockSize;
  }

  void decode_block(std::size_t block,
                    const LocalFromFile& local_from_file,
                    std::vector<CloudPoint>& points) const override {
    const std::span<const std::byte> records = records_of(block, 1);
    points.resize(records.size() / header_.record_length);
    decode_las_records(records, header_, local_from_file, points);
  }

  void release_blocks(std::size_t first, std::size_t count) const override {
    MappedFile::release(records_of(first, count));
  }

 private:
  [[nodiscard]] std::span<const std::byte> records_of(std::size_t block, std::size_t count) const {
    const std::uint64_t first = block * kBlockSize;
    const std::uint64_t n_records =
        std::min<std::uint64_t>(count * kBlockSize, header_.n_points - first);
    return file_.bytes().subspan(header_.point_offset + first * header_.record_length,
                                 n_records * header_.record_length);
  }

  static constexpr std::size_t kBlockSize = 16384;  // 512 KiB decoded: stays in a core's cache

  MappedFile file_;
  LasHeader header_;
};

CloudFileInfo las_info(const MappedFile& file, const std::string& path, const LasHeader& header) {
  LasCrs crs = read_las_crs(file.bytes(), header);
  CloudFileInfo info{
      .path = path,
      .format = fmt::format("{} 1.{}, point format {}", header.is_compressed() ? "LAZ" : "LAS",
                            header.version_minor, header.point_format),
      .crs = std::move(crs.crs),
      .unit_m = crs.unit_m,
      .is_geographic = crs.is_geographic,
      .n_points = header.n_points,
      .stated_bounds = Eigen::AlignedBox3d(header.stated_min, header.stated_max),
      .scale = header.scale,
      .offset = header.offset,
      .warnings = header.warnings};
  std::ranges::move(crs.warnings, std::back_inserter(info.warnings));
  if (header.version_minor == 0) {
    info.warnings.emplace_back("LAS 1.0 does not define the meaning of class codes");
  }
  return info;
}

}  // namespace

std::unique_ptr<CloudSource> open_las(MappedFile file,
                                      const std::string& path,
                                      const OpenCloudOptions& options) {
  LasHeader header = parse_las_header(file.bytes(), path, {.salvage = options.salvage});
  CloudFileInfo info = las_info(file, path, header);
  if (header.is_compressed()) {
    return open_laz(std::move(file), std::move(header), std::move(info), options);
  }
  return std::make_unique<LasSource>(std::move(file), std::move(header), std::move(info));
}

}  // namespace ridgeline::io
