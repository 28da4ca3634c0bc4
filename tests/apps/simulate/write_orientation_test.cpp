// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/write_orientation.h"

#include "io/orientation/option_words.h"
#include "io/orientation/read_orientation.h"
#include "tests/io/orientation/fixture.h"
#include "tests/support/temp_folder.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <stdexcept>

namespace ridgeline::simulate {
namespace {

using namespace io;  // NOLINT(google-build-using-namespace): the orientations are its own
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::UnorderedElementsAreArray;

/// Sums of seven digits before the point and nine after it.
constexpr double kDigitsOfMap_px = 1e-6;
/// PROJ's derivative, from which the rotation to the map follows, is good to 1e-10.
constexpr double kGeocentric_px = 1e-5;
/// As in read_orientation_test.cpp: digits of the fixture, and what a rotation cannot take in of a
/// map.
constexpr double kFixture_px = 2e-5;
constexpr double kFixtureOnMap_px = 0.02;

struct FormatCase {
  const char* name;
  bool is_geocentric;
};
constexpr std::array kFormats{
    FormatCase{"opk", false},    FormatCase{"pix4d", false},           FormatCase{"inpho", false},
    FormatCase{"pat_b", false},  FormatCase{"blocks_exchange", false}, FormatCase{"colmap", false},
    FormatCase{"opensfm", true}, FormatCase{"metashape", true}};

/// The block of the fixture without its distortion and with names that all formats take; of
/// geocentric formats on the map of WGS 84.
Orientation block_to_write(bool is_geocentric) {
  OrientationOptions options;
  options.cameras = fixture::path_of("cameras.yaml");
  Orientation block = is_geocentric ? read_orientation(fixture::path_of("opensfm.json"))
                                    : read_orientation(fixture::path_of("opk_deg.csv"), options);
  if (!is_geocentric) block.crs.definition = "EPSG:25832";
  Orientation named = block;
  for (const OrientedImage& image : block.images) {
    const auto number = static_cast<std::size_t>(
        std::ranges::find(fixture::names(), file_name_of(image)) - fixture::names().begin());
    named.images[number] = image;
    named.images[number].name = fmt::format("{}.tif", number);
  }
  named.cameras[0].name = "cam";
  named.cameras[0].interior.distortion = {};
  return named;
}

Orientation written_and_read(const Orientation& block,
                             const std::string& format,
                             const std::string& folder) {
  write_orientation(folder, format, block);
  const OrientationFiles files = orientation_files(format);
  OrientationOptions options;
  options.crs = block.crs;
  if (!files.cameras.empty()) options.cameras = folder + "/" + files.cameras;
  if (!files.matrix.empty()) options.matrix = matrix_direction_named(files.matrix);
  return read_orientation(folder + "/" + files.orientation, options);
}

/// The largest distance of the pixels at which two orientations see what the corners of the first
/// one's images show 90 m ahead. Images are told by their names.
double largest_distance_px(const Orientation& a, const Orientation& b) {
  double largest = 0.0;
  for (const OrientedImage& image : a.images) {
    const auto same = std::ranges::find(b.images, image.name, &OrientedImage::name);
    if (same == b.images.end()) throw std::runtime_error("no image " + image.name);
    const InteriorOrientation& interior = a.cameras.at(image.camera.value()).interior;
    for (const Eigen::Vector2d& corner : {Eigen::Vector2d(0, 0), Eigen::Vector2d(1199, 0),
                                          Eigen::Vector2d(0, 899), Eigen::Vector2d(1199, 899)}) {
      const Eigen::Vector2d v =
          (corner - interior.principal_point_px).cwiseQuotient(interior.focal_length_px);
      const Eigen::Vector3d x =
          image.exterior.position_m +
          90.0 * (image.exterior.world_from_camera_axes * Eigen::Vector3d(v.x(), -v.y(), -1.0));
      largest = std::max(largest, (fixture::seen_px(b, *same, x) - corner).norm());
    }
  }
  return largest;
}

TEST(WriteOrientation, IsReadBackInEveryFormat) {
  for (const FormatCase& format : kFormats) {
    SCOPED_TRACE(format.name);
    const TempFolder folder;
    const Orientation block = block_to_write(format.is_geocentric);
    const Orientation read = written_and_read(block, format.name, folder.file("o"));
    ASSERT_EQ(read.images.size(), 4U);
    ASSERT_EQ(read.cameras.size(), 1U);
    EXPECT_EQ(read.cameras[0].interior.size_px, Eigen::Vector2i(1200, 900));
    EXPECT_LT(largest_distance_px(block, read),
              format.is_geocentric ? kGeocentric_px : kDigitsOfMap_px);
    EXPECT_TRUE(compare(read.crs, block.crs).compatible);
  }
}

TEST(WriteOrientation, SeesWhatTheFixtureSees) {
  for (const FormatCase& format : kFormats) {
    SCOPED_TRACE(format.name);
    const TempFolder folder;
    Orientation read =
        written_and_read(block_to_write(format.is_geocentric), format.name, folder.file("o"));
    std::ranges::sort(read.images, std::less(), &OrientedImage::name);
    read.cameras.at(0).interior.distortion = fixture::kDistortion;
    const auto observed =
        fixture::observations(format.is_geocentric ? "observations_utm.csv" : "observations.csv");
    EXPECT_LT(fixture::worst_px(read, observed),
              format.is_geocentric ? kFixtureOnMap_px : kFixture_px);
  }
}

TEST(WriteOrientation, KeepsACameraForEachImageInEveryFormat) {
  for (const FormatCase& format : kFormats) {
    SCOPED_TRACE(format.name);
    const TempFolder folder;
    Orientation block = block_to_write(format.is_geocentric);
    const InteriorOrientation first = block.cameras[0].interior;
    block.cameras.clear();
    for (std::size_t i = 0; i < block.images.size(); ++i) {
      block.cameras.push_back({block.images[i].name, first});
      block.cameras[i].interior.principal_point_px.x() -= 700.0 * static_cast<double>(i);
      block.images[i].camera = i;
    }
    const Orientation read = written_and_read(block, format.name, folder.file("o"));
    ASSERT_EQ(read.cameras.size(), 4U);
    EXPECT_LT(largest_distance_px(block, read),
              format.is_geocentric ? kGeocentric_px : kDigitsOfMap_px);
  }
}

/// The numbers of a text from the `n`-th place of a word on; what is no number parts them.
std::vector<double> numbers_from(const std::string& text,
                                 const std::string& word,
                                 int n,
                                 std::size_t count) {
  std::size_t at = 0;
  for (int i = 0; i <= n; ++i) {
    at = text.find(word, i == 0 ? 0 : at + 1);
    if (at == std::string::npos) throw std::runtime_error("no " + word);
  }
  const std::string rest = text.substr(at + word.size());
  std::vector<double> numbers;
  const char* next = rest.c_str();
  while (numbers.size() < count && *next != '\0') {
    char* end = nullptr;
    const double value = std::strtod(next, &end);
    if (end != next) numbers.push_back(value);
    next = end == next ? next + 1 : end;
  }
  return numbers;
}

std::string content_of(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

void expect_near(const std::vector<double>& written,
                 const std::vector<double>& stated,
                 std::size_t from = 0) {
  constexpr double kDigits = 1e-6;  // positions of the fixtures have six
  ASSERT_EQ(written.size(), stated.size());
  for (std::size_t i = from; i < written.size(); ++i) {
    EXPECT_NEAR(written[i], stated[i], kDigits) << i;
  }
}

/// What another program states of the same block, number by number.
TEST(WriteOrientation, StatesTheNumbersOfTheFixture) {
  const TempFolder folder;
  const Orientation block = block_to_write(false);
  const auto text_of = [&](const std::string& format) {
    write_orientation(folder.file(format), format, block);
    return content_of(folder.file(format) + "/" + orientation_files(format).orientation);
  };
  const auto fixture_text = [](const char* file) { return content_of(fixture::path_of(file)); };
  const std::string opk = text_of("opk");
  const std::string pat_b = text_of("pat_b");
  const std::string inpho = text_of("inpho");
  const std::string exchange = text_of("blocks_exchange");
  const std::string pix4d = text_of("pix4d");
  for (int i = 0; i < 4; ++i) {
    SCOPED_TRACE(i);
    const std::string& name = fixture::names()[static_cast<std::size_t>(i)];
    expect_near(numbers_from(opk, fmt::format("\n{}.tif,", i), 0, 6),
                numbers_from(fixture_text("opk_deg.csv"), "\n" + name + ",", 0, 6));
    expect_near(numbers_from(pat_b, fmt::format("{}.tif", i), 0, 12),
                numbers_from(fixture_text("pat_b_world_from_camera.ori"),
                             fmt::format("{:>16}{:16}", i + 1, ""), 0, 12));
    // date, time and focal length first
    expect_near(numbers_from(inpho, "$EXT_ORI : ", i, 6 + 13),
                numbers_from(fixture_text("inpho.prj"), "$EXT_ORI : ", i, 6 + 13), 7);
    const std::string stated = fixture_text("blocks_exchange_XRightYDown.xml");
    for (const char* element : {"<M_00>", "<M_01>", "<M_12>", "<M_20>", "<M_22>"}) {
      expect_near(numbers_from(exchange, element, i, 1), numbers_from(stated, element, i, 1));
    }
    expect_near(numbers_from(exchange, "<Center>", i, 3),
                numbers_from(stated, "</Rotation>\n          <Center>", i, 3));
    const std::vector<double> ours = numbers_from(pix4d, fmt::format("\n{}.tif ", i), 0, 28);
    const std::vector<double> theirs = numbers_from(
        fixture_text("block_calibrated_camera_parameters.txt"), "\n" + name + " ", 0, 28);
    expect_near({ours.begin(), ours.begin() + 11}, {theirs.begin(), theirs.begin() + 11});
    expect_near({ours.begin() + 19, ours.end()}, {theirs.begin() + 19, theirs.end()});
  }
  expect_near(numbers_from(exchange, "<PrincipalPoint>", 0, 2), {617.25, 438.5});
  // pixels of the DMC's size
  EXPECT_THAT(numbers_from(inpho, "$FOCAL_LENGTH", 0, 1),
              ::testing::ElementsAre(::testing::DoubleNear(1300.0 * 0.012, 1e-9)));
}

/// COLMAP's documentation: x_in_cam = R(q) x + t, with axes x right, y down, z forwards.
TEST(WriteOrientation, TurnsAndMovesTheWorldIntoColmapsCameras) {
  const TempFolder folder;
  write_orientation(folder.file("o"), "colmap", block_to_write(false));
  const std::string images = content_of(folder.file("o/colmap/images.txt"));
  const std::string stated = content_of(fixture::path_of("block_calibrated_camera_parameters.txt"));
  const std::vector<double> origin =
      numbers_from(content_of(fixture::path_of("block_offset.xyz")), "", 0, 3);
  for (int i = 0; i < 4; ++i) {
    const std::vector<double> v = numbers_from(images, fmt::format("\n{} ", i + 1), 0, 7);
    const double w = v[0], x = v[1], y = v[2], z = v[3];
    const std::vector<double> R{
        1 - 2 * (y * y + z * z), 2 * (x * y - z * w),     2 * (x * z + y * w),
        2 * (x * y + z * w),     1 - 2 * (x * x + z * z), 2 * (y * z - x * w),
        2 * (x * z - y * w),     2 * (y * z + x * w),     1 - 2 * (x * x + y * y)};
    const std::vector<double> pix4d =
        numbers_from(stated, "\n" + fixture::names()[static_cast<std::size_t>(i)] + " ", 0, 28);
    expect_near(R, {pix4d.end() - 9, pix4d.end()});
    for (std::size_t row = 0; row < 3; ++row) {
      double in_cam = v[4 + row];  // of the projection centre
      for (std::size_t k = 0; k < 3; ++k) in_cam += R[3 * row + k] * (pix4d[16 + k] + origin[k]);
      EXPECT_NEAR(in_cam, 0.0, 1e-6);
    }
  }
  EXPECT_THAT(content_of(folder.file("o/colmap/cameras.txt")),
              HasSubstr("1 SIMPLE_PINHOLE 1200 900 1300 617.25 438.5"));
}

TEST(WriteOrientation, WritesTheFilesThatItNames) {
  for (const FormatCase& format : kFormats) {
    const TempFolder folder;
    write_orientation(folder.file("o"), format.name, block_to_write(format.is_geocentric));
    std::vector<std::string> written;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.file("o"))) {
      if (!entry.is_regular_file()) continue;
      written.push_back(std::filesystem::relative(entry.path(), folder.file("o")).string());
    }
    EXPECT_THAT(written, UnorderedElementsAreArray(orientation_files(format.name).files));
  }
}

std::string refusal_of(const Orientation& block, const char* format) {
  const TempFolder folder;
  try {
    write_orientation(folder.file("o"), format, block);
  } catch (const std::invalid_argument& error) {
    EXPECT_FALSE(std::filesystem::exists(folder.file("o"))) << error.what();
    return error.what();
  }
  return "";
}

TEST(WriteOrientation, RefusesWhatTheFormatsCannotState) {
  const Orientation good = block_to_write(false);
  EXPECT_THAT(refusal_of(good, "opensfn"),
              AllOf(HasSubstr("opensfn, the nearest is opensfm"), HasSubstr("pat_b")));
  EXPECT_THAT(refusal_of({}, "opk"), HasSubstr("without images"));
  Orientation block = good;
  block.images[1].name = "a b.tif";
  EXPECT_THAT(refusal_of(block, "opk"), HasSubstr("name \"a b.tif\", must be of letters"));
  block = good;
  block.images[1].camera.reset();
  EXPECT_THAT(refusal_of(block, "opk"), HasSubstr("image 1.tif, must have a camera"));
  block = good;
  block.cameras[0].interior.distortion.k1 = 1e-9;
  EXPECT_THAT(refusal_of(block, "inpho"), HasSubstr("camera cam, must have one focal length"));
  block = good;
  block.cameras[0].interior.size_px.reset();
  EXPECT_THAT(refusal_of(block, "opk"), HasSubstr("must have a size"));
  block = good;
  block.cameras.push_back({"cam2", block.cameras[0].interior});
  EXPECT_THAT(refusal_of(block, "pat_b"), HasSubstr("must be one or named after their images"));
  block = good;
  block.crs = {};
  EXPECT_THAT(refusal_of(block, "metashape"), HasSubstr("must be projected"));
}

}  // namespace
}  // namespace ridgeline::simulate
