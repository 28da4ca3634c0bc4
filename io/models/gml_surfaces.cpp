// SPDX-License-Identifier: BSD-3-Clause
#include "io/models/gml_surfaces.h"

#include "io/error.h"
#include "io/text/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace ridgeline::io {
namespace {

constexpr LeftOutKind kNarrowPolygon{"polygon of fewer than three vertices",
                                     "polygons of fewer than three vertices"};
constexpr LeftOutKind kForeignReference{"reference to another file", "references to other files"};
constexpr std::string_view kXlinkSpace = "http://www.w3.org/1999/xlink";

template <std::size_t kN>
bool is_one_of(const std::array<std::string_view, kN>& names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

/// Drops the last vertex of a ring if it repeats the first, as required by GML.
void open_ring(Ring& ring) {
  if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
}

}  // namespace

void NumberText::add(std::string_view piece) {
  constexpr std::string_view kSeparators = " \t\r\n,";  // commas in <coordinates>
  while (true) {
    const std::size_t end = piece.find_first_of(kSeparators);
    const std::string_view word = piece.substr(0, end);
    if (end == std::string_view::npos) {
      word_ += word;
      if (word_.size() > 1000) take_word(word_);  // no number is that long
      return;
    }
    if (word_.empty()) {
      take_word(word);
    } else {
      word_ += word;
      take_word(std::exchange(word_, {}));
    }
    piece.remove_prefix(end + 1);
  }
}

void NumberText::take_word(std::string_view word) {
  constexpr std::size_t kMaxShownCharacters = 40;
  constexpr std::size_t kMaxNumbers = 3'000'000;
  if (word.empty()) return;
  const std::optional<double> number = to_double(word);
  if (!number || !std::isfinite(*number)) {
    fail_(fmt::format("'{}' is not a finite number", word.substr(0, kMaxShownCharacters)));
  }
  if (numbers_.size() >= kMaxNumbers) fail_("more than 1,000,000 vertices");
  numbers_.push_back(*number);
}

std::vector<double> NumberText::take() {
  take_word(std::exchange(word_, {}));
  return std::exchange(numbers_, {});
}

GmlSurfaces::GmlSurfaces(const XmlStream& stream, KindCounts& left_out)
    : stream_(stream),
      left_out_(left_out),
      numbers_([this](const std::string& message) { fail(message); }) {}

GmlSurfaces::Role GmlSurfaces::role_of(std::string_view local) const {
  constexpr std::array<std::string_view, 4> kPolygons{"Polygon", "PolygonPatch", "Triangle",
                                                      "Rectangle"};
  constexpr std::array<std::string_view, 2> kRings{"LinearRing", "Ring"};
  constexpr std::array<std::string_view, 2> kOuters{"exterior", "outerBoundaryIs"};
  constexpr std::array<std::string_view, 3> kCoordinateTexts{"posList", "pos", "coordinates"};
  if (is_one_of(kPolygons, local)) return Role::kPolygon;
  if (!in_polygon_) return Role::kOther;
  if (is_one_of(kRings, local)) return Role::kRing;
  if (is_one_of(kOuters, local)) return Role::kOuter;
  if (is_one_of(kCoordinateTexts, local) && !polygon_.rings.empty()) return Role::kCoordinates;
  return Role::kOther;
}

void GmlSurfaces::start(const XmlName& name, const XmlAttributes& attributes) {
  Frame frame;
  if (!frames_.empty()) {
    frame.is_reversed = frames_.back().is_reversed;
    frame.dimension = frames_.back().dimension;
  }
  frame.name = name.local;
  frame.role = role_of(name.local);
  frame.id = attributes.value("id", kGmlSpace);
  frame.first = surfaces_.size();
  if (name.local == "OrientableSurface" && attributes.value("orientation") == "-") {
    frame.is_reversed = !frame.is_reversed;
  }
  if (const std::string_view dimension = attributes.value("srsDimension"); !dimension.empty()) {
    frame.dimension = dimension == "2" ? 2 : 3;
  }
  const std::string_view href = attributes.value("href", kXlinkSpace);
  if (href.starts_with('#') && href.size() > 1) {
    surfaces_.push_back({{}, {}, std::string(href.substr(1)), frame.is_reversed});
  } else if (!href.empty()) {
    left_out_.add(kForeignReference);
  }
  if (frame.role == Role::kPolygon) begin_polygon(frame);
  if (frame.role == Role::kRing) begin_ring();
  frames_.push_back(std::move(frame));
}

void GmlSurfaces::begin_polygon(const Frame& frame) {
  if (in_polygon_) fail("lies inside another polygon");
  polygon_ = {{}, frame.id, {}, frame.is_reversed};
  in_polygon_ = true;
  is_flat_ = false;
  outer_ring_ = -1;
}

void GmlSurfaces::begin_ring() {
  if (!frames_.empty() && frames_.back().role == Role::kOuter) {
    outer_ring_ = static_cast<std::ptrdiff_t>(polygon_.rings.size());
  }
  polygon_.rings.emplace_back();
}

void GmlSurfaces::text(std::string_view piece) {
  if (frames_.back().role == Role::kCoordinates) numbers_.add(piece);
}

void GmlSurfaces::end() {
  // errors name the element that ends, so it is popped last
  const Frame& frame = frames_.back();
  if (frame.role == Role::kCoordinates) end_coordinates(frame);
  if (frame.role == Role::kPolygon) end_polygon();
  if (!frame.id.empty() && surfaces_.size() > frame.first) {
    by_id_.emplace(frame.id, SurfaceRange{frame.first, surfaces_.size()});
  }
  frames_.pop_back();
}

void GmlSurfaces::end_coordinates(const Frame& frame) {
  const std::vector<double> numbers = numbers_.take();
  const bool is_lone_flat = frame.name == "pos" && numbers.size() == 2;
  if (frame.dimension == 2 || is_lone_flat) {
    is_flat_ = true;
    return;
  }
  if (numbers.size() % 3 != 0)
    fail(fmt::format("{} numbers; three are needed for each vertex", numbers.size()));
  Ring& ring = polygon_.rings.back();
  for (std::size_t i = 0; i < numbers.size(); i += 3)
    ring.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
}

void GmlSurfaces::end_polygon() {
  in_polygon_ = false;
  if (is_flat_) {
    left_out_.add(kinds::kFlatPolygon);
    return;
  }
  std::vector<Ring>& rings = polygon_.rings;
  if (outer_ring_ > 0)
    std::rotate(rings.begin(), rings.begin() + outer_ring_, rings.begin() + outer_ring_ + 1);
  std::ranges::for_each(rings, open_ring);
  if (outer_ring_ < 0 || rings[0].size() < 3) {
    left_out_.add(kNarrowPolygon);
    return;
  }
  std::erase_if(rings, [](const Ring& ring) { return ring.size() < 3; });
  surfaces_.push_back(std::move(polygon_));
}

const SurfaceRange* GmlSurfaces::with_id(const std::string& id) const {
  const auto found = by_id_.find(id);
  return found == by_id_.end() ? nullptr : &found->second;
}

void GmlSurfaces::clear() {
  surfaces_.clear();
  by_id_.clear();
}

void GmlSurfaces::fail(const std::string& message) const {
  const std::string element = frames_.empty() ? "" : fmt::format("<{}>", frames_.back().name);
  const std::string owner =
      in_polygon_ && !polygon_.id.empty() ? fmt::format(" of polygon \"{}\"", polygon_.id) : "";
  throw IoError(stream_.place(), fmt::format("{}{}: {}", element, owner, message));
}

}  // namespace ridgeline::io
