// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/models/building_model.h"
#include "io/models/xml_stream.h"

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace ridgeline::io {

/// The beginning of the namespaces of GML, whose versions end in "" and "/3.2".
inline constexpr std::string_view kGmlSpace = "http://www.opengis.net/gml";

/// A polygon of GML, or a reference to surfaces that stand elsewhere (xlink:href="#id").
struct GmlSurface {
  std::vector<Ring> rings;   ///< the outer one first; none for a reference
  std::string id;            ///< gml:id of the polygon; may be empty
  std::string reference;     ///< the id that a reference names
  bool is_reversed = false;  ///< lies in an OrientableSurface of orientation "-"
};

/// Places of surfaces in GmlSurfaces::surfaces(), from `first` up to, but without, `end`.
struct SurfaceRange {
  std::size_t first = 0, end = 0;
};

/// Numbers between blanks or commas in a text that comes in pieces. Throws by `fail` what is no
/// finite number.
class NumberText {
 public:
  using Fail = std::function<void(const std::string& message)>;

  explicit NumberText(Fail fail) : fail_(std::move(fail)) {}
  void add(std::string_view piece);
  /// The numbers since the last call, which are no more than three millions.
  std::vector<double> take();

 private:
  void take_word(std::string_view word);

  Fail fail_;
  std::string word_;  ///< the beginning of a word that ends in the next piece
  std::vector<double> numbers_;
};

/// Collects the polygons in the geometries of one building: of solids, shells, (composite,
/// oriented, triangulated) surfaces and what else holds polygons.
class GmlSurfaces {
 public:
  /// Counts in `left_out` what is no face: polygons without heights and those of fewer than three
  /// vertices.
  GmlSurfaces(const XmlStream& stream, KindCounts& left_out);

  // An element of a geometry begins, has text, and ends. Each throws IoError for coordinates that
  // are none.
  void start(const XmlName& name, const XmlAttributes& attributes);
  void text(std::string_view piece);
  void end();

  [[nodiscard]] const std::vector<GmlSurface>& surfaces() const { return surfaces_; }
  /// The surfaces in the element of an id; null if there is none.
  [[nodiscard]] const SurfaceRange* with_id(const std::string& id) const;

  /// Forgets what was collected.
  void clear();

 private:
  enum class Role { kOther, kPolygon, kOuter, kRing, kCoordinates };
  struct Frame {
    Role role = Role::kOther;
    std::string name, id;
    std::size_t first = 0;  ///< place of the first surface in it
    bool is_reversed = false;
    int dimension = 3;
  };

  [[nodiscard]] Role role_of(std::string_view local) const;
  void begin_polygon(const Frame& frame);
  void begin_ring();
  void end_coordinates(const Frame& frame);
  void end_polygon();
  [[noreturn]] void fail(const std::string& message) const;

  const XmlStream& stream_;
  KindCounts& left_out_;
  NumberText numbers_;
  std::vector<Frame> frames_;
  std::vector<GmlSurface> surfaces_;
  std::unordered_map<std::string, SurfaceRange> by_id_;
  GmlSurface polygon_;  ///< the one that is read
  bool in_polygon_ = false;
  bool is_flat_ = false;            ///< it has no heights
  std::ptrdiff_t outer_ring_ = -1;  ///< place of its outer ring
};

}  // namespace ridgeline::io
