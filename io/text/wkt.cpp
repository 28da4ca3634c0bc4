// SPDX-License-Identifier: BSD-3-Clause
#include "io/text/wkt.h"

#include "io/text/text.h"

#include <algorithm>
#include <array>

namespace ridgeline::io {
namespace {

constexpr std::array<std::string_view, 17> kGeometryNames{
    "point",        "linestring",    "polygon",        "multipoint",   "multilinestring",
    "multipolygon", "triangle",      "curve",          "multicurve",   "geometrycollection",
    "surface",      "multisurface",  "circularstring", "curvepolygon", "polyhedralsurface",
    "tin",          "compoundcurve",
};

bool is_ascii_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

std::size_t word_length(std::string_view text) {
  const auto end = std::ranges::find_if_not(text, is_ascii_letter);
  return static_cast<std::size_t>(end - text.begin());
}

bool is_geometry_name(std::string_view lower) {
  return std::ranges::find(kGeometryNames, lower) != kGeometryNames.end();
}

/// The dimensions at the end of a geometry's name: "z" of "linestringz"; empty if it has none.
std::string_view dimensions_of(std::string_view lower) {
  for (const std::string_view ending : {"zm", "z", "m"}) {
    if (lower.ends_with(ending) &&
        is_geometry_name(lower.substr(0, lower.size() - ending.size()))) {
      return ending;
    }
  }
  return {};
}

/// A word of WKT, with blanks around any dimensions at its end.
std::string standard_word(std::string_view word) {
  const std::string lower = lower_case(word);
  if (lower == "z" || lower == "m" || lower == "zm") return std::string(word) + " ";
  const std::size_t n_dimensions = dimensions_of(lower).size();
  if (n_dimensions == 0) return std::string(word);
  const std::size_t n_name = word.size() - n_dimensions;
  return std::string(word.substr(0, n_name)) + " " + std::string(word.substr(n_name)) + " ";
}

}  // namespace

bool begins_as_wkt(std::string_view text) {
  text = trimmed(text);
  const std::string lower = lower_case(text.substr(0, 24));
  if (lower.starts_with("srid=")) return text.find(';') != std::string_view::npos;
  const std::string name = lower.substr(0, word_length(lower));
  if (!is_geometry_name(name.substr(0, name.size() - dimensions_of(name).size()))) return false;
  // A bare name may also be the start of a table header, "point,x,y".
  const std::string_view rest = trimmed(text.substr(name.size()));
  const std::string next = lower_case(rest.substr(0, word_length(rest)));
  return rest.starts_with('(') || next == "z" || next == "m" || next == "zm" || next == "empty";
}

std::string standard_wkt(std::string_view text) {
  std::string wkt;
  while (!text.empty()) {
    const std::size_t n_letters = word_length(text);
    // the exponent of a number is one letter without a preceding blank
    const bool is_word = n_letters > 1 || (n_letters == 1 && wkt.ends_with(' '));
    const std::size_t n = is_word ? n_letters : 1;
    wkt += is_word ? standard_word(text.substr(0, n)) : std::string(text.substr(0, n));
    text.remove_prefix(n);
  }
  return wkt;
}

}  // namespace ridgeline::io
