// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/surface_words.h"

#include "io/text/text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace ridgeline::io {
namespace {

struct SurfaceWord {
  std::string_view text;
  FaceKind kind;
};

/// In English and German, without endings.
constexpr std::array kSurfaceWords{
    SurfaceWord{"roof", FaceKind::kRoof},          SurfaceWord{"dach", FaceKind::kRoof},
    SurfaceWord{"wall", FaceKind::kWall},          SurfaceWord{"wand", FaceKind::kWall},
    SurfaceWord{"facade", FaceKind::kWall},        SurfaceWord{"fassade", FaceKind::kWall},
    SurfaceWord{"ground", FaceKind::kGround},      SurfaceWord{"floor", FaceKind::kGround},
    SurfaceWord{"boden", FaceKind::kGround},       SurfaceWord{"grund", FaceKind::kGround},
    SurfaceWord{"closure", FaceKind::kOther},      SurfaceWord{"outerfloor", FaceKind::kOther},
    SurfaceWord{"outerceiling", FaceKind::kOther}, SurfaceWord{"interiorwall", FaceKind::kOther}};

void drop_ending(std::string_view ending, std::string_view& text) {
  if (text.size() > ending.size() && text.ends_with(ending)) text.remove_suffix(ending.size());
}

/// The kind named by a piece of a word: "roof", "Roofs2", "RoofSurface", "Dachfläche".
FaceKind kind_of_piece(std::string_view piece) {
  const std::string lower = lower_case(piece);
  std::string_view text = lower;
  text = text.substr(0, text.find_last_not_of("0123456789") + 1);
  for (const char* const ending : {"surfaces", "surface", "flaechen", "flaeche",
                                   "fl\xC3\xA4"
                                   "chen",
                                   "fl\xC3\xA4"
                                   "che",
                                   "s"}) {
    drop_ending(ending, text);
  }
  const auto* const found = std::ranges::find(kSurfaceWords, text, &SurfaceWord::text);
  return found == kSurfaceWords.end() ? FaceKind::kUnknown : found->kind;
}

struct Word {
  std::string rest;
  FaceKind kind = FaceKind::kUnknown;
};

Word read_word(std::string_view word) {
  constexpr std::string_view kSeparators = "_-.:/";
  Word read;
  std::vector<std::string_view> others;
  for (std::string_view left = word; !left.empty();) {
    const std::size_t end = std::min(left.find_first_of(kSeparators), left.size());
    const std::string_view piece = left.substr(0, end);
    const FaceKind kind = kind_of_piece(piece);
    if (kind != FaceKind::kUnknown) read.kind = kind;
    if (kind == FaceKind::kUnknown && !piece.empty()) others.push_back(piece);
    left.remove_prefix(std::min(end + 1, left.size()));
  }
  if (read.kind == FaceKind::kUnknown) return {std::string(word)};
  read.rest = fmt::format("{}", fmt::join(others, "_"));
  const bool has_letter = std::ranges::any_of(read.rest, [](char c) {
    return std::isdigit(static_cast<unsigned char>(c)) == 0 && c != '_';
  });
  if (!has_letter) read.rest.clear();
  return read;
}

}  // namespace

FaceKind surface_kind_in(std::string_view name) {
  FaceKind kind = FaceKind::kUnknown;
  for (const std::string_view word : words_of(name)) {
    if (const FaceKind stated = read_word(word).kind; stated != FaceKind::kUnknown) kind = stated;
  }
  return kind;
}

std::vector<std::string> words_without_surfaces(std::string_view name) {
  std::vector<std::string> words;
  for (const std::string_view word : words_of(name)) {
    if (std::string rest = read_word(word).rest; !rest.empty()) words.push_back(std::move(rest));
  }
  return words;
}

}  // namespace ridgeline::io
