// SPDX-License-Identifier: BSD-3-Clause
#include "apps/python/lines.h"

#include "apps/python/arrays.h"
#include "apps/python/bindings.h"
#include "apps/python/entries.h"
#include "apps/python/interruptible.h"
#include "io/lines/read_lines.h"
#include "io/lines/write_lines.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/transformed.h"

#include <pybind11/stl.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ridgeline::python {
namespace py = pybind11;
namespace {

using io::Line;

struct TextColumn {
  const char* name;
  std::string Line::*member;
};
constexpr std::array kTexts{
    TextColumn{"ids", &Line::id},        TextColumn{"line_class", &Line::line_class},
    TextColumn{"status", &Line::status}, TextColumn{"method", &Line::method},
    TextColumn{"kind", &Line::kind},     TextColumn{"building", &Line::building}};

struct SegmentColumn {
  const char* name;
  std::optional<Segment2> Line::*member;
};
constexpr std::array kImageSegments{SegmentColumn{"left_px", &Line::base_px},
                                    SegmentColumn{"right_px", &Line::other_px}};

struct NumberColumn {
  const char* name;
  std::optional<double> Line::*member;
};
constexpr std::array kNumbers{NumberColumn{"epipolar_angle_deg", &Line::epipolar_angle_deg},
                              NumberColumn{"support", &Line::support},
                              NumberColumn{"moved_out_m", &Line::moved_out_m}};

using Ends3 = Eigen::Matrix<double, 2, 3>;  // start, end
using Ends2 = Eigen::Matrix2d;

std::optional<Ends3> ends_of(const Segment3& s) {
  Ends3 ends;
  ends << s.start.transpose(), s.end.transpose();
  return ends;
}

std::optional<Ends2> ends_of(const std::optional<Segment2>& s) {
  if (!s) return std::nullopt;
  Ends2 ends;
  ends << s->start.transpose(), s->end.transpose();
  return ends;
}

void take_texts(const py::dict& arrays, std::vector<Line>& lines) {
  for (const auto& [name, member] : kTexts) {
    if (!arrays.contains(name) || arrays[name].is_none()) continue;
    const auto texts = arrays[name].cast<std::vector<std::string>>();
    check(texts.size() == lines.size(), name, ": ", texts.size(),
          " strings; must be one for each of ", lines.size(), " lines");
    for (std::size_t i = 0; i < lines.size(); ++i) lines[i].*member = texts[i];
  }
}

/// Calls set(line, line index, array) for every line if there is an array of that name.
template <typename Set>
void take_array(const py::dict& arrays,
                const char* name,
                std::vector<py::ssize_t> shape,
                std::vector<Line>& lines,
                const Set& set) {
  shape.insert(shape.begin(), static_cast<py::ssize_t>(lines.size()));
  const std::optional<Array<double>> array = find_array(arrays, name, shape);
  if (!array) return;
  for (std::size_t i = 0; i < lines.size(); ++i) set(lines[i], i, *array);
}

void take_arrays(const py::dict& arrays, std::vector<Line>& lines) {
  take_array(
      arrays, "covariance_m2", {6, 6}, lines,
      [](Line& line, std::size_t i, const Array<double>& array) {
        line.covariance_m2 = matrix_at<6, 6>(array, i);
        if (!line.covariance_m2) return;
        check(line.covariance_m2->allFinite() && line.covariance_m2->diagonal().minCoeff() >= 0.0,
              "covariance_m2: that of line ", i,
              " is not a covariance, must be finite with variances of at least 0, or all NaN");
      });
  for (const auto& [name, member] : kImageSegments) {
    take_array(arrays, name, {2, 2}, lines,
               [m = member](Line& line, std::size_t i, const Array<double>& array) {
                 const std::optional<Ends2> ends = matrix_at<2, 2>(array, i);
                 if (ends) line.*m = Segment2{ends->row(0), ends->row(1)};
               });
  }
  for (const auto& [name, member] : kNumbers) {
    take_array(arrays, name, {}, lines,
               [m = member](Line& line, std::size_t i, const Array<double>& array) {
                 const double number = array.data()[i];
                 if (!std::isnan(number)) line.*m = number;
               });
  }
}

void take_plane_ids(const py::dict& arrays, std::vector<Line>& lines) {
  if (!arrays.contains("plane_ids") || arrays["plane_ids"].is_none()) return;
  const auto ids = arrays["plane_ids"].cast<std::vector<std::vector<int>>>();
  check(ids.size() == lines.size(), "plane_ids: ", ids.size(), " lists; must be one for each of ",
        lines.size(), " lines");
  for (std::size_t i = 0; i < lines.size(); ++i) lines[i].plane_ids = ids[i];
}

py::dict read_lines(const std::string& path,
                    const std::string& assume_crs,
                    bool vertex_pairs,
                    const std::string& lod) {
  io::ReadLinesOptions options;
  options.lod = lod;
  options.assume_crs.definition = assume_crs;
  options.vertex_pairs = vertex_pairs;
  return dict_of(interruptibly([&] { return io::read_lines(path, options); }));
}

std::size_t write_lines(const std::string& path,
                        const py::dict& arrays,
                        const std::string& format) {
  const std::optional<io::LineFormat> known = io::line_format(format);
  check(known.has_value(), "format = ", format, ", must be a name in line_formats");
  const io::LineSet set = line_set_of(arrays, path);
  return interruptibly([&] { return io::write_lines(path, set, *known); });
}

}  // namespace

