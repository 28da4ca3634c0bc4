// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/image.h"

#include "tests/support/temp_folder.h"

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <opencv2/core.hpp>

namespace ridgeline::io {
namespace {

using testing::HasSubstr;

struct Format {
  const char* driver;
  const char* name;
};

int depth_of(GDALDataType type) { return type == GDT_Byte ? CV_8U : CV_16U; }

/// An image of values that differ from pixel to pixel and from band to band.
cv::Mat pattern(int bands, GDALDataType type) {
  cv::Mat image(7, 13, CV_MAKETYPE(depth_of(type), bands));
  for (int i = 0; i < 7 * 13 * bands; ++i) {
    if (type == GDT_Byte) {
      image.data[i] = static_cast<std::uint8_t>(i % 251);
    } else {
      reinterpret_cast<std::uint16_t*>(image.data)[i] = static_cast<std::uint16_t>(i * 47);
    }
  }
  return image;
}

/// Writes with GDAL itself, by way of memory, as some drivers only copy.
void write_with_gdal(const std::string& path,
                     const char* driver,
                     const cv::Mat& image,
                     GDALDataType type,
                     bool colour_table = false) {
  GDALAllRegister();
  GDALDriverManager& drivers = *GetGDALDriverManager();
  const int bands = image.channels();
  const GDALDatasetUniquePtr memory(
      drivers.GetDriverByName("MEM")->Create("", image.cols, image.rows, bands, type, nullptr));
  const auto size = static_cast<GSpacing>(image.elemSize1());
  ASSERT_EQ(memory->RasterIO(GF_Write, 0, 0, image.cols, image.rows, image.data, image.cols,
                             image.rows, type, bands, nullptr, size * bands,
                             static_cast<GSpacing>(image.step[0]), size, nullptr),
            CE_None);
  if (colour_table) {
    GDALColorTable table;
    const GDALColorEntry red{255, 0, 0, 255};
    table.SetColorEntry(0, &red);
    memory->GetRasterBand(1)->SetColorTable(&table);
  }
  const GDALDatasetUniquePtr copy(drivers.GetDriverByName(driver)->CreateCopy(
      path.c_str(), memory.get(), 0, nullptr, nullptr, nullptr));
  ASSERT_TRUE(copy);
}

TEST(ReadImage, GivesThePixelsOfTheFileInTheOrderOfItsBands) {
  const TempFolder folder;
  for (const Format format : {Format{"GTiff", "a.tif"}, Format{"PNG", "a.png"}}) {
    for (const GDALDataType type : {GDT_Byte, GDT_UInt16}) {
      for (int bands = 1; bands <= 4; ++bands) {
        const cv::Mat written = pattern(bands, type);
        write_with_gdal(folder.file(format.name), format.driver, written, type);
        const cv::Mat read = read_image(folder.file(format.name));
        ASSERT_EQ(read.type(), written.type()) << format.name << bands;
        EXPECT_EQ(cv::norm(read, written, cv::NORM_INF), 0.0) << format.name << bands;
      }
    }
  }
}

TEST(ReadImage, ReadsJpeg) {
  const TempFolder folder;
  const cv::Mat written(32, 48, CV_8UC3, cv::Scalar(200, 100, 50));
  write_with_gdal(folder.file("a.jpg"), "JPEG", written, GDT_Byte);
  constexpr double kCompression = 3.0;  // grey values
  EXPECT_LE(cv::norm(read_image(folder.file("a.jpg")), written, cv::NORM_INF), kCompression);
}

TEST(ImageFacts, StateWhatTheHeaderStates) {
  const TempFolder folder;
  write_with_gdal(folder.file("a.tif"), "GTiff", pattern(4, GDT_UInt16), GDT_UInt16);
  const ImageFacts facts = image_facts(folder.file("a.tif"));
  EXPECT_EQ(facts.format, "GTiff");
  EXPECT_EQ(facts.width_px, 13);
  EXPECT_EQ(facts.height_px, 7);
  EXPECT_EQ(facts.n_bands, 4);
  EXPECT_EQ(facts.bits, 16);
}

std::string error_of(const std::string& path) {
  const std::string of_facts = io_error_of([&] { image_facts(path); });
  EXPECT_EQ(of_facts, io_error_of([&] { read_image(path); }));
  return of_facts;
}

TEST(ReadImage, RefusesWhatIsNoImage) {
  const TempFolder folder;
  EXPECT_THAT(error_of(folder.file("missing.tif")), HasSubstr("missing.tif: does not exist"));
  EXPECT_THAT(error_of(folder.file("")), HasSubstr("is an empty folder"));
  EXPECT_THAT(error_of(folder.write("text.tif", "no image")), HasSubstr("is not a readable TIFF"));
  EXPECT_THAT(error_of(folder.write("empty.png", "")), HasSubstr("is not a readable TIFF"));
}

TEST(ReadImage, FollowsNoReferencesToOtherFiles) {
  const TempFolder folder;
  write_with_gdal(folder.file("a.tif"), "GTiff", pattern(1, GDT_Byte), GDT_Byte);
  const std::string vrt =
      "<VRTDataset rasterXSize=\"13\" rasterYSize=\"7\"><VRTRasterBand dataType=\"Byte\" "
      "band=\"1\">"
      "<SimpleSource><SourceFilename relativeToVRT=\"1\">a.tif</SourceFilename></SimpleSource>"
      "</VRTRasterBand></VRTDataset>";
  EXPECT_THAT(error_of(folder.write("b.tif", vrt)), HasSubstr("is a VRT (XML)"));
}

TEST(ReadImage, RefusesOtherBandsThanItTakes) {
  const TempFolder folder;
  const cv::Mat real(4, 4, CV_32FC1, cv::Scalar(0.5));
  write_with_gdal(folder.file("real.tif"), "GTiff", real, GDT_Float32);
  EXPECT_THAT(error_of(folder.file("real.tif")),
              HasSubstr("band 1 is Float32; must be 8 or 16 bit unsigned"));
  const cv::Mat five = pattern(5, GDT_Byte);
  write_with_gdal(folder.file("five.tif"), "GTiff", five, GDT_Byte);
  EXPECT_THAT(error_of(folder.file("five.tif")), HasSubstr("has 5 bands; must be 1 to 4"));
  write_with_gdal(folder.file("table.tif"), "GTiff", pattern(1, GDT_Byte), GDT_Byte, true);
  EXPECT_THAT(error_of(folder.file("table.tif")), HasSubstr("has a colour table"));
}

TEST(ReadImage, RefusesAFileThatEndsEarly) {
  const TempFolder folder;
  cv::Mat noise(200, 200, CV_8UC3);
  cv::RNG random(2);
  random.fill(noise, cv::RNG::UNIFORM, 0, 255);
  for (const Format format :
       {Format{"GTiff", "a.tif"}, Format{"PNG", "a.png"}, Format{"JPEG", "a.jpg"}}) {
    write_with_gdal(folder.file(format.name), format.driver, noise, GDT_Byte);
    const std::string whole = folder.read(format.name);
    const std::string cut =
        folder.write(std::string("cut_") + format.name, whole.substr(0, whole.size() / 2));
    EXPECT_NE(io_error_of([&] { read_image(cut); }), "") << format.name;
  }
}

}  // namespace
}  // namespace ridgeline::io
