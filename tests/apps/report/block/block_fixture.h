// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/gdal/geopackage_writer.h"
#include "tests/support/temp_folder.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace ridgeline::apps {

/// A folder of results as `ridgeline block` leaves it: 10_20 with two lines, its neighbour 11_20
/// without any, and 10_21, which failed. The cloud lies in a folder of its own.
class BlockFixture {
 public:
  BlockFixture() {
    std::string cloud;
    for (int i = 0; i < kPoints; ++i)
      cloud += fmt::format("{} {} {}\n", 1000 + i % 200, 2000 + i / 200, 200 + i % 10);
    const std::string header = fmt::format(
        "VERSION .7\nFIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nCOUNT 1 1 1\nWIDTH {0}\nHEIGHT 1\n"
        "POINTS {0}\nDATA ascii\n",
        kPoints);
    cloud_ = data_.write("lidar.pcd", header + cloud);
    write_plan();
    (void)folder_.write(
        "patches.csv",
        "patch,method,x_min_m,y_min_m,x_max_m,y_max_m,n_images,images,low_m,high_m,"
        "status,n_lines,n_evaluated,rms_m,median_m,max_m,n_reference_lines,"
        "n_reference_found,reason\n"
        "10_20,joint,1000,2000,1100,2100,2,\"a b\",1,2,done,2,1,0.1234,0.1,0.2,4,3,\n"
        "11_20,joint,1100,2000,1200,2100,2,\"a b\",1,2,done,0,0,,,,0,0,\n"
        "10_21,joint,1000,2100,1100,2200,2,\"a b\",1,2,failed,0,0,,,,0,0,\"" +
            data_.file("a.tif") + ": is damaged, \"\"very\"\"\"\n");
    (void)folder_.write(
        "table2.json",
        R"({"rows":[{"patch":"town","method":"joint","class":"total","rms_m":0.5},)"
        R"({"patch":"10_20","method":"joint","class":"total","rms_m":0.1234}],"footnote":null})");
    write_run(nlohmann::json::object());
    write_lines();
  }

  [[nodiscard]] const io::TempFolder& folder() const { return folder_; }
  [[nodiscard]] std::string path() const { return folder_.file(""); }
  [[nodiscard]] const std::string& cloud() const { return cloud_; }
  [[nodiscard]] const io::TempFolder& data() const { return data_; }
  static constexpr int kPoints = 40000;  ///< 200 m x 200 m, one a square metre

  void write_run(const nlohmann::json& more) const {
    nlohmann::json run{{"command", "block"},
                       {"cloud", {{"crs", "x"}}},
                       {"stages", {{{"seconds", 12345.678}}}},
                       {"inputs",
                        {{{"role", "cloud"},
                          {"path", cloud_},
                          {"bytes", std::filesystem::file_size(cloud_)},
                          {"sha256", "ab"}}}}};
    run.update(more);
    if (std::filesystem::exists(folder_.file("run.json"))) {
      // a report that is written again replaces its own files
      const auto before = nlohmann::json::parse(folder_.read("run.json"));
      if (before.contains("files")) run["files"] = before["files"];
    }
    (void)folder_.write("run.json", run.dump());
  }

 private:
  static nlohmann::json patch(int column, int row) {
    const int x = 100 * column, y = 100 * row;
    return {{"id", fmt::format("{}_{}", column, row)},
            {"square", {column, row}},
            {"core_m", {x, y, x + 100, y + 100}},
            {"area_m", {x - 10, y - 10, x + 110, y + 110}},
            {"height_range_m", {1.0, 2.0}},
            {"images", {"a", "b"}},
            {"estimated_s", 10.0},
            {"estimated_mib", 500.0}};
  }

  void write_plan() const {
    const nlohmann::json plan{{"plan", "town"},
                              {"block_file", data_.file("block.yaml")},
                              {"crs", "EPSG:25832"},
                              {"patch_size_m", 100.0},
                              {"overlap_m", 10.0},
                              {"area_m", {{1000, 2000}, {1200, 2000}, {1200, 2200}, {1000, 2200}}},
                              {"n_squares_without_views", 1},
                              {"warnings", {data_.file("b.tif") + ": is dark"}},
                              {"patches", {patch(10, 20), patch(11, 20), patch(10, 21)}}};
    (void)folder_.write("plan.json", plan.dump());
  }

  void write_lines() const {
    using io::ColumnType;
    io::MapLayer layer;
    layer.name = "lines";
    layer.columns = {{"line_id", ColumnType::kText},       {"class", ColumnType::kText},
                     {"status", ColumnType::kText},        {"kind", ColumnType::kText},
                     {"length_m", ColumnType::kReal},      {"mean_distance_m", ColumnType::kReal},
                     {"max_distance_m", ColumnType::kReal}};
    const std::string aligned = "aligned", step = "step";
    layer.features = {
        {{{1010, 2010, 5}, {1020, 2010, 6}},
         {{0, std::string("10_20/7")},
          {1, aligned},
          {2, std::string("evaluated")},
          {3, step},
          {4, 10.05},
          {5, 0.1},
          {6, 0.2}}},
        {{{1030, 2050, 5}, {1030, 2060, 5}},
         {{0, std::string("10_20/8")}, {1, aligned}, {2, std::string("no_plane")}, {4, 10.0}}},
        {{{1, 2, 3}, {4, 5, 6}}, {{0, std::string("9_9/1")}, {1, aligned}}}};
    io::write_geopackage(folder_.file("judged.joint.gpkg"), {"EPSG:25832"}, {layer});
  }

  io::TempFolder folder_, data_;
  std::string cloud_;
};

}  // namespace ridgeline::apps
