// SPDX-License-Identifier: BSD-3-Clause
#include "io/crs/coordinate_steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ridgeline::io {
namespace {

constexpr double kRounding = 0.0006;  // file units; rounding of a float32 printed with 3 decimals
constexpr double kMaxValue = 1e12;    // multiples of any base fit in 64 bits
constexpr std::size_t kSamples = 16;

double smallest_power(double radix, double above) {
  double power = std::pow(radix, std::ceil(std::log(above) / std::log(radix)));
  if (!(power > above)) power *= radix;
  return power;
}

/// The smallest of the numbers 5 x 10^k and 10^k that is larger than `above`.
double smallest_decimal(double above) {
  const double power = smallest_power(10.0, above);
  return power / 2.0 > above ? power / 2.0 : power;
}

}  // namespace

AxisSteps::AxisSteps(double tolerable) {
  binary_.base = smallest_power(2.0, tolerable);
  decimal_.base = smallest_decimal(tolerable);
}

void AxisSteps::Lattice::add(double value) {
  if (!is_alive) return;
  const double multiple = std::round(value / base);
  is_alive = std::abs(value - multiple * base) <= kRounding && std::abs(value) < kMaxValue;
  if (is_alive) add_multiple(static_cast<std::int64_t>(multiple));
}

void AxisSteps::Lattice::add_multiple(std::int64_t multiple) {
  if (divisor != 1) divisor = std::gcd(divisor, multiple);
  if (samples.size() < kSamples && std::ranges::find(samples, multiple) == samples.end()) {
    samples.push_back(multiple);
  }
}

void AxisSteps::Lattice::merge(const Lattice& other) {
  is_alive = is_alive && other.is_alive;
  if (!is_alive) return;
  divisor = std::gcd(divisor, other.divisor);
  for (const std::int64_t multiple : other.samples) add_multiple(multiple);
}

void AxisSteps::add_to_lattices(double value) {
  largest_ = std::max(largest_, std::abs(value));
  binary_.add(value);
  decimal_.add(value);
}

void AxisSteps::merge(const AxisSteps& other) {
  binary_.merge(other.binary_);
  decimal_.merge(other.decimal_);
  largest_ = std::max(largest_, other.largest_);
}

/// The largest step up to `limit` shared by all values; 0 if there is none. `next` returns the next
/// larger step.
template <typename Next>
double AxisSteps::Lattice::largest_step(double limit, const Next& next) const {
  if (!is_alive || divisor == 0) return 0.0;
  double step = base;
  for (double larger = next(step); larger <= limit && divisor % std::llround(larger / base) == 0;
       larger = next(larger)) {
    step = larger;
  }
  return step;
}

std::optional<double> AxisSteps::step() const {
  // A step is accepted if values on a grid of 0.01 would share it by chance only once in 100,000
  // cases.
  const double fine_grid = decimal_.is_alive ? 0.01 : 2.0 * kRounding;
  constexpr double kMinDigits = 5.0;
  // Larger powers of 2 are integers, which the decimal steps cover.
  constexpr double kMaxBinaryStep = 0.5;
  const double step =
      std::max(binary_.largest_step(kMaxBinaryStep, [](double s) { return 2.0 * s; }),
               decimal_.largest_step(kMaxValue, smallest_decimal));
  const std::size_t n_values = std::max(binary_.is_alive ? binary_.samples.size() : 0,
                                        decimal_.is_alive ? decimal_.samples.size() : 0);
  const double digits = static_cast<double>(n_values) * std::log10(step / fine_grid);
  if (n_values < 2 || !(digits >= kMinDigits)) return std::nullopt;
  return step;
}

double AxisSteps::float32_step() const {
  constexpr int kDigits = 24;
  if (!may_have_step() || largest_ == 0.0) return 0.0;
  int exponent = 0;
  (void)std::frexp(largest_, &exponent);
  return std::ldexp(1.0, exponent - kDigits);
}

CoordinateSteps::CoordinateSteps(const Eigen::Vector3d& unit_m, double tolerable_m)
    : unit_m_(unit_m),
      tolerable_m_(tolerable_m),
      axes_{AxisSteps(tolerable_m / unit_m.x()), AxisSteps(tolerable_m / unit_m.y()),
            AxisSteps(tolerable_m / unit_m.z())} {}

void CoordinateSteps::add(const Eigen::Vector3d& x_in_file) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double value = x_in_file[static_cast<Eigen::Index>(axis)];
    if (std::isfinite(value)) axes_[axis].add(value);
  }
}

void CoordinateSteps::merge(const CoordinateSteps& other) {
  for (std::size_t axis = 0; axis < 3; ++axis) axes_[axis].merge(other.axes_[axis]);
}

bool CoordinateSteps::may_have_steps() const {
  return std::ranges::any_of(axes_, &AxisSteps::may_have_step);
}

bool CoordinateSteps::went_through_float32() const {
  return std::ranges::any_of(axes_, &AxisSteps::has_binary_step);
}

Eigen::Vector3d CoordinateSteps::steps_m() const {
  const bool is_float32 = went_through_float32();
  Eigen::Vector3d steps_m;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    const double step = is_float32 ? axes_[axis].float32_step() : axes_[axis].step().value_or(0.0);
    steps_m[i] = step * unit_m_[i] > tolerable_m_ ? step * unit_m_[i] : 0.0;
  }
  return steps_m;
}

std::string steps_text(const Eigen::Vector3d& steps_m) {
  std::array<int, 3> axes{0, 1, 2};
  std::ranges::stable_sort(axes, [&](int a, int b) { return steps_m[a] > steps_m[b]; });
  std::string text;
  for (const int axis : axes) {
    if (!(steps_m[axis] > 0.0)) continue;
    text += fmt::format("{}{} in steps of {:.3g} m", text.empty() ? "" : ", ", "xyz"[axis],
                        steps_m[axis]);
  }
  return text;
}

}  // namespace ridgeline::io
