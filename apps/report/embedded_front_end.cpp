// SPDX-License-Identifier: BSD-3-Clause
#include "apps/report/page.h"

// The assembler puts the committed bundle into the program as it is; no compiler reads it.
asm(R"(
.section .rodata
.global kRidgelineFrontEndScriptBegin, kRidgelineFrontEndScriptEnd
.global kRidgelineFrontEndStyleBegin, kRidgelineFrontEndStyleEnd
kRidgelineFrontEndScriptBegin:
.incbin ")" RIDGELINE_FRONT_END R"(/report.js"
kRidgelineFrontEndScriptEnd:
kRidgelineFrontEndStyleBegin:
.incbin ")" RIDGELINE_FRONT_END R"(/report.css"
kRidgelineFrontEndStyleEnd:
.text
)");

extern "C" {
extern const char kRidgelineFrontEndScriptBegin[];
extern const char kRidgelineFrontEndScriptEnd[];
extern const char kRidgelineFrontEndStyleBegin[];
extern const char kRidgelineFrontEndStyleEnd[];
}

namespace ridgeline::apps {

std::string_view front_end_script() {
  return {kRidgelineFrontEndScriptBegin, kRidgelineFrontEndScriptEnd};
}

std::string_view front_end_style() {
  return {kRidgelineFrontEndStyleBegin, kRidgelineFrontEndStyleEnd};
}

}  // namespace ridgeline::apps
