// SPDX-License-Identifier: BSD-3-Clause
#include "apps/report/page.h"

// The assembler embeds the committed bundle in the program unchanged; no compiler parses it.
asm(R"(
.section .rodata
.global kRidgelineFrontEndScriptBegin, kRidgelineFrontEndScriptEnd
.global kRidgelineFrontEndStyleBegin, kRidgelineFrontEndStyleEnd
.global kRidgelineBlockScriptBegin, kRidgelineBlockScriptEnd
.global kRidgelineBlockStyleBegin, kRidgelineBlockStyleEnd
.global kRidgelineEdgesScriptBegin, kRidgelineEdgesScriptEnd
.global kRidgelineEdgesStyleBegin, kRidgelineEdgesStyleEnd
kRidgelineFrontEndScriptBegin:
.incbin ")" RIDGELINE_FRONT_END R"(/report.js"
kRidgelineFrontEndScriptEnd:
kRidgelineFrontEndStyleBegin:
.incbin ")" RIDGELINE_FRONT_END R"(/report.css"
kRidgelineFrontEndStyleEnd:
kRidgelineBlockScriptBegin:
.incbin ")" RIDGELINE_FRONT_END R"(/block.js"
kRidgelineBlockScriptEnd:
kRidgelineBlockStyleBegin:
.incbin ")" RIDGELINE_FRONT_END R"(/block.css"
kRidgelineBlockStyleEnd:
kRidgelineEdgesScriptBegin:
.incbin ")" RIDGELINE_FRONT_END R"(/edges.js"
kRidgelineEdgesScriptEnd:
kRidgelineEdgesStyleBegin:
.incbin ")" RIDGELINE_FRONT_END R"(/edges.css"
kRidgelineEdgesStyleEnd:
.text
)");

extern "C" {
extern const char kRidgelineFrontEndScriptBegin[];
extern const char kRidgelineFrontEndScriptEnd[];
extern const char kRidgelineFrontEndStyleBegin[];
extern const char kRidgelineFrontEndStyleEnd[];
extern const char kRidgelineBlockScriptBegin[];
extern const char kRidgelineBlockScriptEnd[];
extern const char kRidgelineBlockStyleBegin[];
extern const char kRidgelineBlockStyleEnd[];
extern const char kRidgelineEdgesScriptBegin[];
extern const char kRidgelineEdgesScriptEnd[];
extern const char kRidgelineEdgesStyleBegin[];
extern const char kRidgelineEdgesStyleEnd[];
}

namespace ridgeline::apps {

FrontEnd run_front_end() {
  return {{kRidgelineFrontEndScriptBegin, kRidgelineFrontEndScriptEnd},
          {kRidgelineFrontEndStyleBegin, kRidgelineFrontEndStyleEnd}};
}

FrontEnd block_front_end() {
  return {{kRidgelineBlockScriptBegin, kRidgelineBlockScriptEnd},
          {kRidgelineBlockStyleBegin, kRidgelineBlockStyleEnd}};
}

FrontEnd edges_front_end() {
  return {{kRidgelineEdgesScriptBegin, kRidgelineEdgesScriptEnd},
          {kRidgelineEdgesStyleBegin, kRidgelineEdgesStyleEnd}};
}

}  // namespace ridgeline::apps
