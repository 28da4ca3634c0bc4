// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/map_style.h"

#include "evaluate/faces/building_table.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ridgeline::results {
namespace {

/// Colour and label of the lines up to a distance. The report uses the same steps (colours.ts).
struct Step {
  double upto_m;
  std::uint32_t colour;
  std::string_view label;
};
constexpr std::array kSteps{Step{0.05, 0x0072b2, "up to 0.05 m"},
                            Step{0.1, 0x56b4e9, "up to 0.10 m"},
                            Step{0.3, 0x009e73, "up to 0.30 m"}, Step{1.0, 0xe69f00, "up to 1 m"},
                            Step{std::numeric_limits<double>::infinity(), 0xd55e00, "above 1 m"}};
constexpr std::uint32_t kNotJudged = 0x969696;
constexpr std::uint32_t kChanged = 0xcc79a7;
constexpr std::uint32_t kPlane = 0xb9b1a7;
constexpr std::uint32_t kVector = 0x23262b;

using Properties = std::vector<std::pair<std::string, std::string>>;

std::string rgba(std::uint32_t colour, int alpha = 255) {
  return fmt::format("{},{},{},{}", colour >> 16U, (colour >> 8U) & 0xffU, colour & 0xffU, alpha);
}

/// A symbol with a single layer. QGIS reads `Option` since version 3.18 and `prop` before.
std::string qml_symbol(int number,
                       std::string_view type,
                       std::string_view layer_class,
                       const Properties& properties) {
  std::string text = fmt::format(
      "<symbol name=\"{}\" type=\"{}\" alpha=\"1\" clip_to_extent=\"1\"><layer class=\"{}\" "
      "enabled=\"1\" "
      "pass=\"0\" locked=\"0\"><Option type=\"Map\">",
      number, type, layer_class);
  for (const auto& [name, value] : properties) {
    text += fmt::format("<Option name=\"{}\" type=\"QString\" value=\"{}\"/>", name, value);
  }
  text += "</Option>";
  for (const auto& [name, value] : properties) {
    text += fmt::format("<prop k=\"{}\" v=\"{}\"/>", name, value);
  }
  return text + "</layer></symbol>\n";
}

std::string qml_line(int number, std::uint32_t colour, double width_mm) {
  return qml_symbol(number, "line", "SimpleLine",
                    {{"line_color", rgba(colour)},
                     {"line_width", fmt::format("{}", width_mm)},
                     {"line_width_unit", "MM"},
                     {"line_style", "solid"},
                     {"capstyle", "round"},
                     {"joinstyle", "round"}});
}

std::string qml(std::string_view renderer) {
  return fmt::format(
      "<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n"
      "<qgis version=\"3.22.0\" styleCategories=\"Symbology\">\n{}</qgis>\n",
      renderer);
}

std::string qml_by_rules(const std::string& rules, const std::string& symbols) {
  return qml(fmt::format(
      "<renderer-v2 type=\"RuleRenderer\" symbollevels=\"0\" forceraster=\"0\">\n<rules "
      "key=\"{{root}}\">\n{}</rules>\n<symbols>\n{}</symbols></renderer-v2>\n",
      rules, symbols));
}

std::string qml_by_distance() {
  std::string rules;
  std::string symbols;
  double above_m = -1.0;
  for (std::size_t i = 0; i < kSteps.size(); ++i) {
    const Step& step = kSteps[i];
    std::string filter = fmt::format("&quot;mean_distance_m&quot; &gt; {}", above_m);
    if (i + 1 < kSteps.size()) {
      filter += fmt::format(" AND &quot;mean_distance_m&quot; &lt;= {}", step.upto_m);
    }
    rules += fmt::format("<rule key=\"{{step{}}}\" symbol=\"{}\" label=\"{}\" filter=\"{}\"/>\n", i,
                         i, step.label, filter);
    symbols += qml_line(static_cast<int>(i), step.colour, 0.8);
    above_m = step.upto_m;
  }
  const auto last = static_cast<int>(kSteps.size());
  rules += fmt::format(
      "<rule key=\"{{rest}}\" symbol=\"{}\" label=\"not judged (see status)\" filter=\"ELSE\"/>\n",
      last);
  symbols += qml_line(last, kNotJudged, 0.4);
  return qml_by_rules(rules, symbols);
}

std::string hex(std::uint32_t colour) { return fmt::format("#{:06x}", colour); }

std::string sld_stroke(std::uint32_t colour, double width_px) {
  return fmt::format(
      "<Stroke><CssParameter name=\"stroke\">{}</CssParameter><CssParameter "
      "name=\"stroke-width\">{}</CssParameter></Stroke>",
      hex(colour), width_px);
}

std::string sld_line_rule(std::string_view label,
                          const std::string& filter,
                          std::uint32_t colour,
                          double width_px) {
  return fmt::format("<Rule><Name>{}</Name>{}<LineSymbolizer>{}</LineSymbolizer></Rule>\n", label,
                     filter, sld_stroke(colour, width_px));
}

std::string sld(std::string_view layer, const std::string& rules) {
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<StyledLayerDescriptor version=\"1.0.0\" "
      "xmlns=\"http://www.opengis.net/sld\" "
      "xmlns:ogc=\"http://www.opengis.net/ogc\"><NamedLayer><Name>{}</Name>"
      "<UserStyle><FeatureTypeStyle>\n{}</FeatureTypeStyle></UserStyle></NamedLayer></"
      "StyledLayerDescriptor>\n",
      layer, rules);
}

