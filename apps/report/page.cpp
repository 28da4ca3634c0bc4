// SPDX-License-Identifier: BSD-3-Clause
#include "apps/report/page.h"

#include "evaluate/tables/format.h"

#include <fmt/core.h>

namespace ridgeline::apps {

std::string script_safe(std::string_view json) {
  std::string text;
  text.reserve(json.size() + json.size() / 64);
  for (const char c : json) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

std::string report_page(std::string_view title,
                        std::string_view data,
                        const FrontEnd& front_end,
                        std::string_view elsewhere) {
  std::string page = fmt::format(R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta name="generator" content="ridgeline">
<link rel="icon" href="data:,">
<title>{}</title>
<style>)",
                                 evaluate::escape_xml(title));
  page += front_end.style;
  page +=
      "</style>\n</head>\n<body>\n<noscript>This report needs JavaScript, which is included in the "
      "file; please allow it. ";
  page += elsewhere;
  page +=
      "</noscript>\n<div id=\"app\"></div>\n<script type=\"application/json\" "
      "id=\"report-data\">";
  page += script_safe(data);
  page += "</script>\n<script>";
  page += front_end.script;
  page += "</script>\n</body>\n</html>\n";
  return page;
}

}  // namespace ridgeline::apps
