// SPDX-License-Identifier: BSD-3-Clause
#include "io/models/read_model.h"

#include "io/error.h"
#include "io/files/input_file.h"
#include "io/kinds/recognise.h"
#include "io/models/readers.h"
#include "io/text/gzip.h"
#include "io/text/utf8.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace ridgeline::io {
namespace {

constexpr std::size_t kMaxInflated_bytes = std::size_t{4} << 30U;

BuildingModel read(const std::string& path, const ReadModelOptions& options) {
  if (kind_of_path(path).ending == ".gml") return read_citygml(path, options);
  return read_cityjson(path, text_of_model(path), options);
}

/// A model without faces cannot be distinguished from one in another LoD.
void require_faces(const BuildingModel& model, const ReadModelOptions& options) {
  if (!model.faces.empty()) return;
  const std::string wanted =
      options.lod.empty() ? "LoD 1 to 3" : fmt::format("LoD {}", options.lod);
  throw IoError(model.path,
                fmt::format("has {} building{} without faces in {}{}{}", model.buildings.size(),
                            model.buildings.size() == 1 ? "" : "s", wanted,
                            model.left_out.empty() ? "" : "; it also has ", model.left_out.text()));
}

}  // namespace

std::string text_of_model(const std::string& path) {
  std::string text = read_input(path, FileGroup::kLines);
  if (is_gzip(text)) {
    Inflated all = inflated(text, kMaxInflated_bytes);
    if (!all.is_whole)
      throw IoError(path, all.text.size() < kMaxInflated_bytes
                              ? "is compressed with gzip and truncated"
                              : "is compressed with gzip and unpacks to more than 4 GiB");
    text = std::move(all.text);
  }
  text.erase(0, text.size() - without_byte_order_mark(text).size());
  return text;
}

bool is_model(const std::string& path) { return kind_of_path(path).group == FileGroup::kModel; }

BuildingModel read_model(const std::string& path, const ReadModelOptions& options) {
  BuildingModel model = read(path, options);
  require_faces(model, options);
  return model;
}

}  // namespace ridgeline::io