std::string sld_compare(std::string_view comparison, double value) {
  return fmt::format(
      "<ogc:{0}><ogc:PropertyName>mean_distance_m</ogc:PropertyName><ogc:Literal>{1}</"
      "ogc:Literal></ogc:{0}>",
      comparison, value);
}

std::string sld_by_distance() {
  std::string rules;
  double above_m = -1.0;
  for (std::size_t i = 0; i < kSteps.size(); ++i) {
    const Step& step = kSteps[i];
    const std::string above = sld_compare("PropertyIsGreaterThan", above_m);
    const std::string filter = i + 1 == kSteps.size()
                                   ? above
                                   : "<ogc:And>" + above +
                                         sld_compare("PropertyIsLessThanOrEqualTo", step.upto_m) +
                                         "</ogc:And>";
    rules += sld_line_rule(step.label, "<ogc:Filter>" + filter + "</ogc:Filter>", step.colour, 2.5);
    above_m = step.upto_m;
  }
  rules += sld_line_rule("not judged (see status)", "<ElseFilter/>", kNotJudged, 1.0);
  return sld("lines", rules);
}

/// How a rule selects features by their `verdict`.
enum class Match : std::uint8_t { kAll, kEquals, kHas, kNull };

/// Areas of one style. Rules may share features, because a face may be wrong in several ways; the
/// styles are then superimposed.
struct AreaRule {
  std::string label;
  Match match = Match::kAll;
  std::string value = {};
  std::uint32_t colour = 0;
  const char* fill = "no";  ///< of QGIS: no, solid, f_diagonal
  const char* stroke = "solid";
  double width_mm = 0.2;
};

std::string qml_filter_of(const AreaRule& rule) {
  switch (rule.match) {
    case Match::kAll:
      return "";
    case Match::kEquals:
      return fmt::format("&quot;verdict&quot; = '{}'", rule.value);
    case Match::kHas:
      return fmt::format("&quot;verdict&quot; LIKE '%{}%'", rule.value);
    default:
      return "&quot;verdict&quot; IS NULL";
  }
}

std::string sld_filter_of(const AreaRule& rule) {
  constexpr const char* kName = "<ogc:PropertyName>verdict</ogc:PropertyName>";
  switch (rule.match) {
    case Match::kAll:
      return "";
    case Match::kEquals:
      return fmt::format(
          "<ogc:Filter><ogc:PropertyIsEqualTo>{}<ogc:Literal>{}</ogc:Literal>"
          "</ogc:PropertyIsEqualTo></ogc:Filter>",
          kName, rule.value);
    case Match::kHas:
      return fmt::format(
          "<ogc:Filter><ogc:PropertyIsLike wildCard=\"*\" singleChar=\".\" escape=\"!\">{}"
          "<ogc:Literal>*{}*</ogc:Literal></ogc:PropertyIsLike></ogc:Filter>",
          kName, rule.value);
    default:
      return fmt::format("<ogc:Filter><ogc:PropertyIsNull>{}</ogc:PropertyIsNull></ogc:Filter>",
                         kName);
  }
}

constexpr int kFillAlpha = 70;  ///< what lies below a face shows through

std::string qml_of_areas(const std::vector<AreaRule>& areas) {
  std::string rules, symbols;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const AreaRule& area = areas[i];
    rules += fmt::format("<rule key=\"{{area{}}}\" symbol=\"{}\" label=\"{}\" filter=\"{}\"/>\n", i,
                         i, area.label, qml_filter_of(area));
    symbols += qml_symbol(static_cast<int>(i), "fill", "SimpleFill",
                          {{"color", rgba(area.colour, kFillAlpha)},
                           {"style", area.fill},
                           {"outline_color", rgba(area.colour)},
                           {"outline_style", area.stroke},
                           {"outline_width", fmt::format("{}", area.width_mm)},
                           {"outline_width_unit", "MM"}});
  }
  return qml_by_rules(rules, symbols);
}

