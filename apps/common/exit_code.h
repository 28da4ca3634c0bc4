// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ridgeline::apps {

enum ExitCode : int {
  kDone = 0,
  kWrongInput = 1,  ///< the user's files, options or usage are at fault
  kInternalError = 2,
  kGateFailed = 3,
};

}  // namespace ridgeline::apps
