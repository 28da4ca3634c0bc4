// SPDX-License-Identifier: BSD-3-Clause
#include "apps/report/page.h"

// The assembler puts the committed bundle into the program as it is; no compiler reads it.
asm(R"(
.section .rodata
.global ridgeline_front_end_script_begin, ridgeline_front_end_script_end
.global ridgeline_front_end_style_begin, ridgeline_front_end_style_end
ridgeline_front_end_script_begin:
.incbin ")" RIDGELINE_FRONT_END R"(/report.js"
ridgeline_front_end_script_end:
ridgeline_front_end_style_begin:
.incbin ")" RIDGELINE_FRONT_END R"(/report.css"
ridgeline_front_end_style_end:
.text
)");

extern "C" {
extern const char ridgeline_front_end_script_begin[];
extern const char ridgeline_front_end_script_end[];
extern const char ridgeline_front_end_style_begin[];
extern const char ridgeline_front_end_style_end[];
}

namespace ridgeline::apps {

std::string_view front_end_script() {
  return {ridgeline_front_end_script_begin, ridgeline_front_end_script_end};
}

std::string_view front_end_style() {
  return {ridgeline_front_end_style_begin, ridgeline_front_end_style_end};
}

}  // namespace ridgeline::apps
