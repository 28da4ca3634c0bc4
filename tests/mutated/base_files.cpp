// SPDX-License-Identifier: BSD-3-Clause
#include "tests/mutated/base_files.h"

#include "io/cloud/read_cloud.h"
#include "io/lines/read_lines.h"
#include "io/lines/write_lines.h"
#include "tests/io/laz/copc_builder.h"
#include "tests/io/laz/laz_builder.h"
#include "tests/support/paths.h"
#include "tests/support/random.h"

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <cstring>
#include <fstream>
#include <span>
#include <utility>

namespace ridgeline::test {
namespace fs = std::filesystem;
namespace {

using Command = std::vector<std::string>;
using Commands = std::vector<Command>;

constexpr std::size_t kCloudPoints = 400;

const Commands kLineCommands{
    {"info", "FILE"},
    {"evaluate", "--lines", "FILE", "--cloud", "lidar.las", "--out", "OUT", "--no-report"},
    {"evaluate", "--lines", "truth.geojson", "--reference-lines", "FILE", "--cloud", "lidar.las",
     "--out", "OUT"}};
const Commands kModelCommands{
    {"info", "FILE"},
    {"evaluate", "--lines", "FILE", "--cloud", "town/lidar.las", "--out", "OUT", "--no-report"}};
const Commands kCloudCommands{
    {"info", "FILE"},
    {"evaluate", "--lines", "truth.geojson", "--cloud", "FILE", "--out", "OUT"},
    {"evaluate", "--lines", "truth.geojson", "--cloud", "FILE", "--cloud", "lidar.las", "--out",
     "OUT", "--no-report"}};
const Commands kImageCommands{{"info", "FILE"}, {"extract", "FILE", "--out", "OUT.csv"}};
const Commands kPatchCommands{
    {"info", "FILE"},
    {"evaluate", "--patch", "FILE", "--lines", "truth.geojson", "--out", "OUT", "--no-report"},
    {"match", "FILE", "--out", "OUT.csv"},
    {"run", "FILE", "--out", "OUT"}};
const Commands kGatesCommands{{"gate", "results", "--gates", "FILE"},
                              {"gate", "results", "--gates", "FILE", "--baseline", "results"}};
const Commands kMatchCommands{{"reconstruct", "patch.yaml", "--matches", "FILE", "--method",
                               "joint", "--out", "OUT.geojson"}};

class Writer {
 public:
  explicit Writer(fs::path folder) : folder_(std::move(folder)) {}

  void add(const std::string& name, std::string_view content, const Commands& commands) {
    std::ofstream(folder_ / name, std::ios::binary) << content;
    files.push_back({name, commands});
  }
  void add(const std::string& name, std::span<const std::byte> bytes, const Commands& commands) {
    add(name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()}, commands);
  }
  /// A file that stands there.
  void add(const std::string& name, const Commands& commands) { files.push_back({name, commands}); }

  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_ / name).string();
  }

  std::vector<BaseFile> files;

 private:
  fs::path folder_;
};

void write_line_files(Writer& out) {
  const io::LineSet truth = io::read_lines(out.path("truth.geojson"));
  for (const io::LineFormatInfo& info : io::line_formats()) {
    const std::string name = fmt::format("lines_{}{}", info.name, info.extension);
    io::write_lines(out.path(name), truth, info.format);
    out.add(name, kLineCommands);
  }
  for (const char* const model : {"buildings.city.json", "buildings.gml"})
    out.add(fmt::format("town/{}", model), kModelCommands);
  for (const char* kind : {"line_text", "line_mesh"}) {
    const fs::path seeds = fs::path(test::source_dir()) / "tests/fuzz/seeds" / kind;
    for (const auto& entry : fs::directory_iterator(seeds)) {
      std::ifstream stream(entry.path(), std::ios::binary);
      const std::string content{std::istreambuf_iterator<char>(stream), {}};
      out.add("seed_" + entry.path().filename().string(), content, kLineCommands);
    }
  }
}

