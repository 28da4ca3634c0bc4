// SPDX-License-Identifier: BSD-3-Clause
// Project files: Inpho, BlocksExchange, Metashape, OpenSfM.
#include "apps/simulate/orientation_writers.h"
#include "io/orientation/geocentric_poses.h"

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace ridgeline::simulate {
namespace {

/// The scale in millimetres is arbitrary: the pixel size of the DMC.
constexpr double kPixelMm = 0.012;

std::string inpho_camera(const io::Camera& camera) {
  const InteriorOrientation& interior = camera.interior;
  const Eigen::Vector2i& size = *interior.size_px;
  const Eigen::Vector2d middle_px = 0.5 * (size.cast<double>() - Eigen::Vector2d::Ones());
  const Eigen::Vector2d offset_mm = kPixelMm * principal_offset_px(interior);
  constexpr double kPxPerMm = 1.0 / kPixelMm;
  return fmt::format(
      "$CAMERA_DEFINITION\n  $ID : {}\n  $CCD_COLUMNS : {}\n  $CCD_ROWS : {}\n"
      "  $PIXEL_REFERENCE : CenterTopLeft\n  $CCD_INTERIOR_ORIENTATION :\n    {} 0 {}\n    0 {} "
      "{}\n"
      "  $FOCAL_LENGTH : {}\n  $PRINCIPAL_POINT_PPA : {} {}\n$END\n",
      camera.name, size.x(), size.y(), kPxPerMm, middle_px.x(), -kPxPerMm, middle_px.y(),
      kPixelMm * interior.focal_length_px.x(), offset_mm.x(), -offset_mm.y());
}

std::string inpho_photo(const io::Orientation& orientation, std::size_t number) {
  const io::OrientedImage& image = orientation.images[number];
  const io::Camera& camera = orientation.cameras[*image.camera];
  const Eigen::Vector3d& x = image.exterior.position_m;
  const Eigen::Matrix3d camera_from_world = image.exterior.world_from_camera_axes.transpose();
  std::string text =
      fmt::format("$PHOTO\n  $PHOTO_NUM : {}\n  $PHOTO_FILE : {}\n  $CAMERA_ID : {}\n", number + 1,
                  image.name, camera.name);
  if (orientation.ground_height_m) {
    text += fmt::format("  $TERRAIN_HEIGHT : {}\n", *orientation.ground_height_m);
  }
  text += fmt::format("  $EXT_ORI : 00:00:00 01/01/2000\n    {} {} {} {}\n",
                      kPixelMm * camera.interior.focal_length_px.x(), x.x(), x.y(), x.z());
  for (int row = 0; row < 3; ++row) {
    text += fmt::format("    {} {} {}\n", camera_from_world(row, 0), camera_from_world(row, 1),
                        camera_from_world(row, 2));
  }
  return text + "$END\n";
}

std::string exchange_photo(const io::Orientation& orientation, std::size_t number) {
  const io::OrientedImage& image = orientation.images[number];
  const Eigen::Vector3d& x = image.exterior.position_m;
  const Eigen::Matrix3d M = cam_from_world(image.exterior);
  std::string rotation;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      rotation += fmt::format("<M_{0}{1}>{2}</M_{0}{1}>", row, column, M(row, column));
    }
  }
  std::string depth;
  if (orientation.ground_height_m) {
    const double down = image.exterior.world_from_camera_axes(2, 2);
    depth =
        fmt::format("<MedianDepth>{}</MedianDepth>", (x.z() - *orientation.ground_height_m) / down);
  }
  return fmt::format(
      "        <Photo><Id>{}</Id><ImagePath>{}</ImagePath>\n          "
      "<Pose><Rotation>{}</Rotation>\n"
      "            <Center><x>{}</x><y>{}</y><z>{}</z></Center></Pose>{}</Photo>\n",
      number, image.name, rotation, x.x(), x.y(), x.z(), depth);
}

std::string exchange_group(const io::Orientation& orientation, std::size_t number) {
  const io::Camera& camera = orientation.cameras[number];
  const InteriorOrientation& interior = camera.interior;
  const Eigen::Vector2d point_px = principal_point_from_corner_px(interior);
  std::string photos;
  for (std::size_t i = 0; i < orientation.images.size(); ++i) {
    if (orientation.images[i].camera == number) photos += exchange_photo(orientation, i);
  }
  return fmt::format(
      "      <Photogroup><Name>{}</Name>\n        "
      "<ImageDimensions><Width>{}</Width><Height>{}</Height></ImageDimensions>\n        "
      "<CameraModelType>Perspective</CameraModelType>\n        "
      "<FocalLengthPixels>{}</FocalLengthPixels>\n        "
      "<CameraOrientation>XRightYDown</CameraOrientation>\n        "
      "<PrincipalPoint><x>{}</x><y>{}</y></PrincipalPoint>\n{}      </Photogroup>\n",
      camera.name, interior.size_px->x(), interior.size_px->y(), interior.focal_length_px.x(),
      point_px.x(), point_px.y(), photos);
}

std::string metashape_sensor(const io::Camera& camera, std::size_t number) {
  const InteriorOrientation& interior = camera.interior;
  const Eigen::Vector2d offset_px = principal_offset_px(interior);
  const std::string resolution = fmt::format(R"(<resolution width="{}" height="{}"/>)",
                                             interior.size_px->x(), interior.size_px->y());
  return fmt::format(
      R"(      <sensor id="{}" label="{}" type="frame">{}
        <calibration type="frame" class="adjusted">{}
          <f>{}</f><cx>{}</cx><cy>{}</cy></calibration></sensor>
)",
      number, camera.name, resolution, resolution, interior.focal_length_px.x(), offset_px.x(),
      offset_px.y());
}

