// SPDX-License-Identifier: BSD-3-Clause
// Orientations as programs wrote them; rays of real tie points and matrices of the same program are
// the judges.
#include "io/orientation/read_orientation.h"
#include "tests/support/paths.h"
#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <map>

namespace ridgeline::io {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string shared_folder(const std::string& name) { return test::shared_data_dir() + "/" + name; }

#define SKIP_WITHOUT(folder) \
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << (folder) << " is not there"

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::size_t number_of(const Orientation& orientation, const std::string& name) {
  const auto image = std::ranges::find(orientation.images, name, &OrientedImage::name);
  if (image == orientation.images.end()) throw std::runtime_error(name + " is not oriented");
  return static_cast<std::size_t>(image - orientation.images.begin());
}

/// The camera of Borea (focal length 30975 px, principal point at 13210, 8502 px from the corner)
/// as YAML.
std::string borea_camera(const TempFolder& folder) {
  return folder.write("camera.yaml",
                      "UCE-M3-f120-s06:\n  type: pinhole\n  im_size: [26460, 17004]\n"
                      "  focal_len: 1.1706349206349207\n  cx: -7.558578987150416e-4\n");
}

std::vector<PointObservation> borea_points(const Orientation& orientation) {
  std::ifstream stream(shared_folder("borea/observations.mes"));
  std::map<std::string, std::size_t> numbers;
  std::vector<PointObservation> points;
  std::string point, image;
  for (Eigen::Vector2d x; stream >> point >> image >> x.x() >> x.y();) {
    const std::size_t number = numbers.try_emplace(point, numbers.size()).first->second;
    points.push_back({number, number_of(orientation, image), x - Eigen::Vector2d(0.5, 0.5)});
  }
  return points;
}

TEST(RealOpkTable, OfAnUltraCamIsDecidedByStripsAndByRays) {
  SKIP_WITHOUT(shared_folder("borea"));
  const TempFolder folder;
  OrientationOptions options;
  options.cameras = borea_camera(folder);
  const std::string file = shared_folder("borea/shots.OPK");
  const Orientation by_strips = read_orientation(file, options);
  EXPECT_THAT(by_strips.decisions,
              ElementsAre(HasSubstr("angles in deg (with angles in deg images")));
  options.find_observations = borea_points;
  const Orientation by_rays = read_orientation(file, options);
  ASSERT_EQ(by_rays.images.size(), 20U);
  EXPECT_THAT(by_rays.decisions, ElementsAre(HasSubstr("angles in deg (with angles in deg rays")));
  const std::optional<double> distance_px = median_ray_distance_px(by_rays, borea_points(by_rays));
  RecordProperty("median_px", std::to_string(distance_px.value()));
  EXPECT_LT(distance_px.value(), 0.2);
}

TEST(RealOpkTable, OfAUltraCamProjectsItsObjectPointsOnTheObservations) {
  SKIP_WITHOUT(shared_folder("borea"));
  constexpr double kGeoidHeight_m =
      49.30;  // published points are above the ellipsoid, shots above the geoid
  const TempFolder folder;
  OrientationOptions options;
  options.cameras = borea_camera(folder);
  const Orientation orientation = read_orientation(shared_folder("borea/shots.OPK"), options);
  std::map<std::string, Eigen::Vector3d> points;
  std::string point, image;
  std::ifstream world(shared_folder("borea/points_world.mes"));
  for (Eigen::Vector3d x; world >> point >> x.x() >> x.y() >> x.z();) points[point] = x;
  std::vector<double> distances_px;
  std::ifstream stream(shared_folder("borea/observations.mes"));
  for (Eigen::Vector2d x; stream >> point >> image >> x.x() >> x.y();) {
    const OrientedImage& shot = orientation.images[number_of(orientation, image)];
    const ProjectionMatrix P = projection_matrix(orientation.cameras[0].interior, shot.exterior);
    const Eigen::Vector3d x_in_world = points.at(point) - Eigen::Vector3d(0.0, 0.0, kGeoidHeight_m);
    distances_px.push_back((project(P, x_in_world) - (x - Eigen::Vector2d(0.5, 0.5))).norm());
  }
  ASSERT_EQ(distances_px.size(), 973U);
  RecordProperty("median_px", std::to_string(median_of(distances_px)));
  EXPECT_LT(median_of(distances_px), 0.25);
}

TEST(RealOpkTable, OfADmcIsTheSameWithAndWithoutNamesOfColumns) {
  const std::string folder = shared_folder("orientations/ngi/");
  SKIP_WITHOUT(folder);
  OrientationOptions options;
  options.cameras = folder + "ngi_int_param.yaml";
  const Orientation named = read_orientation(folder + "ngi_xyz_opk.csv", options);
  const Orientation bare = read_orientation(folder + "camera_pos_ori.txt", options);
  ASSERT_EQ(named.images.size(), 4U);
  ASSERT_EQ(bare.images.size(), 4U);
  EXPECT_THAT(named.crs.definition, HasSubstr("+proj=tmerc"));
  EXPECT_THAT(named.decisions, ElementsAre(HasSubstr("angles in deg")));
  for (std::size_t i = 0; i < 4; ++i) {
    const ExteriorOrientation& a = named.images[i].exterior;
    const ExteriorOrientation& b = bare.images[i].exterior;
    EXPECT_EQ(named.images[i].name, bare.images[i].name);
    EXPECT_LT((a.position_m - b.position_m).norm(), 1e-3);  // three digits against six
    EXPECT_LT((a.world_from_camera_axes - b.world_from_camera_axes).norm(), 3e-5);
  }
  const InteriorOrientation& camera = named.cameras[0].interior;
  EXPECT_NEAR(camera.focal_length_px.x(), 120.0 / 92.16 * 640.0, 1e-9);
  EXPECT_EQ(camera.principal_point_px, Eigen::Vector2d(319.5, 575.5));
}

/// OpenDroneMap made the table by adding the place of the reference to topocentric coordinates. On
/// the map these are turned by the convergence of meridians (0.856 degrees) and scaled.
TEST(RealOpensfm, IsTheTableOfTheSameProjectTurnedToTheNorthOfTheMap) {
  const std::string folder = shared_folder("drone_odm/");
  SKIP_WITHOUT(folder);
  constexpr double kConvergence_rad = -0.014944;
  constexpr double kScale = 1.00010;  // 0.9996 on the central meridian, 2.05 degrees away
  constexpr double kDigits_m = 0.01;  // of the table, and of the scale in 70 m
  OrientationOptions options;
  options.angles = AngleUnit::kDegree;
  const Orientation table = read_orientation(folder + "odm_xyz_opk.csv", options);
  const Orientation opensfm = read_orientation(folder + "reconstruction.json");
  EXPECT_THAT(opensfm.crs.definition, HasSubstr("UTM zone 51N"));
  ASSERT_EQ(opensfm.images.size(), 4U);
  const Eigen::Matrix3d turn = world_from_camera_axes(0.0, 0.0, kConvergence_rad);
  const auto same = [&](const OrientedImage& image) {
    return table.images[number_of(table, image.name)].exterior;
  };
  const ExteriorOrientation& first = opensfm.images[0].exterior;
  const ExteriorOrientation first_in_table = same(opensfm.images[0]);
  for (const OrientedImage& image : opensfm.images) {
    const Eigen::Vector3d base_m = image.exterior.position_m - first.position_m;
    Eigen::Vector3d expected_m = turn * (same(image).position_m - first_in_table.position_m);
    expected_m.head<2>() *= kScale;
    EXPECT_LT((base_m - expected_m).norm(), kDigits_m) << image.name;
    const Eigen::Matrix3d expected = turn * same(image).world_from_camera_axes;
    EXPECT_LT((image.exterior.world_from_camera_axes - expected).norm(), 1e-4) << image.name;
  }
}

TEST(RealRollPitchYaw, IsRefusedByItsName) {
  const std::string file = shared_folder("drone_odm/odm_lla_rpy.csv");
  SKIP_WITHOUT(file);
  EXPECT_THAT(io_error_of([&] { read_orientation(file); }), HasSubstr("roll, pitch and yaw"));
}

/// Pix4D writes the matrix of each image without its distortion, for pixels from the corner and
/// without the offset.
TEST(RealPix4d, ProjectsAsTheMatricesOfTheSameProject) {
  const std::string folder = shared_folder("orientations/pix4d/");
  SKIP_WITHOUT(folder);
  const Orientation orientation =
      read_orientation(folder + "pix4d.origin_calibrated_camera_parameters.txt");
  EXPECT_EQ(orientation.cameras.size(), 1U);
  const Eigen::Vector3d offset_m(368109.0, 3956043.0, 96.0);
  std::ifstream stream(folder + "pix4d.origin_pmatrix.txt");
  std::size_t n_images = 0;
  double worst_px = 0.0;
  for (std::string name; stream >> name; ++n_images) {
    ProjectionMatrix stated;
    for (int i = 0; i < 12; ++i) stream >> stated(i / 4, i % 4);
    const OrientedImage& image = orientation.images[number_of(orientation, name)];
    const ProjectionMatrix P = projection_matrix(orientation.cameras[0].interior, image.exterior);
    for (const Eigen::Vector2d& shift : {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(6.0, 4.0)}) {
      Eigen::Vector3d x = image.exterior.position_m - offset_m;
      x += Eigen::Vector3d(shift.x(), shift.y(), -15.0);
      const Eigen::Vector2d expected = project(stated, x) - Eigen::Vector2d(0.5, 0.5);
      worst_px = std::max(worst_px, (project(P, x + offset_m) - expected).norm());
    }
  }
  EXPECT_EQ(n_images, orientation.images.size());
  RecordProperty("worst_px", std::to_string(worst_px));
  EXPECT_LT(worst_px, 0.01);  // matrices have six decimals
}

}  // namespace
}  // namespace ridgeline::io
