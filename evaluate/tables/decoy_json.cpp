// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/tables/decoy_json.h"

#include "reconstruct/geometry/check.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace ridgeline::evaluate {
namespace {

/// Calls `read` and converts exceptions of the JSON library, for a missing key or a wrong type, to
/// std::invalid_argument.
template <typename Read>
auto read_or_throw(const char* what, const Read& read) {
  try {
    return read();
  } catch (const Json::exception& error) {
    throw std::invalid_argument(std::string(what) + ": " + error.what());
  }
}

std::optional<Interval> interval_of(const Json& json) {
  if (json.is_null()) return std::nullopt;
  return Interval{json.at(0).get<double>(), json.at(1).get<double>()};
}

DecoyKind kind_of(const std::string& text) {
  const auto found =
      std::ranges::find_if(kDecoyKinds, [&](DecoyKind k) { return text == name(k); });
  check(found != kDecoyKinds.end(), "kind: ", text, "; must be height, across or match");
  return *found;
}

DecoyFigure parse_figure(const Json& json) {
  DecoyFigure figure;
  figure.kind = kind_of(json.at("kind").get<std::string>());
  figure.distance_m = json.at("distance_m").get<double>();
  figure.n_lines = json.at("n_lines").get<std::size_t>();
  figure.n_decoys = json.at("n_decoys").get<std::size_t>();
  figure.n_passed = json.at("n_passed").get<std::size_t>();
  figure.n_withheld = json.at("n_withheld").get<std::size_t>();
  figure.n_clusters = json.at("n_clusters").get<std::size_t>();
  figure.ci95 = interval_of(json.at("ci95"));
  check(figure.n_passed <= figure.n_decoys && figure.n_withheld <= figure.n_decoys,
        "n_passed: ", figure.n_passed, ", n_withheld: ", figure.n_withheld,
        "; must be at most n_decoys, ", figure.n_decoys);
  return figure;
}

}  // namespace

Json decoys_json(std::span<const DecoyFigure> decoys) {
  Json rows = Json::array();
  for (const DecoyFigure& d : decoys) {
    rows.push_back({{"kind", name(d.kind)},
                    {"distance_m", d.distance_m},
                    {"n_lines", d.n_lines},
                    {"n_decoys", d.n_decoys},
                    {"n_passed", d.n_passed},
                    {"n_withheld", d.n_withheld},
                    {"share", number_json(d.share())},
                    {"ci95", interval_json(d.ci95)},
                    {"withheld_share", number_json(d.withheld_share())},
                    {"n_clusters", d.n_clusters}});
  }
  return rows;
}

std::vector<DecoyFigure> parse_decoys(const Json& json) {
  check(json.is_array(), "decoys: ", json.type_name(), "; must be a list");
  std::vector<DecoyFigure> decoys;
  for (const Json& row : json) {
    decoys.push_back(read_or_throw("decoys", [&] { return parse_figure(row); }));
  }
  return decoys;
}

Json following_json(const std::optional<CloudFollowing>& following) {
  if (!following) return nullptr;
  return {{"n_pairs", following->n_pairs},
          {"n_clusters", following->n_clusters},
          {"share", following->share},
          {"share_elsewhere", following->share_elsewhere},
          {"difference", following->difference()},
          {"ci95", interval_json(following->ci95)}};
}

std::optional<CloudFollowing> parse_following(const Json& json) {
  if (json.is_null()) return std::nullopt;
  return read_or_throw("elsewhere", [&] {
    CloudFollowing following;
    following.n_pairs = json.at("n_pairs").get<std::size_t>();
    following.n_clusters = json.at("n_clusters").get<std::size_t>();
    following.share = json.at("share").get<double>();
    following.share_elsewhere = json.at("share_elsewhere").get<double>();
    following.ci95 = interval_of(json.at("ci95"));
    return std::optional(following);
  });
}

}  // namespace ridgeline::evaluate
