// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/tables/standards_table.h"

#include "evaluate/tables/format.h"
#include "evaluate/tables/text_table.h"

#include <fmt/format.h>

#include <string_view>

namespace ridgeline::evaluate {
namespace {

std::string value_text(const IsoMeasure& m, std::string_view missing) {
  return m.unit == "count" ? fixed(m.value, 0, missing) : fixed(m.value, 4, missing);
}

std::string asprs_flags(const AsprsFigures& figures) {
  std::string text;
  if (figures.few_checkpoints) text += "fewer than 30";
  if (figures.biased) text += text.empty() ? "bias" : ", bias";
  return text.empty() ? std::string(kNoValue) : text;
}

std::string asprs_markdown(const std::vector<StandardsBlock>& blocks) {
  PrintedTable table({"class", "n:", "RMSE_H:", "RMSE_V:", "RMSE_3D:",
                      "best class supported by the reference:", "flags", "NSSDA H:", "NSSDA V:"});
  for (const StandardsBlock& b : blocks) {
    table.add(b.line_class, b.asprs.n, metres(b.asprs.rmse_horizontal_m),
              metres(b.asprs.rmse_vertical_m), metres(b.asprs.rmse_3d_m),
              metres(b.asprs.best_class_m), asprs_flags(b.asprs), metres(b.nssda.horizontal_m),
              metres(b.nssda.vertical_m));
  }
  return "**ASPRS Edition 2** (ridges and hips, including the error of the reference) and, "
         "separately, **NSSDA** at 95 %.\n\n" +
         table.text(Markup::kMarkdown);
}

std::string budget_markdown(const std::vector<StandardsBlock>& blocks) {
  PrintedTable table({"class", "laser, random:", "laser, systematic:", "plane fit:", "combined u:",
                      "expanded U = 2u:", "sampling of the RMS:"});
  for (const StandardsBlock& b : blocks) {
    table.add(b.line_class, metres(b.budget.laser_random_m), metres(b.budget.laser_systematic_m),
              metres(b.budget.plane_fit_m), metres(b.budget.combined_m()),
              metres(b.budget.expanded_m()), metres(b.budget.sampling_m));
  }
  return "**Uncertainty budget** (GUM) of the distance of one line, and of the RMS of the "
         "class.\n\n" +
         table.text(Markup::kMarkdown);
}

std::string measures_markdown(const StandardsBlock& block) {
  PrintedTable table({"id:", "measure", "value:", "unit", "n:"});
  for (const IsoMeasure& m : block.iso19157) {
    table.add(m.id, m.name, value_text(m, kNoValue), m.unit, m.n);
  }
  return "**ISO 19157** measures of class " + escape_markdown(block.line_class) + ".\n\n" +
         table.text(Markup::kMarkdown);
}

std::string_view element_of(int id) {
  if (id == 3) return "DQ_CompletenessCommission";
  return id == 7 ? "DQ_CompletenessOmission" : "DQ_AbsoluteExternalPositionalAccuracy";
}

std::string_view unit_of(const IsoMeasure& m) {
  return m.unit == "m" ? "http://www.opengis.net/def/uom/UCUM/0/m"
                       : "http://www.opengis.net/def/uom/UCUM/0/1";
}

std::string report_xml(const StandardsRow& row, const IsoMeasure& m) {
  return fmt::format(
      "  <gmd:report>\n    <gmd:{0}>\n"
      "      "
      "<gmd:nameOfMeasure><gco:CharacterString>{1}</gco:CharacterString></gmd:nameOfMeasure>\n"
      "      <gmd:measureIdentification><gmd:MD_Identifier><gmd:code><gco:CharacterString>ISO "
      "19157 measure "
      "{2}</gco:CharacterString></gmd:code></gmd:MD_Identifier></gmd:measureIdentification>\n"
      "      <gmd:evaluationMethodDescription><gco:CharacterString>patch {3}, method {4}, {5} "
      "items: distances of "
      "3D lines from planes of laser "
      "points</gco:CharacterString></gmd:evaluationMethodDescription>\n"
      "      <gmd:result><gmd:DQ_QuantitativeResult><gmd:valueUnit xlink:href=\"{6}\"/>"
      "<gmd:value><gco:Record>{7}</gco:Record></gmd:value></gmd:DQ_QuantitativeResult></"
      "gmd:result>\n"
      "    </gmd:{0}>\n  </gmd:report>\n",
      element_of(m.id), escape_xml(m.name), m.id, escape_xml(row.patch), escape_xml(row.method),
      m.n, unit_of(m), value_text(m, ""));
}

}  // namespace

std::string standards_to_markdown(const std::vector<StandardsBlock>& blocks) {
  if (blocks.empty()) return "";
  return "In terms of standards. Informative: no conformity is claimed.\n\n" +
         asprs_markdown(blocks) + "\n" + budget_markdown(blocks) + "\n" +
         measures_markdown(blocks.back());
}

std::string measures_to_csv(const std::vector<StandardsRow>& rows) {
  std::string text = "patch,method,class,iso19157_id,measure,value,unit,n\n";
  for (const StandardsRow& row : rows) {
    for (const StandardsBlock& block : row.blocks) {
      for (const IsoMeasure& m : block.iso19157) {
        text += fmt::format("{},{},{},{},{},{},{},{}\n", escape_csv(row.patch),
                            escape_csv(row.method), escape_csv(block.line_class), m.id,
                            escape_csv(m.name), value_text(m, ""), m.unit, m.n);
      }
    }
  }
  return text;
}

std::string measures_to_xml(const std::vector<StandardsRow>& rows) {
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<gmd:DQ_DataQuality xmlns:gmd=\"http://www.isotc211.org/2005/gmd\" "
      "xmlns:gco=\"http://www.isotc211.org/2005/gco\" "
      "xmlns:xlink=\"http://www.w3.org/1999/xlink\">\n"
      "  <gmd:scope><gmd:DQ_Scope><gmd:level><gmd:MD_ScopeCode "
      "codeList=\"http://www.isotc211.org/2005/resources/Codelist/gmxCodelists.xml#MD_ScopeCode\" "
      "codeListValue=\"dataset\">dataset</gmd:MD_ScopeCode></gmd:level></gmd:DQ_Scope></"
      "gmd:scope>\n";
  for (const StandardsRow& row : rows) {
    if (row.blocks.empty()) continue;
    for (const IsoMeasure& m : row.blocks.back().iso19157) {
      if (m.value) text += report_xml(row, m);
    }
  }
  return text + "</gmd:DQ_DataQuality>\n";
}

}  // namespace ridgeline::evaluate
