// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/common_crs.h"

#include "io/error.h"

#include <fmt/format.h>

namespace ridgeline::io {

namespace {

[[noreturn]] void refuse_degrees(const std::string& path, const std::string& name) {
  throw IoError(path,
                fmt::format("reference system \"{}\" is geographic (degrees); a projected one "
                            "in metres or feet is needed",
                            name));
}

CommonCrs assumed(std::span<const CloudFileInfo> files, const Crs& crs) {
  const CrsFacts facts = describe(crs);
  if (facts.is_geographic) refuse_degrees(files.front().path, facts.name);
  CommonCrs common;
  common.crs = crs;
  common.unit_m.assign(files.size(),
                       {facts.horizontal_unit_m, facts.horizontal_unit_m, facts.vertical_unit_m});
  for (const CloudFileInfo& info : files) {
    const CrsAgreement agreement = compare(info.crs, crs);
    if (agreement.compatible) continue;
    common.warnings.push_back(
        fmt::format("{}: the assumed reference system overrides that of the file: {}", info.path,
                    agreement.reason));
  }
  return common;
}

/// The units for messages: "US survey foot (0.304800609601 m)", with the unit of the heights if it
/// differs.
std::string units_text(const Eigen::Vector3d& unit_m) {
  if (same_unit(unit_m.x(), unit_m.z())) return unit_text(unit_m.x());
  return fmt::format("{} in plan and {} in height", unit_text(unit_m.x()), unit_text(unit_m.z()));
}

const CloudFileInfo* first_known(std::span<const CloudFileInfo> files) {
  for (const CloudFileInfo& info : files) {
    if (info.crs.known()) return &info;
  }
  return nullptr;
}

void check_agreement(const CloudFileInfo& info,
                     const CloudFileInfo& reference,
                     std::vector<std::string>& warnings) {
  // Tiles of one survey state the same text, and PROJ takes milliseconds per comparison.
  const bool same_text = reference.crs.definition == info.crs.definition;
  const CrsAgreement agreement = same_text ? CrsAgreement{} : compare(reference.crs, info.crs);
  if (!agreement.compatible) {
    throw IoError(info.path,
                  fmt::format("does not match {}: {}", reference.path, agreement.reason));
  }
  if (!agreement.warning.empty()) {
    warnings.push_back(
        fmt::format("{}: beside {}: {}", info.path, reference.path, agreement.warning));
  }
  const bool states_units = info.crs.known() || info.unit_m != Eigen::Vector3d::Ones();
  if (states_units && info.unit_m != reference.unit_m) {
    throw IoError(info.path,
                  fmt::format("does not match {}: its unit keys give other units", reference.path));
  }
}

}  // namespace

CommonCrs find_common_crs(std::span<const CloudFileInfo> files, const Crs& assume_crs) {
  if (assume_crs.known()) return assumed(files, assume_crs);
  CommonCrs common;
  const CloudFileInfo* const reference = first_known(files);
  if (reference == nullptr) {
    for (const CloudFileInfo& info : files) {
      common.unit_m.push_back(info.unit_m);
      if (info.has_sure_unit) continue;
      common.warnings.push_back(
          fmt::format("{}: has no reference system; assuming that its coordinates are in {}",
                      info.path, units_text(info.unit_m)));
    }
    return common;
  }
  if (reference->is_geographic) refuse_degrees(reference->path, describe(reference->crs).name);
  common.crs = reference->crs;
  common.unit_m.assign(files.size(), reference->unit_m);
  for (const CloudFileInfo& info : files) {
    if (&info != reference) check_agreement(info, *reference, common.warnings);
  }
  return common;
}

}  // namespace ridgeline::io
