// SPDX-License-Identifier: BSD-3-Clause
#include "tests/other_scenes/photograph.h"

#include "tests/other_scenes/random_stream.h"
#include "tests/other_scenes/textures.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace ridgeline::other {
namespace {

using Eigen::Vector3d;

constexpr int kRays = 3;  ///< a pixel, along columns and along rows
const Vector3d kSun(1.0, 0.95, 0.86);
const Vector3d kSky(0.20, 0.235, 0.29);

/// What a ray sees.
struct Sight {
  Vector3d x, normal, reflectance;
  double gloss = 0.0;
};

/// Texture coordinates of a face: see Face.
struct FaceAxes {
  Vector3d origin, u, v, normal;
};

FaceAxes axes_of(const Face& face) {
  const Vector3d normal = normal_of(face);
  const Vector3d u = (face.corners[1] - face.corners[0]).normalized();
  return {face.corners[0], u, normal.cross(u), normal};
}

/// The disc of the sun, half a degree wide, a point of it for each ray of a pixel.
Vector3d sun_point(const Vector3d& to_sun, int sample) {
  constexpr double kRadius_rad = 0.0046, kGoldenAngle_rad = 2.399963;
  const double radius = kRadius_rad * std::sqrt((sample + 0.5) / (kRays * kRays));
  const double angle = kGoldenAngle_rad * sample;
  const Vector3d u = to_sun.unitOrthogonal();
  const Vector3d v = to_sun.cross(u);
  return to_sun + radius * (std::cos(angle) * u + std::sin(angle) * v);
}

class Shader {
 public:
  Shader(const Scene& scene, const RayTracer& tracer) : scene_(scene), tracer_(tracer) {
    for (const Face& face : scene.faces) axes_.push_back(axes_of(face));
    for (int i = 0; i < kRays * kRays; ++i) sun_points_.push_back(sun_point(scene.to_sun, i));
  }

  [[nodiscard]] Vector3d light_along(const Ray& ray, int sample) const {
    constexpr double kFar = 1e4;
    const auto hit = tracer_.first_hit(ray, 0.0, kFar);
    if (!hit) return kSky;
    Sight sight = hit->face >= 0 ? face_sight(*hit, ray) : leaf_sight(*hit, ray);
    if (sight.normal.dot(ray.direction) > 0.0) sight.normal = -sight.normal;
    return lit(sight, ray, sample);
  }

 private:
  [[nodiscard]] Sight face_sight(const Hit& hit, const Ray& ray) const {
    const Look& look = scene_.faces[hit.face].look;
    const FaceAxes& axes = axes_[hit.face];
    const Vector3d x = ray.origin + hit.distance * ray.direction;
    const Vector3d from_origin = x - axes.origin;
    const Vector3d colour =
        look.material == Material::kGround
            ? ground_reflectance(scene_, x.head<2>())
            : reflectance(look, axes.u.dot(from_origin), axes.v.dot(from_origin));
    return {x, axes.normal, colour, gloss(look.material)};
  }

  [[nodiscard]] Sight leaf_sight(const Hit& hit, const Ray& ray) const {
    const Ellipsoid& e = scene_.ellipsoids[hit.ellipsoid];
    const Vector3d x = ray.origin + hit.distance * ray.direction;
    const Vector3d normal =
        (x - e.centre).cwiseQuotient(e.radii.cwiseProduct(e.radii)).normalized();
    return {x, normal, leaf_reflectance(e.look, x), 0.0};
  }

  [[nodiscard]] Vector3d lit(const Sight& sight, const Ray& ray, int sample) const {
    constexpr double kOff_m = 1e-3, kReach_m = 100.0;
    const double cosine = sight.normal.dot(scene_.to_sun);
    // the lower sky is partly hidden by what stands around
    const double sky = 0.55 + 0.45 * sight.normal.z();
    Vector3d sum = sky * sight.reflectance.cwiseProduct(kSky) + 0.8 * sight.gloss * kSky;
    if (cosine <= 0.0) return sum;
    const Vector3d start = sight.x + kOff_m * sight.normal;
    if (tracer_.is_blocked({start, sun_points_[sample]}, 0.0, kReach_m)) return sum;
    const Vector3d towards_eye = -ray.direction.normalized();
    const Vector3d half = (scene_.to_sun + towards_eye).normalized();
    const double mirror = sight.gloss * 2.0 * std::pow(std::max(0.0, half.dot(sight.normal)), 40.0);
    sum += cosine * sight.reflectance.cwiseProduct(kSun) + mirror * kSun;
    return sum;
  }

