// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/als.h"

#include "apps/simulate/flight_plan.h"
#include "apps/simulate/random.h"
#include "apps/simulate/ray_scene.h"
#include "reconstruct/geometry/check.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <vector>

namespace ridgeline::simulate {
namespace {

enum AlsStream : std::uint64_t { kPulseStream = 100, kStripStream };

constexpr std::uint8_t kOutlierClass = 7;
constexpr std::uint8_t kWithheldFlag = 4;

struct Reflectance {
  std::uint8_t classification;
  double intensity;
};

Reflectance reflectance(Material material) {
  switch (material) {
    case Material::kGround:
      return {2, 900.0};
    case Material::kStreet:
      return {2, 400.0};
    case Material::kMarking:
      return {2, 1500.0};
    case Material::kRoof:
      return {6, 700.0};
    case Material::kGutter:
      return {6, 800.0};
    case Material::kWall:
      return {6, 1000.0};
    case Material::kChimney:
      return {6, 600.0};
    case Material::kFoliage:
      return {5, 500.0};
    case Material::kWood:
      return {1, 450.0};
    case Material::kGlass:
    case Material::kFrame:
    case Material::kSolar:
    case Material::kPaving:
    case Material::kCar:
      return {1, 1200.0};
    case Material::kGardenWall:
      return {1, 1000.0};
  }
  return {0, 0.0};
}

constexpr double kFoliagePassShare = 0.6;  ///< share of the pulses that pass through a leaf

const AlsOptions& checked(const AlsOptions& o) {
  const auto in = [](const char* name, double value, double low, double high) {
    check(value >= low && value <= high, name, " = ", value, ", must be in [", low, ", ", high,
          "]");
  };
  in("density_per_m2", o.density_per_m2, 0.01, 1000.0);
  in("height_above_ground_m", o.height_above_ground_m, 100.0, 5000.0);
  in("half_scan_angle_deg", o.half_scan_angle_deg, 1.0, 40.0);
  in("strip_overlap", o.strip_overlap, 0.0, 0.9);
  in("range_sigma_m", o.range_sigma_m, 0.0, 10.0);
  in("cross_sigma_m", o.cross_sigma_m, 0.0, 10.0);
  in("footprint_m", o.footprint_m, 0.0, 10.0);
  in("strip_offset_sigma_m", o.strip_offset_sigma_m, 0.0, 10.0);
  in("max_returns", o.max_returns, 1, 15);
  in("outlier_share", o.outlier_share, 0.0, 1.0);
  in("withheld_share", o.withheld_share, 0.0, 1.0);
  return o;
}

}  // namespace

class AlsScanner::Impl {
 public:
  Impl(const SyntheticScene& scene, const AlsOptions& options)
      : scene_(scene), options_(checked(options)), plan_(scene, options), rays_(scene.mesh) {
    for (const Eigen::Vector3d& vertex : scene.mesh.vertices) {
      top_z_m_ = std::max(top_z_m_, vertex.z());
    }
    for (int s = 0; s < plan_.num_strips(); ++s) {
      Random random({options.seed, kStripStream, static_cast<std::uint64_t>(s)});
      const Eigen::Vector3d offset{random.normal(), random.normal(), random.normal()};
      offsets_m_.emplace_back(options.strip_offset_sigma_m * offset);
    }
  }

  [[nodiscard]] io::PointCloud scan(const Eigen::AlignedBox2d& window_m) const {
    const auto num_lines = static_cast<std::size_t>(plan_.num_lines());
    const std::size_t total = num_lines * static_cast<std::size_t>(plan_.num_strips());
    std::vector<std::vector<io::CloudPoint>> lines(total);
    const auto scan_range = [&](const tbb::blocked_range<std::size_t>& range) {
      for (std::size_t i = range.begin(); i < range.end(); ++i) {
        lines[i] =
            scan_line(static_cast<int>(i / num_lines), static_cast<int>(i % num_lines), window_m);
      }
    };
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, total), scan_range);