std::string metashape_camera(const io::OrientedImage& image,
                             std::size_t number,
                             const ExteriorOrientation& in_chunk) {
  const Eigen::Matrix3d chunk_from_cam = cam_from_world(in_chunk).transpose();
  std::string transform;
  for (int row = 0; row < 3; ++row) {
    transform += fmt::format("{} {} {} {} ", chunk_from_cam(row, 0), chunk_from_cam(row, 1),
                             chunk_from_cam(row, 2), in_chunk.position_m[row]);
  }
  return fmt::format(
      R"(      <camera id="{}" sensor_id="{}" label="{}"><transform>{}0 0 0 1</transform></camera>
)",
      number, *image.camera, image.name, transform);
}

std::string xml_text(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '&') {
      escaped += "&amp;";
    } else if (c == '<') {
      escaped += "&lt;";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

nlohmann::ordered_json opensfm_camera(const InteriorOrientation& interior) {
  const double side_px = interior.size_px->maxCoeff();
  const Eigen::Vector2d offset = principal_offset_px(interior) / side_px;
  const double focal = interior.focal_length_px.x() / side_px;
  return {{"projection_type", "brown"},
          {"width", interior.size_px->x()},
          {"height", interior.size_px->y()},
          {"focal_x", focal},
          {"focal_y", focal},
          {"c_x", offset.x()},
          {"c_y", offset.y()},
          {"k1", 0.0},
          {"k2", 0.0},
          {"k3", 0.0},
          {"p1", 0.0},
          {"p2", 0.0}};
}

nlohmann::ordered_json three_numbers(const Eigen::Vector3d& x) { return {x.x(), x.y(), x.z()}; }

}  // namespace

std::string inpho_text(const io::Orientation& orientation) {
  std::string text = "$PROJECT 6.0.0\n  $LINEAR_UNITS_OF_OBJECT : m\n  $ANGULAR_UNITS : deg\n";
  const std::string wkt = wkt_text(orientation);
  if (!wkt.empty()) text += "  $COORDINATE_SYSTEM : " + wkt + "\n";
  text += "$END\n";
  for (const io::Camera& camera : orientation.cameras) text += inpho_camera(camera);
  for (std::size_t i = 0; i < orientation.images.size(); ++i) text += inpho_photo(orientation, i);
  return text;
}

std::string blocks_exchange_text(const io::Orientation& orientation) {
  std::string groups;
  for (std::size_t i = 0; i < orientation.cameras.size(); ++i) {
    groups += exchange_group(orientation, i);
  }
  return fmt::format(
      R"(<?xml version="1.0" encoding="utf-8"?>
<BlocksExchange version="3.2">
  <SpatialReferenceSystems><SRS><Id>1</Id><Definition>{}</Definition></SRS></SpatialReferenceSystems>
  <Block><Name>block</Name><SRSId>1</SRSId>
    <Photogroups>
{}    </Photogroups></Block>
</BlocksExchange>
)",
      xml_text(wkt_text(orientation)), groups);
}

std::string metashape_text(const io::Orientation& orientation) {
  const io::TopocentricPoses poses = io::topocentric_poses(orientation);
  const Eigen::Vector3d& origin = poses.geocentric_from_enu.translation();
  std::string sensors;
  for (std::size_t i = 0; i < orientation.cameras.size(); ++i) {
    sensors += metashape_sensor(orientation.cameras[i], i);
  }
  std::string cameras;
  for (std::size_t i = 0; i < orientation.images.size(); ++i) {
    cameras += metashape_camera(orientation.images[i], i, poses.exterior[i]);
  }
  return fmt::format(
      R"(<?xml version="1.0" encoding="UTF-8"?>
<document version="2.0.0">
  <chunk label="block" enabled="true">
    <sensors>
{}    </sensors>
    <cameras>
{}    </cameras>
    <reference>{}</reference>
    <transform><rotation>{}</rotation><translation>{} {} {}</translation><scale>1</scale></transform>
  </chunk>
</document>
)",
      sensors, cameras, xml_text(wkt_text(orientation)),
      row_by_row(poses.geocentric_from_enu.linear()), origin.x(), origin.y(), origin.z());
}

std::string opensfm_text(const io::Orientation& orientation) {
  const io::TopocentricPoses poses = io::topocentric_poses(orientation);
  nlohmann::ordered_json reconstruction;
  for (const io::Camera& camera : orientation.cameras) {
    reconstruction["cameras"][camera.name] = opensfm_camera(camera.interior);
  }
  for (std::size_t i = 0; i < orientation.images.size(); ++i) {
    const io::OrientedImage& image = orientation.images[i];
    const Eigen::AngleAxisd turn(cam_from_world(poses.exterior[i]));
    const Eigen::Vector3d translation = -(turn.toRotationMatrix() * poses.exterior[i].position_m);
    reconstruction["shots"][image.name] = {{"rotation", three_numbers(turn.angle() * turn.axis())},
                                           {"translation", three_numbers(translation)},
                                           {"camera", camera_name(orientation, image)}};
  }
  reconstruction["points"] = nlohmann::ordered_json::object();
  reconstruction["reference_lla"] = {{"latitude", poses.place.lat_deg},
                                     {"longitude", poses.place.lon_deg},
                                     {"altitude", poses.place.height_m}};
  return nlohmann::ordered_json::array({reconstruction}).dump(1) + "\n";
}

}  // namespace ridgeline::simulate
