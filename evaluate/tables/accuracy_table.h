// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/accuracy.h"
#include "evaluate/statistics/strata.h"

#include <span>
#include <string>

namespace ridgeline::evaluate {

/// The three labelled accuracy figures per class, the flags in words, and the figures in the style
/// of ASPRS Edition 2 and NSSDA below kFixedSentence.
std::string to_markdown(std::span<const AccuracyStatement> statements);

/// One table per stratification: n, RMS, interval, NMAD, 95 % quantile, and the calibration of the
/// predicted sigmas, if any.
std::string to_markdown(std::span<const Stratification> stratifications);

}  // namespace ridgeline::evaluate
