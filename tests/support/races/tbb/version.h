// SPDX-License-Identifier: BSD-3-Clause
#pragma once

inline const char* TBB_runtime_version() { return "threads of the standard library"; }
