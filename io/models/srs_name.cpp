// SPDX-License-Identifier: BSD-3-Clause
#include "io/models/srs_name.h"

#include "io/text/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace ridgeline::io {
namespace {

struct AdvSystem {
  std::string_view name, code;
};

/// Names of the AdV, the German surveying offices, with their EPSG codes.
constexpr std::array kAdvPlane{
    AdvSystem{"ETRS89_UTM31", "25831"}, AdvSystem{"ETRS89_UTM32", "25832"},
    AdvSystem{"ETRS89_UTM33", "25833"}, AdvSystem{"DE_DHDN_3GK2", "31466"},
    AdvSystem{"DE_DHDN_3GK3", "31467"}, AdvSystem{"DE_DHDN_3GK4", "31468"},
    AdvSystem{"DE_DHDN_3GK5", "31469"}, AdvSystem{"ETRS89_Lat-Lon", "4258"}};
constexpr std::array kAdvHeights{
    AdvSystem{"DE_DHHN2016_NH", "7837"}, AdvSystem{"DE_DHHN92_NH", "5783"},
    AdvSystem{"DE_DHHN85_NOH", "5784"}, AdvSystem{"DE_DHHN12_NOH", "7699"}};

std::vector<std::string_view> pieces_of(std::string_view text, std::string_view separators) {
  std::vector<std::string_view> pieces;
  while (true) {
    const std::size_t end = text.find_first_of(separators);
    pieces.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return pieces;
    text.remove_prefix(end + 1);
  }
}

std::string_view last_digits(std::string_view text) {
  const std::size_t last_other = text.find_last_not_of("0123456789");
  return last_other == std::string_view::npos ? text : text.substr(last_other + 1);
}

/// The codes in a name of any form: the last item of each part that names EPSG, and a number after
/// a "+".
std::vector<std::string> epsg_codes(std::string_view name) {
  std::vector<std::string> codes;
  for (const std::string_view piece : pieces_of(name, ",&;+")) {
    const std::string_view digits = last_digits(piece);
    const bool names_epsg = lower_case(piece).find("epsg") != std::string::npos;
    const bool follows = !codes.empty() && digits.size() == piece.size();
    if (!digits.empty() && (names_epsg || follows)) codes.emplace_back(digits);
  }
  return codes;
}

template <std::size_t kN>
std::optional<std::string> code_in(const std::array<AdvSystem, kN>& systems,
                                   std::string_view name) {
  const auto found = std::ranges::find(systems, name, &AdvSystem::name);
  if (found == systems.end()) return std::nullopt;
  return std::string(found->code);
}

/// The code of the plane and, if known, that of the heights; empty for an unknown plane.
std::vector<std::string> adv_codes(std::string_view name, std::string& warning) {
  std::vector<std::string> codes;
  const std::vector<std::string_view> parts = pieces_of(name.substr(name.rfind(':') + 1), "*");
  const auto plane = code_in(kAdvPlane, parts[0]);
  if (!plane) return codes;
  codes.push_back(*plane);
  // a third part names the geoid from which the heights were derived
  if (parts.size() < 2) return codes;
  if (const auto heights = code_in(kAdvHeights, parts[1])) {
    codes.push_back(*heights);
  } else {
    warning = fmt::format("srsName = \"{}\": the height system is unknown", name);
  }
  return codes;
}

bool is_understood(const Crs& crs) {
  try {
    (void)describe(crs);
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

}  // namespace

SrsName read_srs_name(std::string_view name) {
  constexpr std::size_t kMaxShownCharacters = 120;
  SrsName result;
  name = trimmed(name);
  if (name.empty()) return result;
  const std::string shown(name.substr(0, kMaxShownCharacters));
  const std::string lower = lower_case(name);
  const bool is_adv = lower.starts_with("urn:adv:");
  result.keeps_axis_order = lower.starts_with("urn:") || lower.starts_with("http");
  const std::vector<std::string> codes =
      is_adv ? adv_codes(name, result.warning) : epsg_codes(name);
  Crs crs{codes.empty() ? std::string(name) : "EPSG:" + codes[0]};
  if (codes.size() > 1) {
    const Crs compound{crs.definition + "+" + codes[1]};
    if (is_understood(compound)) {
      crs = compound;
    } else {
      result.warning = fmt::format("srsName = \"{}\": the height system EPSG:{} is unknown to PROJ",
                                   shown, codes[1]);
    }
  }
  if (is_understood(crs)) {
    result.crs = std::move(crs);
    return result;
  }
  require_proj_data();
  result.warning = fmt::format(
      "srsName = \"{}\" is not a reference system known to PROJ; assuming that of the cloud",
      shown);
  return result;
}

}  // namespace ridgeline::io