template <typename T>
void put(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void write_cloud_files(Writer& out) {
  const io::PointCloud cloud = io::read_cloud({out.path("lidar.las")}, {});
  std::string text;
  std::string binary;
  const std::size_t step = cloud.points.size() / kCloudPoints + 1;
  std::size_t n = 0;
  for (std::size_t i = 0; i < cloud.points.size(); i += step, ++n) {
    const io::CloudPoint& p = cloud.points[i];
    const Eigen::Vector3d x = cloud.frame.origin_m + Eigen::Vector3d(p.x, p.y, p.z);
    text += fmt::format("{:.3f} {:.3f} {:.3f}\n", x.x(), x.y(), x.z());
    for (int axis = 0; axis < 3; ++axis) put(binary, x[axis]);
  }
  const std::string ply = fmt::format(
      "element vertex {}\nproperty double x\nproperty double y\nproperty double z\nend_header\n",
      n);
  const auto pcd = [&](const char* data) {
    return fmt::format(
        "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nCOUNT 1 1 1\nWIDTH {}\n"
        "HEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {}\nDATA {}\n",
        n, n, data);
  };
  out.add("cloud.xyz", text, kCloudCommands);
  out.add("cloud_ascii.ply", "ply\nformat ascii 1.0\n" + ply + text, kCloudCommands);
  out.add("cloud_binary.ply", "ply\nformat binary_little_endian 1.0\n" + ply + binary,
          kCloudCommands);
  out.add("cloud_ascii.pcd", pcd("ascii") + text, kCloudCommands);
  out.add("cloud_binary.pcd", pcd("binary") + binary, kCloudCommands);
  // a single literal run of LZF holds at most 32 bytes behind its length less one
  std::string packed;
  for (std::size_t i = 0; i < binary.size(); i += 32) {
    const std::string run = binary.substr(i, 32);
    packed += static_cast<char>(run.size() - 1);
    packed += run;
  }
  std::string sizes;
  put(sizes, static_cast<std::uint32_t>(packed.size()));
  put(sizes, static_cast<std::uint32_t>(binary.size()));
  out.add("cloud_packed.pcd", pcd("binary_compressed") + sizes + packed, kCloudCommands);
  out.add("lidar.las", {{"info", "FILE"},
                        {"evaluate", "--lines", "truth.geojson", "--cloud", "FILE", "--out", "OUT",
                         "--no-report"}});
}

void write_laz_files(Writer& out) {
  std::vector<io::laz::CopcPoint> points(300);
  Random random(3);
  for (io::laz::CopcPoint& point : points) {
    for (std::int32_t& x : point.x) x = static_cast<std::int32_t>(random.uniform(0.0, 5000.0));
  }
  const io::laz::CopcBuilder copc{.n_levels = 3, .entries_per_page = 8};
  out.add("cloud.copc.laz", copc.build(points), kCloudCommands);
  io::laz::LazBuilder laz;
  for (std::int32_t i = 0; i < 8; ++i) laz.add_single_point(i, 2 * i, -i);
  out.add("cloud.laz", laz.build(), kCloudCommands);
}

void write_images(Writer& out) {
  cv::Mat image = cv::imread(out.path("left.tif"), cv::IMREAD_UNCHANGED);
  image = image(cv::Rect(0, 0, std::min(image.cols, 240), std::min(image.rows, 180))).clone();
  for (const char* name : {"image.tif", "image.png", "image.jpg"}) {
    cv::imwrite(out.path(name), image);
    out.add(name, kImageCommands);
  }
}

void write_texts(Writer& out) {
  out.add("patch.yaml", kPatchCommands);
  out.add("matches.csv", {{"run", "patch.yaml", "--out", "OUT", "--no-report"}});
  std::ifstream patch(out.path("patch.yaml"));
  std::ofstream(out.path("tracked.yaml"))
      << patch.rdbuf() << "reference_tracks: reference_tracks.csv\n";
  out.add("reference_tracks.csv",
          "edge,kind,image,x1_px,y1_px,x2_px,y2_px,visible\n"
          "1,eave,left,10.5,20,110.25,25,1\n"
          "1,eave,right,30.5,20.25,130,25.5,0.9\n"
          "7,ridge,left,200,50,200,80,0.5\n",
          {{"info", "FILE"}, {"run", "tracked.yaml", "--out", "OUT", "--no-report"}});
  out.add("gates.yaml",
          "gates:\n"
          "  - {class: total, method: lines, metric: rms_m, max: 0.30}\n"
          "  - {class: aligned, metric: rms_m, max_ratio_to: {class: not_aligned}, ratio: 2.5}\n"
          "  - {class: total, metric: evaluated_share, min: 0.80}\n"
          "  - {metric: rms_m, class: total, max_increase_over_baseline: 0.02}\n",
          kGatesCommands);
}

/// An orientation of every format, as the fixtures of its readers.
void write_orientations(Writer& out) {
  const fs::path fixtures = fs::path(test::source_dir()) / "tests/io/orientation/fixtures";
  const auto content = [&](const std::string& name) {
    std::ifstream stream(fixtures / name, std::ios::binary);
    return std::string{std::istreambuf_iterator<char>(stream), {}};
  };
  const Command info{"info", "FILE", "--angles", "deg", "--matrix", "world_from_camera"};
  Command map = info;
  map.insert(map.end(), {"--map", "OUT.gpkg", "--ground-height", "6"});
  for (const char* name :
       {"block_calibrated_camera_parameters.txt", "blocks_exchange_angles.xml",
        "blocks_exchange_enu.xml", "inpho.prj", "metashape_utm.xml", "opensfm.json"}) {
    out.add(name, content(name), {info, map});
  }
  for (const char* name : {"opk_deg.csv", "opk_bare.txt", "pat_b_world_from_camera.ori"}) {
    Command with_cameras = map;
    with_cameras.insert(with_cameras.end(), {"--cameras", "cameras.yaml"});
    out.add(name, content(name), {info, with_cameras});
  }
  Command of_cameras{"info", "opk_deg.csv", "--cameras", "FILE"};
  out.add("cameras.yaml", content("cameras.yaml"), {of_cameras});
}

/// A patch that takes its heights and windows from an area, a file of polygons and a surface model.
void write_area(Writer& out, const fs::path& folder) {
  std::ifstream stream(folder / "patch.yaml", std::ios::binary);
  std::string patch{std::istreambuf_iterator<char>(stream), {}};
  const std::size_t heights = patch.find("height_range:");
  patch.replace(heights, patch.find('\n', heights) - heights,
                "height_range: auto\nsurface_model: dsm.asc\narea: area.geojson");
  const Command info{"info", "area.yaml"};
  out.add("area.yaml", patch, {{"info", "FILE"}, {"run", "FILE", "--out", "OUT", "--no-report"}});
  out.add(
      "area.geojson",
      R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::25832"}},)"
      R"("features":[{"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":)"
      R"([[[513010,5403010],[513030,5403010],[513030,5403030],[513010,5403010]]]}}]})",
      {info});
  out.add("dsm.asc",
          "ncols 3\nnrows 2\nxllcorner 513000\nyllcorner 5403000\ncellsize 20\nNODATA_value -9999\n"
          "251.5 262.5 253.5\n254.5 265 -9999\n",
          {info});
}

/// What `run` has written into `results`, read back by other commands.
void add_results(Writer& out, const std::string& patch) {
  const Commands readers{{"gate", "results", "--gates", "gates.yaml"},
                         {"compare", "results", "results"},
                         {"report", "results"}};
  for (const char* name : {"run.json", "table1.json", "table2.json"}) {
    out.add(std::string("results/") + name, readers);
  }
  const std::string of_patch = "results/" + patch + "/";
  for (const char* name :
       {"evaluation.lines.json", "evaluation.direct.json", "lines.lines.geojson"}) {
    out.add(of_patch + name, readers);
  }
  out.add(of_patch + "matches.csv", kMatchCommands);
  for (const char* name : {"stages.json", "segments.left.csv", "matches.csv"}) {
    out.add(of_patch + name, {{"run", "patch.yaml", "--out", "results", "--methods", "direct,lines",
                               "--resume", "--no-report"}});
  }
}

}  // namespace

std::vector<BaseFile> write_base_files(const fs::path& folder, const std::string& patch) {
  Writer out(folder);
  write_line_files(out);
  write_cloud_files(out);
  write_laz_files(out);
  write_images(out);
  write_texts(out);
  write_orientations(out);
  write_area(out, folder);
  add_results(out, patch);
  return std::move(out.files);
}

}  // namespace ridgeline::test