  const Scene& scene_;
  const RayTracer& tracer_;
  std::vector<FaceAxes> axes_;
  std::vector<Vector3d> sun_points_;
};

/// Keeps each colour where its filter (red green / green blue) lets it through; elsewhere it is the
/// mean of its neighbours.
cv::Mat through_filters(const cv::Mat& image) {
  const cv::Matx33f cross(0, 1, 0, 1, 4, 1, 0, 1, 0);
  const cv::Matx33f square(1, 2, 1, 2, 4, 2, 1, 2, 1);
  std::array<cv::Mat, 3> colours;
  cv::split(image, colours.data());
  for (int i = 0; i < 3; ++i) {
    cv::Mat& colour = colours[i];
    for (int row = 0; row < image.rows; ++row) {
      for (int column = 0; column < image.cols; ++column) {
        if (row % 2 + column % 2 != i) colour.at<unsigned char>(row, column) = 0;
      }
    }
    // beyond the border the image is mirrored at its last pixels, so each filter keeps its places
    cv::filter2D(colour, colour, -1, (i == 1 ? cross : square) * 0.25F);
  }
  cv::Mat result;
  cv::merge(colours.data(), colours.size(), result);
  return result;
}

cv::Mat through_jpeg(const cv::Mat& image, int quality) {
  cv::Mat blue_first;
  cv::cvtColor(image, blue_first, cv::COLOR_RGB2BGR);
  std::vector<unsigned char> file;
  cv::imencode(".jpg", blue_first, file, {cv::IMWRITE_JPEG_QUALITY, quality});
  cv::Mat result;
  cv::cvtColor(cv::imdecode(file, cv::IMREAD_COLOR), result, cv::COLOR_BGR2RGB);
  return result;
}

}  // namespace

cv::Mat light(const Scene& scene, const RayTracer& tracer, const AerialCamera& camera) {
  const Shader shader(scene, tracer);
  cv::Mat image(camera.rows, camera.columns, CV_32FC3);
  tbb::parallel_for(0, camera.rows, [&](int row) {
    for (int column = 0; column < camera.columns; ++column) {
      Vector3d sum = Vector3d::Zero();
      for (int i = 0; i < kRays * kRays; ++i) {
        const int i_row = i / kRays;
        const int i_column = i % kRays;
        const Eigen::Vector2d x_px(column - 0.5 + (i_column + 0.5) / kRays,
                                   row - 0.5 + (i_row + 0.5) / kRays);
        sum += shader.light_along(camera.ray(x_px), i * 4 % (kRays * kRays));
      }
      const Eigen::Vector3f mean = (sum / (kRays * kRays)).cast<float>();
      image.at<cv::Vec3f>(row, column) = {mean.x(), mean.y(), mean.z()};
    }
  });
  return image;
}

cv::Mat expose(const cv::Mat& light, const Film& film) {
  cv::Mat blurred;
  cv::GaussianBlur(light, blurred, {0, 0}, film.blur_sigma_px);
  cv::Mat image(light.size(), CV_8UC3);
  RandomStream random(film.seed);
  for (int row = 0; row < light.rows; ++row) {
    for (int column = 0; column < light.cols; ++column) {
      for (int band = 0; band < 3; ++band) {
        const double full = std::max(0.0, film.gain * blurred.at<cv::Vec3f>(row, column)[band]);
        const double sigma = std::hypot(film.read_noise, film.photon_noise * std::sqrt(full));
        const double seen = std::max(0.0, full + film.offset + random.normal(sigma));
        const double value = 255.0 * std::pow(seen, film.gamma);
        image.at<cv::Vec3b>(row, column)[band] =
            static_cast<unsigned char>(std::clamp(std::lround(value), 0L, 255L));
      }
    }
  }
  if (film.bayer) image = through_filters(image);
  return film.jpeg_quality > 0 ? through_jpeg(image, film.jpeg_quality) : image;
}

}  // namespace ridgeline::other
