// SPDX-License-Identifier: BSD-3-Clause
#include "apps/report/report_json.h"

#include "apps/report/base64.h"
#include "apps/report/line_observations.h"
#include "evaluate/files/result_folder_reader.h"
#include "evaluate/gates/gate_report.h"
#include "evaluate/statistics/product_method.h"
#include "evaluate/tables/evaluation_json.h"
#include "evaluate/tables/shift_text.h"
#include "evaluate/tables/table2.h"
#include "io/images/encoded_picture.h"
#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/epipolar.h"

#include <cmath>
#include <filesystem>
#include <limits>
#include <string_view>

namespace ridgeline::apps {
namespace {

using evaluate::Json;

constexpr int kSchema = 2;

double rounded(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  return std::round(value * scale) / scale;
}

/// Coordinates rounded to a tenth of a millimetre, finer than a screen or a table shows.
Json coordinates(const Eigen::Vector3d& x) {
  Json json = Json::array();
  for (const double c : x) json.push_back(rounded(c, 4));
  return json;
}

template <typename Matrix>
Json matrix_json(const Matrix& m) {
  Json json = Json::array();
  for (Eigen::Index r = 0; r < m.rows(); ++r) {
    for (Eigen::Index c = 0; c < m.cols(); ++c) json.push_back(m(r, c));
  }
  return json;
}

std::string segments_base64(const std::vector<EdgeSegment>& segments) {
  std::vector<float> values;
  values.reserve(4 * segments.size());
  for (const EdgeSegment& s : segments) {
    for (const Eigen::Vector2d& end : {s.in_image.start, s.in_image.end}) {
      values.push_back(static_cast<float>(end.x()));
      values.push_back(static_cast<float>(end.y()));
    }
  }
  return base64(values);
}

/// One bit per segment, the lowest bit of a byte first: whether the segment is aligned with its
/// epipolar line for the other image.
std::string aligned_base64(const ReportPatch& patch, std::size_t view, std::size_t other) {
  const std::vector<EdgeSegment>& segments = patch.images->segments[view];
  const ProjectionMatrix own_camera = patch.image_from_local(view);
  const ProjectionMatrix other_camera = patch.image_from_local(other);
  std::vector<std::uint8_t> bits((segments.size() + 7) / 8);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const double angle_deg =
        deg_from_rad(epipolar_angle_rad(own_camera, other_camera, segments[i].line.segment));
    if (angle_deg <= patch.max_aligned_angle_deg) bits[i / 8] |= 1U << (i % 8);
  }
  return base64(bits);
}

/// Focal lengths and principal point in pixels of the file, and the distortion coefficients; null
/// without distortion.
Json lens_json(const io::PatchImage& view) {
  if (!view.interior || view.interior->distortion.is_zero()) return nullptr;
  const Eigen::Vector2d& focal_length_px = view.interior->focal_length_px;
  const Eigen::Vector2d centre_px = view.interior->principal_point_px - view.window_px;
  const BrownDistortion& d = view.interior->distortion;
  return Json::array({focal_length_px.x(), focal_length_px.y(), centre_px.x(), centre_px.y(), d.k1,
                      d.k2, d.k3, d.p1, d.p2});
}

Json view_json(const ReportPatch& patch, std::size_t i) {
  constexpr int kQuality = 80;
  const io::PatchImage& view = patch.patch->images[i];
  const std::string jpeg = io::jpeg_bytes(patch.images->pictures[i], kQuality);
  Json aligned = Json::array();
  for (std::size_t other = 0; other < patch.images->pictures.size(); ++other) {
    aligned.push_back(other == i ? "" : aligned_base64(patch, i, other));
  }
  return {{"id", view.id},
          {"file", std::filesystem::path(view.path).filename().string()},
          {"width_px", static_cast<int>(patch.images->sizes_px[i].x())},
          {"height_px", static_cast<int>(patch.images->sizes_px[i].y())},
          {"corner_px", Json::array({view.window ? view.window->column : 0,
                                     view.window ? view.window->row : 0})},
          {"lens", lens_json(view)},
          {"projection", matrix_json(patch.image_from_local(i))},
          {"segments", segments_base64(patch.images->segments[i])},
          {"aligned", std::move(aligned)},
          {"jpeg", base64(std::as_bytes(std::span(jpeg)))}};
}

/// A pair with its matches. `score`: of this pair; null without reference matches.
Json pair_json(const ReportPair& pair, const evaluate::MatchingScore* score) {
  Json matches = Json::array();
  for (std::size_t i = 0; i < pair.matches.size(); ++i) {
    const Correspondence& m = pair.matches[i];
    Json match{{"left", m.base},
               {"right", m.other},
               {"score", rounded(m.score, 4)},
               {"votes", rounded(m.votes, 3)}};
    if (score != nullptr) match["verdict"] = evaluate::name(score->verdicts[i]);
    matches.push_back(std::move(match));
  }
  Json missed = Json::array();
  if (score != nullptr) {
    for (const Correspondence& m : score->missed) missed.push_back(Json::array({m.base, m.other}));
  }
  return {{"base", pair.views.base},
          {"search", pair.views.search},
          {"matches", std::move(matches)},
          {"missed", std::move(missed)}};
}

/// Each track as view, segment, view, segment, ...
Json tracks_json(const std::vector<Track>& tracks) {
  Json json = Json::array();
  for (const Track& track : tracks) {
    Json& row = json.emplace_back(Json::array());
    for (const Observation& seen : track.observations) {
      row.push_back(seen.view);
      row.push_back(seen.segment);
    }
  }
  return json;
}

Json images_json(const ReportPatch& patch) {
  if (!patch.images) return nullptr;
  const ReportImages& images = *patch.images;
  Json views = Json::array();
  for (std::size_t i = 0; i < images.pictures.size(); ++i) views.push_back(view_json(patch, i));
  Json pairs = Json::array();
  for (const ReportPair& pair : images.pairs) {
    const bool is_judged = images.score && pairs.empty();  // the first one is the base pair
    pairs.push_back(pair_json(pair, is_judged ? &*images.score : nullptr));
  }
  return {{"views", std::move(views)},
          {"max_aligned_angle_deg", patch.max_aligned_angle_deg},
          {"has_reference", images.score.has_value()},
          {"pairs", std::move(pairs)},
          {"tracks", tracks_json(images.tracks)},
          {"n_unmatched", images.n_unmatched}};
}

/// The points, with positions in steps of 1/65535 of their bounding box; null if there are none.
Json points_json(const std::vector<Eigen::Vector3d>& x_in_local) {
  if (x_in_local.empty()) return nullptr;
  Eigen::Vector3d low = x_in_local.front();
  Eigen::Vector3d high = low;
  for (const Eigen::Vector3d& x : x_in_local) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  constexpr double kSteps = std::numeric_limits<std::uint16_t>::max();
  const Eigen::Vector3d step = ((high - low) / kSteps).cwiseMax(1e-9);
  std::vector<std::uint16_t> positions;
  positions.reserve(3 * x_in_local.size());
  for (const Eigen::Vector3d& x : x_in_local) {
    for (Eigen::Index a = 0; a < 3; ++a) {
      positions.push_back(static_cast<std::uint16_t>(std::lround((x[a] - low[a]) / step[a])));
    }
  }
  return {{"n_shown", x_in_local.size()},
          {"low", coordinates(low)},
          {"step", matrix_json(step)},
          {"positions", base64(positions)}};
}

Json cloud_json(const ShownCloud& cloud) {
  Json json = points_json(cloud.x_in_local);
  if (json.is_null()) return json;
  json["n_read"] = cloud.n_read;
  json["n_all"] = cloud.n_all;
  json["per_m2"] = rounded(cloud.points_per_m2, 2);
  json["no_data_share"] =
      cloud.no_data_share ? Json(rounded(*cloud.no_data_share, 4)) : Json(nullptr);
  return json;
}

Json plane_json(const ShownPlane& plane) {
  Json outline = Json::array();
  for (const Eigen::Vector3d& x : plane.outline) outline.push_back(coordinates(x));
  return {{"id", plane.id},
          {"normal", matrix_json(Eigen::Vector3d(plane.plane.normal()))},
          {"n_inliers", plane.n_inliers},
          {"rms_m", plane.rms_m},
          {"outline", std::move(outline)}};
}

Json image_segment(const std::optional<Segment2>& s) {
  if (!s) return nullptr;
  return Json::array({rounded(s->start.x(), 3), rounded(s->start.y(), 3), rounded(s->end.x(), 3),
                      rounded(s->end.y(), 3)});
}

/// The segments of a line as [view, number or null, pixels or null].
Json observations_json(const ReportPatch& patch, const io::Line& line) {
  Json json = Json::array();
  for (const LineInImage& seen : observations_of(patch, line)) {
    json.push_back(Json::array(
        {seen.view, seen.segment ? Json(*seen.segment) : Json(nullptr), image_segment(seen.px)}));
  }
  return json;
}

/// How a line appears in each image: [state] or, with a known offset, [state, offset, sigma]; null
/// for an image that does not contain the line.
Json line_in_views_json(const std::vector<LineInView>& views) {
  Json json = Json::array();
  for (const LineInView& view : views) {
    if (view.state == ViewOfLine::kOutside) {
      json.push_back(nullptr);
      continue;
    }
    Json& row = json.emplace_back(Json::array({name(view.state)}));
    if (!view.offset) continue;
    row.push_back(rounded(view.offset->offset_px, 3));
    row.push_back(rounded(view.offset->sigma_px, 3));
  }
  return json;
}

/// Adds the data of the line file to the judgement. A line that was moved before it was judged also
/// gets its position in the images.
void add_geometry(const ReportPatch& patch, const ReportMethod& method, std::size_t i, Json& json) {
  const io::Line& line = *method.lines[i];
  if (const auto judged = method.judged_segment(i)) {
    json["start"] = coordinates(judged->start);
    json["end"] = coordinates(judged->end);
    if (!method.moved_m().isZero()) {
      json["seen_start"] = coordinates(method.segments[i]->start);
      json["seen_end"] = coordinates(method.segments[i]->end);
    }
  }
  json["observations"] = observations_json(patch, line);
  json["construction"] = line.status;
  if (line.n_points) json["n_points"] = *line.n_points;
  if (line.n_images) json["n_images"] = *line.n_images;
}

/// A line in the form that the page reads. `json`: the line as in evaluation.METHOD.json.
Json line_json(const ReportPatch& patch, const ReportMethod& method, std::size_t i, Json json) {
  for (Json& plane : json.at("planes")) {
    plane.erase("normal");
    plane.erase("d");
  }
  if (method.lines[i]) add_geometry(patch, method, i, json);
  if (!method.true_errors_m.empty()) {
    json["true_error_m"] = evaluate::number_json(method.true_errors_m[i]);
  }
  return json;
}

Json method_json(const ReportPatch& patch, const ReportMethod& method, const ShownPlanes& planes) {
  Json judged = evaluate::evaluation_json(method.evaluation);
  Json json{{"name", method.evaluation.method}};
  for (const char* key :
       {"options", "summary", "accuracy", "calibration", "strata", "standards", "decoys"}) {
    json[key] = std::move(judged.at(key));
  }
  if (judged.contains("completeness")) {
    json["completeness"] = std::move(judged["completeness"]);
    json["completeness"].erase("edges");
  }
  Json lines = Json::array();
  const std::vector<std::vector<LineInView>> in_views = lines_in_views(patch, method);
  for (std::size_t i = 0; i < method.lines.size(); ++i) {
    Json& line = lines.emplace_back(line_json(patch, method, i, std::move(judged.at("lines")[i])));
    if (!in_views.empty()) line["views"] = line_in_views_json(in_views[i]);
  }
  json["lines"] = std::move(lines);
  json["planes"] = Json::array();
  for (const ShownPlane& plane : planes.planes) json["planes"].push_back(plane_json(plane));
  json["plane_of_point"] = base64(planes.plane_of_point);
  if (!method.buildings.empty()) json["buildings"] = method.buildings;
  if (!method.to_fix.empty()) json["to_fix"] = method.to_fix;
  return json;
}

/// The index of the method whose lines are the product of the run.
std::size_t product_of(const ReportPatch& patch) {
  return evaluate::product_index(patch.methods, [](const ReportMethod& method) {
    return std::string_view(method.evaluation.method);
  });
}

Json patch_json(const ReportPatch& patch, const ShownScene& scene, bool is_of_files) {
  Json methods = Json::array();
  for (std::size_t m = 0; m < patch.methods.size(); ++m) {
    methods.push_back(method_json(patch, patch.methods[m], scene.methods[m]));
  }
  std::string crs = "unknown";
  if (patch.patch) crs = io::describe(patch.patch->crs).name;
  if (crs == "unknown" && !patch.cloud.crs.empty()) crs = patch.cloud.crs;
  return {{"id", patch.id},
          {"folder", patch.subfolder},
          {"crs", crs},
          {"origin_m", coordinates(patch.frame.origin_m)},
          {"notes", patch.notes},
          {"images", images_json(patch)},
          {"points", cloud_json(patch.cloud)},
          {"surface", points_json(patch.surface_in_local)},
          {"methods", std::move(methods)},
          {"product", is_of_files ? 0 : product_of(patch)}};
}

/// The part of run.json that the page shows, without folders, which concern only the sender, and
/// without times, so that identical runs give identical reports.
Json run_json(const Json& run) {
  Json json = Json::object();
  for (const char* key : {"command", "versions", "options", "inputs", "messages", "page"}) {
    if (run.contains(key)) json[key] = run[key];
  }
  for (const Json& area : run.value("runs", Json::array())) {
    Json shown{{"bounds_m", area.at("area")}};
    for (const char* key : {"page", "n_lines", "n_evaluated", "rms_m"}) {
      if (area.contains(key)) shown[key] = area[key];
    }
    json["areas"].push_back(std::move(shown));
  }
  // warnings of `run` are omitted: a resumed run does not repeat them, and reading the cloud again
  // issues its own
  if (results::is_of_line_files(json)) json["warnings"] = run.value("warnings", Json::array());
  if (json.contains("inputs")) {
    for (Json& input : json["inputs"]) {
      input["path"] = std::filesystem::path(input.value("path", "")).filename().string();
    }
  }
  return json;
}

evaluate::Table2 table2_of(const ReportInput& input) {
  evaluate::Table2 table;
  table.joint_adjusts_to_faces = results::joint_adjusts_to_faces(input.run).value_or(false);
  for (const ReportPatch& patch : input.patches) {
    for (const ReportMethod& method : patch.methods) {
      const evaluate::Evaluation& e = method.evaluation;
      table.results.push_back({e.patch, e.method, e.classes});
      if (std::string note = evaluate::moved_note(e); !note.empty()) {
        table.moved.push_back(std::move(note));
      }
    }
  }
  return table;
}

Json part_of(const std::string& table, const char* key) { return Json::parse(table).at(key); }

}  // namespace

