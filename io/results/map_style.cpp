// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/map_style.h"

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

/// Colour and label of the lines up to a distance. The report has the same steps (colours.ts).
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
constexpr std::uint32_t kPlane = 0xb9b1a7;
constexpr std::uint32_t kVector = 0x23262b;

using Properties = std::vector<std::pair<std::string, std::string>>;

std::string rgba(std::uint32_t colour, int alpha = 255) {
  return fmt::format("{},{},{},{}", colour >> 16U, (colour >> 8U) & 0xffU, colour & 0xffU, alpha);
}

/// A symbol of one layer. QGIS reads `Option` from 3.18 on, `prop` before.
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

std::string qml_of_one(const std::string& symbol) {
  return qml("<renderer-v2 type=\"singleSymbol\" symbollevels=\"0\" forceraster=\"0\"><symbols>\n" +
             symbol + "</symbols></renderer-v2>\n");
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

}  // namespace

io::MapStyle lines_style() { return {"distance from LIDAR", qml_by_distance(), sld_by_distance()}; }

io::MapStyle planes_style() {
  const std::string symbol = qml_symbol(0, "fill", "SimpleFill",
                                        {{"color", rgba(kPlane, 70)},
                                         {"style", "solid"},
                                         {"outline_color", rgba(kPlane)},
                                         {"outline_style", "solid"},
                                         {"outline_width", "0.2"},
                                         {"outline_width_unit", "MM"}});
  const std::string rule = fmt::format(
      "<Rule><PolygonSymbolizer><Fill><CssParameter name=\"fill\">{}</CssParameter><CssParameter "
      "name=\"fill-opacity\">0.27</CssParameter></Fill>{}</PolygonSymbolizer></Rule>\n",
      hex(kPlane), sld_stroke(kPlane, 0.7));
  return {"LIDAR planes", qml_of_one(symbol), sld("planes", rule)};
}

io::MapStyle verdict_style(const std::string& name) {
  struct Group {
    const char *label, *qml_filter, *sld_filter;
    std::uint32_t colour;
  };
  constexpr std::array kGroups{
      Group{"right", "&quot;verdict&quot; = 'right'",
            "<ogc:Filter><ogc:PropertyIsEqualTo><ogc:PropertyName>verdict</ogc:PropertyName>"
            "<ogc:Literal>right</ogc:Literal></ogc:PropertyIsEqualTo></ogc:Filter>",
            kSteps[0].colour},
      Group{"not judged", "&quot;verdict&quot; IS NULL OR &quot;verdict&quot; = 'not judged'",
            "<ogc:Filter><ogc:Or><ogc:PropertyIsNull><ogc:PropertyName>verdict</ogc:PropertyName>"
            "</ogc:PropertyIsNull><ogc:PropertyIsEqualTo><ogc:PropertyName>verdict"
            "</ogc:PropertyName><ogc:Literal>not judged</ogc:Literal></ogc:PropertyIsEqualTo>"
            "</ogc:Or></ogc:Filter>",
            kNotJudged},
      Group{"wrong (see verdict)", "ELSE", "<ElseFilter/>", kSteps[4].colour}};
  std::string rules, symbols, sld_rules;
  for (std::size_t i = 0; i < kGroups.size(); ++i) {
    const Group& group = kGroups[i];
    rules += fmt::format("<rule key=\"{{group{}}}\" symbol=\"{}\" label=\"{}\" filter=\"{}\"/>\n",
                         i, i, group.label, group.qml_filter);
    symbols += qml_symbol(static_cast<int>(i), "fill", "SimpleFill",
                          {{"color", rgba(group.colour, 120)},
                           {"style", "solid"},
                           {"outline_color", rgba(group.colour)},
                           {"outline_style", "solid"},
                           {"outline_width", "0.2"},
                           {"outline_width_unit", "MM"}});
    sld_rules += fmt::format(
        "<Rule><Name>{}</Name>{}<PolygonSymbolizer><Fill><CssParameter name=\"fill\">{}"
        "</CssParameter><CssParameter name=\"fill-opacity\">0.47</CssParameter></Fill>{}"
        "</PolygonSymbolizer></Rule>\n",
        group.label, group.sld_filter, hex(group.colour), sld_stroke(group.colour, 0.7));
  }
  return {"verdict", qml_by_rules(rules, symbols), sld(name, sld_rules)};
}

io::MapStyle vectors_style() {
  return {"line to plane", qml_of_one(qml_line(0, kVector, 0.3)),
          sld("vectors", sld_line_rule("line to plane", "", kVector, 1.0))};
}

}  // namespace ridgeline::results
