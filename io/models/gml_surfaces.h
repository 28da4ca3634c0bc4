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

/// The beginning of the GML namespaces, which end in "" or "/3.2" depending on the version.
inline constexpr std::string_view kGmlSpace = "http://www.opengis.net/gml";

/// A GML polygon, or a reference to surfaces defined elsewhere (xlink:href="#id").
struct GmlSurface {
  std::vector<Ring> rings;   ///< the outer one first; empty for a reference
  std::string id;            ///< gml:id of the polygon; may be empty
  std::string reference;     ///< the id to which a reference points
  bool is_reversed = false;  ///< lies in an OrientableSurface of orientation "-"
};

/// Range of indices into GmlSurfaces::surfaces(), from `first` up to but excluding `end`.
struct SurfaceRange {
  std::size_t first = 0, end = 0;
};

/// Numbers separated by blanks or commas in a text that arrives in pieces. Anything that is not a
/// finite number is reported by calling `fail`, which throws.
class NumberText {
 public:
  using Fail = std::function<void(const std::string& message)>;

  explicit NumberText(Fail fail) : fail_(std::move(fail)) {}
  void add(std::string_view piece);
  /// The numbers since the last call, at most three million.
  std::vector<double> take();

 private:
  void take_word(std::string_view word);

  Fail fail_;
  std::string word_;  ///< the beginning of a word that ends in the next piece
  std::vector<double> numbers_;
};

/// Collects the polygons in the geometries of one building: from solids, shells, (composite,
/// oriented, triangulated) surfaces and any other element with polygons.
class GmlSurfaces {
 public:
  /// Counts in `left_out` the polygons that are not faces: those without heights and those with
  /// fewer than three vertices.
  GmlSurfaces(const XmlStream& stream, KindCounts& left_out);

  // To be called when an element of a geometry begins, has text, and ends. Each throws IoError for
  // invalid coordinates.
  void start(const XmlName& name, const XmlAttributes& attributes);
  void text(std::string_view piece);
  void end();

  [[nodiscard]] const std::vector<GmlSurface>& surfaces() const { return surfaces_; }
  /// The surfaces in the element with this id; null if there is none.
  [[nodiscard]] const SurfaceRange* with_id(const std::string& id) const;

  /// Discards everything collected.
  void clear();

 private:
  enum class Role { kOther, kPolygon, kOuter, kRing, kCoordinates };
  struct Frame {
    Role role = Role::kOther;
    std::string name, id;
    std::size_t first = 0;  ///< index of the first surface in it
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
  GmlSurface polygon_;  ///< the polygon being read
  bool in_polygon_ = false;
  bool is_flat_ = false;            ///< the polygon has no heights
  std::ptrdiff_t outer_ring_ = -1;  ///< index of its outer ring
};

}  // namespace ridgeline::io
