// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace ridgeline::other {

/// A number in [0, 1) for each cell of a grid.
double cell_noise(std::int64_t column, std::int64_t row, std::uint64_t seed);

/// Value noise in [0, 1]: cell_noise() at the knots of a grid of unit size, smoothly interpolated.
double value_noise(double x, double y, std::uint64_t seed);

/// Sum of `octaves` of value noise, each of half the size and half the weight of the one before;
/// mean 0, within (-1, 1).
double fractal_noise(double x, double y, int octaves, std::uint64_t seed);

}  // namespace ridgeline::other