    io::PointCloud cloud;
    cloud.frame = scene_.frame;
    cloud.crs = scene_.crs;
    for (const auto& line : lines) cloud.n_read += line.size();
    cloud.points.reserve(cloud.n_read);
    for (const auto& line : lines) {
      cloud.points.insert(cloud.points.end(), line.begin(), line.end());
    }
    return cloud;
  }

 private:
  struct Return {
    double distance_m;
    Material material;
  };

  [[nodiscard]] std::vector<io::CloudPoint> scan_line(int strip,
                                                      int line,
                                                      const Eigen::AlignedBox2d& window_m) const {
    std::vector<io::CloudPoint> points;
    const FlightPlan::PulseRange pulses = plan_.pulses_near(strip, line, window_m);
    for (int pulse = pulses.first; pulse < pulses.last; ++pulse) {
      Random random({options_.seed, kPulseStream, static_cast<std::uint64_t>(strip),
                     static_cast<std::uint64_t>(line), static_cast<std::uint64_t>(pulse)});
      scan_pulse(strip, plan_.pulse(strip, line, pulse, random), random, points);
    }
    std::erase_if(points, [&](const io::CloudPoint& p) {
      return !window_m.contains(Eigen::Vector2d(p.x, p.y));
    });
    return points;
  }

  void scan_pulse(int strip,
                  const Pulse& pulse,
                  Random& random,
                  std::vector<io::CloudPoint>& out) const {
    const Eigen::Vector3d direction = (pulse.target_m - pulse.origin_m).normalized();
    if (random.chance(options_.outlier_share)) {
      const double height_m = random.uniform(-15.0, kMaxOutlierHeightM);
      const Eigen::Vector3d x = pulse.target_m - direction * (height_m / -direction.z());
      append(x, {kOutlierClass, 100.0}, strip, 1, 1, random, out);
      return;
    }
    const std::vector<Return> returns = trace(pulse.origin_m, direction, random);
    for (std::size_t i = 0; i < returns.size(); ++i) {
      const Eigen::Vector3d x = pulse.origin_m + direction * returns[i].distance_m +
                                noise(direction, random) +
                                offsets_m_[static_cast<std::size_t>(strip)];
      append(x, reflectance(returns[i].material), strip, i + 1, returns.size(), random, out);
    }
  }

  std::vector<Return> trace(const Eigen::Vector3d& origin,
                            const Eigen::Vector3d& direction,
                            Random& random) const {
    constexpr double kDeadTimeM = 0.3;  // the receiver's dead time: closer surfaces give one return
    std::vector<Return> returns;
    // the ray starts just above the scene, where float resolves a hundredth of a millimetre
    const double skipped_m = std::max(0.0, (origin.z() - top_z_m_ - 1.0) / -direction.z());
    const Eigen::Vector3d start = origin + skipped_m * direction;
    double from_m = 0.0;
    while (static_cast<int>(returns.size()) < options_.max_returns) {
      const auto hit = rays_.first_hit(start, direction, from_m);
      if (!hit) break;
      const Material material =
          scene_.mesh.triangles[static_cast<std::size_t>(hit->triangle)].material;
      returns.push_back({skipped_m + hit->distance_m, material});
      if (material != Material::kFoliage || !random.chance(kFoliagePassShare)) break;
      from_m = hit->distance_m + kDeadTimeM;
    }
    return returns;
  }

  Eigen::Vector3d noise(const Eigen::Vector3d& direction, Random& random) const {
    const Eigen::Vector3d a = direction.unitOrthogonal();
    const Eigen::Vector3d b = direction.cross(a);
    const double along = options_.range_sigma_m * random.normal();
    const double cross_a = options_.cross_sigma_m * random.normal();
    const double cross_b = options_.cross_sigma_m * random.normal();
    return along * direction + cross_a * a + cross_b * b;
  }

  void append(const Eigen::Vector3d& x,
              const Reflectance& look,
              int strip,
              std::size_t number,
              std::size_t count,
              Random& random,
              std::vector<io::CloudPoint>& out) const {
    const double speckle = 1.0 + 0.1 * random.normal();
    const bool withheld = random.chance(options_.withheld_share);
    out.push_back({.x = x.x(),
                   .y = x.y(),
                   .z = x.z(),
                   .intensity = static_cast<std::uint16_t>(
                       std::clamp(look.intensity * speckle, 0.0, 65535.0)),
                   .classification = look.classification,
                   .return_number = static_cast<std::uint8_t>(number),
                   .number_of_returns = static_cast<std::uint8_t>(count),
                   .flags = withheld ? kWithheldFlag : std::uint8_t{0},
                   .source_id = static_cast<std::uint16_t>(strip + 1)});
  }

  const SyntheticScene& scene_;
  AlsOptions options_;
  FlightPlan plan_;
  RayScene rays_;
  double top_z_m_ = -1e9;
  std::vector<Eigen::Vector3d> offsets_m_;  // systematic shift of each strip
};

AlsScanner::AlsScanner(const SyntheticScene& scene, const AlsOptions& options)
    : impl_(std::make_unique<Impl>(scene, options)) {}

AlsScanner::~AlsScanner() = default;
AlsScanner::AlsScanner(AlsScanner&&) noexcept = default;
AlsScanner& AlsScanner::operator=(AlsScanner&&) noexcept = default;

io::PointCloud AlsScanner::scan(const Eigen::AlignedBox2d& window_m) const {
  return impl_->scan(window_m);
}

io::PointCloud scan_als(const SyntheticScene& scene, const AlsOptions& options) {
  return AlsScanner(scene, options).scan({Eigen::Vector2d::Zero(), scene.extent_m});
}

}  // namespace ridgeline::simulate