ShownScene shown_scene(const ReportPatch& patch) {
  ShownScene scene;
  for (const ReportMethod& method : patch.methods) {
    scene.methods.push_back(shown_planes(patch, method));
  }
  return scene;
}

Json report_json(const ReportInput& input,
                 const std::vector<ShownScene>& scenes,
                 const std::optional<evaluate::GateReport>& gates) {
  Json patches = Json::array();
  const bool is_of_files = results::is_of_line_files(input.run);
  for (std::size_t i = 0; i < input.patches.size(); ++i) {
    patches.push_back(patch_json(input.patches[i], scenes[i], is_of_files));
  }
  Json table1 = Json::parse(evaluate::to_json(input.table1));
  const std::string table2 = evaluate::to_json(table2_of(input));
  Json json{{"schema", kSchema},
            {"note", evaluate::kFixedSentence},
            {"run", run_json(input.run)},
            {"gates", gates ? Json::parse(evaluate::to_json(*gates)) : Json(nullptr)},
            {"table1", std::move(table1["rows"])},
            {"table2", part_of(table2, "rows")},
            {"table2_footnote", part_of(table2, "footnote")},
            {"patches", std::move(patches)}};
  if (table1.contains("tracks")) json["table1_tracks"] = std::move(table1["tracks"]);
  return json;
}

}  // namespace ridgeline::apps
