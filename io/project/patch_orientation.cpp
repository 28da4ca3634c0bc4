// SPDX-License-Identifier: BSD-3-Clause
#include "io/project/patch_orientation.h"

#include "io/orientation/colmap.h"
#include "io/orientation/option_words.h"
#include "io/project/oriented_patch_image.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <stdexcept>

namespace ridgeline::io {
namespace fs = std::filesystem;
namespace {

std::string resolved(const fs::path& folder, const std::string& file) {
  return (folder / file).lexically_normal().string();
}

/// Interprets a word of the patch file. Throws IoError for an invalid word.
template <typename Meaning>
auto stated(const YamlMap& patch, const char* key, const Meaning& meaning, const char* known)
    -> decltype(meaning("")) {
  if (!patch.has(key)) return std::nullopt;
  const std::string word = patch.text(key);
  const auto value = meaning(word);
  if (!value) patch.fail(key, fmt::format("{} = {}; must be {}", key, word, known));
  return value;
}

/// The files of the images of an orientation, where they show the whole frame.
ImageFiles files_of(const Orientation& orientation, const std::vector<ImageToOrient>& images) {
  ImageFiles files(orientation.images.size());
  const ImageNames names(orientation);
  for (const ImageToOrient& image : images) {
    if (!image.is_whole) continue;
    try {
      files[names.at(image.name)] = image.path;
    } catch (const std::invalid_argument&) {
      continue;  // oriented() reports this
    }
  }
  return files;
}

std::vector<std::string> with_path(const std::string& path, const std::vector<std::string>& texts) {
  return transformed(texts, [&](const std::string& text) { return path + ": " + text; });
}

/// Images with the same id, i.e. the same name in different folders, get as many of their files'
/// folders in front of it as needed: "101MEDIA_DJI_0001".
void tell_ids_apart(std::vector<PatchImage>& images) {
  std::vector<fs::path> folders = transformed(
      images, [](const PatchImage& image) { return fs::path(image.path).parent_path(); });
  for (;;) {
    std::map<std::string, int> n_of_id;
    for (const PatchImage& image : images) ++n_of_id[image.id];
    bool any = false;
    for (std::size_t i = 0; i < images.size(); ++i) {
      if (n_of_id[images[i].id] == 1 || folders[i].filename().empty()) continue;
      images[i].id = folders[i].filename().string() + "_" + images[i].id;
      folders[i] = folders[i].parent_path();
      any = true;
    }
    if (!any) return;
  }
}

}  // namespace

PatchOrientation::PatchOrientation(const YamlMap& patch,
                                   const fs::path& folder,
                                   const Crs& crs,
                                   const std::vector<ImageToOrient>& images,
                                   const FindPatchPoints& find)
    : path_(resolved(folder, patch.text("orientation"))),
      cameras_(patch.has("cameras") ? resolved(folder, patch.text("cameras")) : "") {
  OrientationOptions options = stated_options(patch);
  options.crs = crs;
  if (find) {
    options.find_observations = [&](const Orientation& orientation) {
      return find(orientation, files_of(orientation, images));
    };
  }
  orientation_ = read_orientation(path_, options);
  names_.emplace(orientation_);
  compare_systems(patch, crs);
}

OrientationOptions PatchOrientation::stated_options(const YamlMap& patch) const {
  OrientationOptions options;
  options.cameras = cameras_;
  options.angles = stated(patch, "angles", angle_unit_named, "deg, gon or rad");
  options.rotation = stated(patch, "rotation", rotation_order_named, "opk or pok");
  options.matrix =
      stated(patch, "matrix", matrix_direction_named, "world_from_camera or camera_from_world");
  return options;
}

void PatchOrientation::compare_systems(const YamlMap& patch, const Crs& crs) {
  if (!crs.known() || !orientation_.crs.known()) return;
  const CrsAgreement agreement = compare(crs, orientation_.crs);
  if (!agreement.compatible) {
    patch.fail("crs",
               fmt::format("patch and orientation {} do not match: {}; transform one of them",
                           path_, agreement.reason));
  }
  if (!agreement.warning.empty()) orientation_.warnings.push_back(agreement.warning);
}

PatchImage PatchOrientation::oriented(const ImageToOrient& image,
                                      const Eigen::Vector2d& window_px) const {
  try {
    return with_camera(names_->at(image.name), image.path, window_px);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("orientation {} {}", path_, error.what()));
  }
}

PatchImage PatchOrientation::with_camera(std::size_t number,
                                         const std::string& path,
                                         const Eigen::Vector2d& window_px) const {
  const OrientedImage& image = orientation_.images[number];
  if (!image.camera) {
    throw std::invalid_argument(fmt::format(
        "does not define the camera of image {}; name a camera file with the key cameras",
        image.name));
  }
  return oriented_patch_image(orientation_, image, path, window_px);
}

OrientedFiles PatchOrientation::images_of(const std::vector<std::string>& files) const {
  OrientedFiles found;
  std::vector<std::string> file_of_image(orientation_.images.size());
  try {
    for (const std::string& file : files) {
      const std::optional<std::size_t> number = names_->find(file);
      if (!number) {
        found.unknown.push_back(file);
        continue;
      }
      std::string& other = file_of_image[*number];
      if (!other.empty()) {
        throw std::invalid_argument(
            fmt::format("has only one image, {}, for both {} and {}; narrow the pattern",
                        orientation_.images[*number].name, other, file));
      }
      other = file;
      found.images.push_back(with_camera(*number, file, Eigen::Vector2d::Zero()));
    }
    if (found.images.empty() && !files.empty()) {
      throw std::invalid_argument(fmt::format("has none of the {} image files, such as {}{}",
                                              files.size(), files.front(),
                                              names_->similar_names(files.front())));
    }
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("orientation {} {}", path_, error.what()));
  }
  tell_ids_apart(found.images);
  for (std::size_t i = 0; i < file_of_image.size(); ++i) {
    const OrientedImage& image = orientation_.images[i];
    if (file_of_image[i].empty() && image.camera)
      found.without_file.push_back(oriented_patch_image(orientation_, image, ""));
  }
  return found;
}

std::vector<std::string> PatchOrientation::files() const {
  std::vector<std::string> files =
      fs::is_directory(path_) ? colmap_files(path_) : std::vector{path_};
  std::ranges::copy(orientation_.files_beside, std::back_inserter(files));
  if (!cameras_.empty()) files.push_back(cameras_);
  return files;
}

std::vector<std::string> PatchOrientation::decisions() const {
  return with_path(path_, orientation_.decisions);
}

std::vector<std::string> PatchOrientation::warnings() const {
  return with_path(path_, orientation_.warnings);
}

}  // namespace ridgeline::io