/// SLD 1.0 has no hatches; a hatched area gets a lighter fill instead.
std::string sld_of_areas(std::string_view layer, const std::vector<AreaRule>& areas) {
  std::string rules;
  for (const AreaRule& area : areas) {
    const std::string_view fill = area.fill;
    const double opacity = fill == "solid" ? kFillAlpha / 255.0 : kFillAlpha / 510.0;
    const std::string filled =
        fill == "no" ? ""
                     : fmt::format(
                           "<Fill><CssParameter name=\"fill\">{}</CssParameter><CssParameter "
                           "name=\"fill-opacity\">{:.2f}</CssParameter></Fill>",
                           hex(area.colour), opacity);
    const std::string dash = std::string_view(area.stroke) == "solid"
                                 ? ""
                                 : "<CssParameter name=\"stroke-dasharray\">6 4</CssParameter>";
    rules += fmt::format(
        "<Rule><Name>{}</Name>{}<PolygonSymbolizer>{}<Stroke><CssParameter "
        "name=\"stroke\">{}</CssParameter><CssParameter "
        "name=\"stroke-width\">{:.2f}</CssParameter>{}"
        "</Stroke></PolygonSymbolizer></Rule>\n",
        area.label, sld_filter_of(area), filled, hex(area.colour), 3.5 * area.width_mm, dash);
  }
  return sld(layer, rules);
}

/// The outline of a building by its verdict: solid for errors in height, dashed for errors in plan.
struct BuildingStroke {
  evaluate::BuildingVerdict verdict;
  std::uint32_t colour;
  const char* stroke;
};
using evaluate::BuildingVerdict;

struct KindColour {
  const char* kind;
  std::uint32_t colour;
};
/// The page of the edges uses the same colours (kind_colours.ts).
constexpr std::array kKindColours{KindColour{"ridge", 0xd55e00},  KindColour{"hip", 0xe69f00},
                                  KindColour{"valley", 0x0072b2}, KindColour{"eave", 0x009e73},
                                  KindColour{"verge", 0x56b4e9},  KindColour{"step", 0xcc79a7}};

constexpr std::array kBuildingStrokes{
    BuildingStroke{BuildingVerdict::kRight, kSteps[0].colour, "solid"},
    BuildingStroke{BuildingVerdict::kShifted, kSteps[4].colour, "dash"},
    BuildingStroke{BuildingVerdict::kTooHigh, kSteps[4].colour, "solid"},
    BuildingStroke{BuildingVerdict::kTooLow, kSteps[4].colour, "solid"},
    BuildingStroke{BuildingVerdict::kWrongHeight, kSteps[3].colour, "solid"},
    BuildingStroke{BuildingVerdict::kWrongTilt, kSteps[3].colour, "dash dot"},
    BuildingStroke{BuildingVerdict::kWrongOutline, kSteps[3].colour, "dash"},
    BuildingStroke{BuildingVerdict::kChanged, kChanged, "solid"},
    BuildingStroke{BuildingVerdict::kGone, kChanged, "dash"},
    BuildingStroke{BuildingVerdict::kNotJudged, kNotJudged, "solid"}};
static_assert(kBuildingStrokes.size() == evaluate::kBuildingVerdicts.size());

}  // namespace

io::MapStyle lines_style() { return {"distance from LIDAR", qml_by_distance(), sld_by_distance()}; }

io::MapStyle planes_style() {
  const std::vector<AreaRule> rules{{.label = "LIDAR plane", .colour = kPlane, .fill = "solid"}};
  return {"LIDAR planes", qml_of_areas(rules), sld_of_areas("planes", rules)};
}

io::MapStyle buildings_style() {
  const std::vector<AreaRule> rules = transformed(kBuildingStrokes, [](const BuildingStroke& of) {
    const char* const verdict = evaluate::text(of.verdict);
    return AreaRule{.label = verdict,
                    .match = Match::kEquals,
                    .value = verdict,
                    .colour = of.colour,
                    .fill = "no",
                    .stroke = of.stroke,
                    .width_mm = 0.7};
  });
  return {"verdict", qml_of_areas(rules), sld_of_areas("buildings", rules)};
}

