// SPDX-License-Identifier: BSD-3-Clause
#include "apps/pipeline/image_points.h"

#include "io/error.h"
#include "io/images/image.h"
#include "reconstruct/geometry/transformed.h"
#include "reconstruct/scene/normalised_image.h"
#include "reconstruct/scene/pair_check/point_matches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>

namespace ridgeline::apps {
namespace fs = std::filesystem;
namespace {

using ImagePair = std::array<std::size_t, 2>;

/// An image whose file and camera have the same aspect ratio.
struct CandidateImage {
  std::size_t image = 0;
  std::string file;
  int reduction = 1;  ///< applied when reading, because tie points do not need full resolution
  double camera_per_pixel = 1.0;  ///< pixels of the camera a pixel that is read
};

std::optional<CandidateImage> candidate_of(const io::Orientation& orientation,
                                           std::size_t number,
                                           const std::optional<std::string>& file) {
  constexpr double kMaxSize_mpx = 16.0;
  constexpr double kSameShape = 0.01;
  const io::OrientedImage& image = orientation.images[number];
  if (!file || !image.camera) return std::nullopt;
  const std::optional<Eigen::Vector2i>& size = orientation.cameras[*image.camera].interior.size_px;
  try {
    const io::ImageFacts facts = io::image_facts(*file);
    const Eigen::Vector2d file_px(facts.width_px, facts.height_px);
    if (!size) return std::nullopt;
    const Eigen::Vector2d scale = size->cast<double>().cwiseQuotient(file_px);
    if (std::abs(scale.x() / scale.y() - 1.0) > kSameShape) return std::nullopt;
    const int reduction =
        std::max(1, static_cast<int>(std::ceil(std::sqrt(file_px.prod() / (1e6 * kMaxSize_mpx)))));
    return CandidateImage{number, *file, reduction, reduction * scale.x()};
  } catch (const io::IoError&) {
    return std::nullopt;
  }
}

/// The candidates that have files, at most `most`.
std::vector<CandidateImage> candidates_of(const io::Orientation& orientation,
                                          const io::ImageFiles& files) {
  constexpr std::size_t kMaxCandidates = 200;
  std::vector<CandidateImage> found;
  for (std::size_t i = 0; i < orientation.images.size() && found.size() < kMaxCandidates; ++i) {
    if (auto candidate = candidate_of(orientation, i, files[i])) found.push_back(*candidate);
  }
  return found;
}

/// Pairs of candidates, the nearest first.
std::vector<ImagePair> nearest_pairs(const io::Orientation& orientation,
                                     const std::vector<CandidateImage>& candidates) {
  std::vector<std::pair<double, ImagePair>> pairs;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    for (std::size_t j = i + 1; j < candidates.size(); ++j) {
      const auto position = [&](std::size_t k) {
        return orientation.images[candidates[k].image].exterior.position_m;
      };
      pairs.emplace_back((position(i) - position(j)).norm(), ImagePair{i, j});
    }
  }
  std::ranges::sort(pairs);
  std::vector<ImagePair> sorted;
  sorted.reserve(pairs.size());
  for (const auto& [distance_m, pair] : pairs) sorted.push_back(pair);
  return sorted;
}

Eigen::Vector2d in_camera_px(const CandidateImage& candidate, const Eigen::Vector2d& x_px) {
  const Eigen::Vector2d half(0.5, 0.5);
  return candidate.camera_per_pixel * (x_px + half) - half;
}

std::vector<reconstruct::PointMatch> matches_of(const CandidateImage& a, const CandidateImage& b) {
  try {
    return reconstruct::match_points(
        {reconstruct::normalised_image(io::read_reduced_image(a.file, a.reduction)),
         reconstruct::normalised_image(io::read_reduced_image(b.file, b.reduction))});
  } catch (const io::IoError&) {
    return {};
  }
}

}  // namespace

std::optional<std::string> image_file_in(const std::string& folder,
                                         const io::OrientedImage& image) {
  const fs::path named = fs::path(folder) / io::file_name_of(image);
  std::error_code ignored;
  if (fs::is_regular_file(named, ignored)) return named.string();
  for (const char* ending : {".tif", ".TIF", ".tiff", ".jpg", ".JPG", ".jpeg", ".png"}) {
    const fs::path with_ending = named.string() + ending;
    if (fs::is_regular_file(with_ending, ignored)) return with_ending.string();
  }
  return std::nullopt;
}

std::vector<io::PointObservation> find_points_in_files(const io::Orientation& orientation,
                                                       const io::ImageFiles& files) {
  constexpr std::size_t kMaxPairs = 4;
  const std::vector<CandidateImage> candidates = candidates_of(orientation, files);
  std::vector<io::PointObservation> points;
  std::size_t n_points = 0;
  std::size_t n_pairs = 0;
  for (const auto& [i, j] : nearest_pairs(orientation, candidates)) {
    if (n_pairs++ == kMaxPairs) break;
    const CandidateImage& a = candidates[i];
    const CandidateImage& b = candidates[j];
    for (const reconstruct::PointMatch& match : matches_of(a, b)) {
      points.push_back({n_points, a.image, in_camera_px(a, match.x_px[0])});
      points.push_back({n_points, b.image, in_camera_px(b, match.x_px[1])});
      ++n_points;
    }
  }
  return points;
}

std::vector<io::PointObservation> find_image_points(const io::Orientation& orientation,
                                                    const std::string& folder) {
  return find_points_in_files(orientation,
                              transformed(orientation.images, [&](const io::OrientedImage& image) {
                                return image_file_in(folder, image);
                              }));
}

}  // namespace ridgeline::apps