py::dict dict_of(const io::LineSet& set) {
  py::dict arrays;
  arrays["segments"] = matrix_array<2, 3>(
      set.lines, [](const Line& line) { return ends_of(line.segment_in_world); });
  for (const auto& [name, member] : kTexts) {
    arrays[name] = list_of(set.lines, [m = member](const Line& line) { return line.*m; });
  }
  for (const auto& [name, member] : kNumbers) arrays[name] = number_array(set.lines, member);
  arrays["plane_ids"] = transformed(set.lines, &Line::plane_ids);
  arrays["covariance_m2"] =
      matrix_array<6, 6>(set.lines, [](const Line& line) { return line.covariance_m2; });
  for (const auto& [name, member] : kImageSegments) {
    arrays[name] =
        matrix_array<2, 2>(set.lines, [m = member](const Line& line) { return ends_of(line.*m); });
  }
  arrays["crs"] = set.crs.definition;
  arrays["warnings"] = set.warnings;
  return arrays;
}

io::LineSet line_set_of(const py::dict& arrays, const std::string& name) {
  const auto segments = find_array(arrays, "segments", {-1, 2, 3});
  check(segments.has_value(), "segments: missing");
  io::LineSet set;
  set.path = name;
  set.format = "array";
  take(arrays, "crs", set.crs.definition);
  set.lines.resize(static_cast<std::size_t>(segments->shape(0)));
  for (std::size_t i = 0; i < set.lines.size(); ++i) {
    set.lines[i].id = std::to_string(i);
    set.lines[i].source_fid = static_cast<std::int64_t>(i);
    const Eigen::Map<const Eigen::Matrix<double, 2, 3, Eigen::RowMajor>> ends(segments->data() +
                                                                              6 * i);
    set.lines[i].segment_in_world = {ends.row(0), ends.row(1)};
  }
  take_texts(arrays, set.lines);
  take_arrays(arrays, set.lines);
  take_plane_ids(arrays, set.lines);
  return set;
}

void add_lines(py::module_& core) {
  core.def("read_lines", &read_lines, py::arg("path"), py::arg("assume_crs"),
           py::arg("vertex_pairs"), py::arg("lod"));
  core.def("write_lines", &write_lines, py::arg("path"), py::arg("lines"), py::arg("format"));
  std::vector<std::pair<std::string, std::string>> formats;
  for (const io::LineFormatInfo& info : io::line_formats()) {
    formats.emplace_back(info.name, info.extension);
  }
  core.attr("line_formats") = formats;
}

}  // namespace ridgeline::python