io::MapStyle faces_style() {
  const std::vector<AreaRule> rules{
      {"right", Match::kEquals, "right", kSteps[0].colour, "solid", "solid", 0.2},
      {"wrong height", Match::kHas, "height", kSteps[4].colour, "solid", "solid", 0.2},
      {"wrong tilt", Match::kHas, "tilt", kSteps[4].colour, "f_diagonal", "solid", 0.2},
      {"wrong outline", Match::kHas, "outline", kSteps[4].colour, "no", "dash", 0.7},
      {"not judged", Match::kNull, "", kNotJudged, "no", "solid", 0.2}};
  return {"verdict", qml_of_areas(rules), sld_of_areas("faces", rules)};
}

io::MapStyle to_fix_style() {
  struct Marker {
    const char *label, *qml_filter, *sld_filter;
    double size_mm;
  };
  constexpr std::array kMarks{
      Marker{
          "the first ten to fix", "&quot;rank&quot; &lt;= 10",
          "<ogc:Filter><ogc:PropertyIsLessThanOrEqualTo><ogc:PropertyName>rank</ogc:PropertyName>"
          "<ogc:Literal>10</ogc:Literal></ogc:PropertyIsLessThanOrEqualTo></ogc:Filter>",
          4.0},
      Marker{"to fix", "ELSE", "<ElseFilter/>", 2.0}};
  std::string rules, symbols, sld_rules;
  for (std::size_t i = 0; i < kMarks.size(); ++i) {
    const Marker& mark = kMarks[i];
    rules += fmt::format("<rule key=\"{{mark{}}}\" symbol=\"{}\" label=\"{}\" filter=\"{}\"/>\n", i,
                         i, mark.label, mark.qml_filter);
    symbols += qml_symbol(static_cast<int>(i), "marker", "SimpleMarker",
                          {{"name", "circle"},
                           {"color", rgba(kSteps[4].colour, 0)},
                           {"outline_color", rgba(kSteps[4].colour)},
                           {"outline_width", "0.6"},
                           {"outline_width_unit", "MM"},
                           {"size", fmt::format("{}", mark.size_mm)},
                           {"size_unit", "MM"}});
    sld_rules += fmt::format(
        "<Rule><Name>{}</Name>{}<PointSymbolizer><Graphic><Mark><WellKnownName>circle"
        "</WellKnownName>{}</Mark><Size>{}</Size></Graphic></PointSymbolizer></Rule>\n",
        mark.label, mark.sld_filter, sld_stroke(kSteps[4].colour, 2.0), 3.0 * mark.size_mm);
  }
  return {"to fix", qml_by_rules(rules, symbols), sld("to_fix", sld_rules)};
}

io::MapStyle missing_style() {
  return {"not found",
          qml_by_rules("<rule key=\"{all}\" symbol=\"0\" label=\"edge without a line\"/>\n",
                       qml_line(0, kChanged, 1.0)),
          sld("missing", sld_line_rule("edge without a line", "", kChanged, 3.0))};
}

io::MapStyle missing_roofs_style() {
  const std::vector<AreaRule> rules{
      {.label = "roof without a building", .colour = kChanged, .fill = "f_diagonal"}};
  return {"missing roofs", qml_of_areas(rules), sld_of_areas("missing_roofs", rules)};
}

io::MapStyle edge_kinds_style() {
  std::string rules, symbols, sld_rules;
  for (std::size_t i = 0; i < kKindColours.size(); ++i) {
    const auto& [kind, colour] = kKindColours[i];
    rules += fmt::format(
        "<rule key=\"{{kind{0}}}\" symbol=\"{0}\" label=\"{1}\" filter=\"&quot;kind&quot; = "
        "'{1}'\"/>\n",
        i, kind);
    symbols += qml_line(static_cast<int>(i), colour, 0.8);
    sld_rules += sld_line_rule(
        kind,
        fmt::format("<ogc:Filter><ogc:PropertyIsEqualTo><ogc:PropertyName>kind</ogc:PropertyName>"
                    "<ogc:Literal>{}</ogc:Literal></ogc:PropertyIsEqualTo></ogc:Filter>",
                    kind),
        colour, 2.5);
  }
  return {"kind", qml_by_rules(rules, symbols), sld("lines", sld_rules)};
}

io::MapStyle vectors_style() {
  return {"line to plane",
          qml_by_rules("<rule key=\"{all}\" symbol=\"0\" label=\"line to its plane\"/>\n",
                       qml_line(0, kVector, 0.3)),
          sld("vectors", sld_line_rule("line to plane", "", kVector, 1.0))};
}

}  // namespace ridgeline::results
