// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ridgeline::io {

/// Coarsest tolerable step of coordinates: a quarter of the 0.1 m plane tolerance.
inline constexpr double kMaxCoordinateStep_m = 0.025;

/// Finds the step to which the coordinates of one axis were rounded: by float32 (a power of 2, 0.5
/// m at UTM northings) or by too few decimals or digits (1, 5, 10 or so times a power of 10). With
/// finely resolved values, the first few nearly always rule out a step, so the rest cost nothing.
class AxisSteps {
 public:
  /// Steps of up to `tolerable` (file units) are not searched for.
  explicit AxisSteps(double tolerable = kMaxCoordinateStep_m);

  void add(double value) {
    if (may_have_step()) add_to_lattices(value);
  }
  void merge(const AxisSteps& other);

  /// Whether the values so far share a step.
  [[nodiscard]] bool may_have_step() const { return binary_.is_alive || decimal_.is_alive; }

  /// The largest step of which all values are multiples, file units. std::nullopt if there is none
  /// above the tolerable one, or if there are so few values that they may share it by chance or by
  /// design (two eaves at 3 and 6 m).
  [[nodiscard]] std::optional<double> step() const;

  /// Whether step() is a power of 2 that no decimal step explains: only float32 rounds in this way.
  [[nodiscard]] bool has_binary_step() const { return step() && !decimal_.is_alive; }

  /// The step of float32 at the largest of the values, file units; 0 once the values cannot share a
  /// step.
  [[nodiscard]] double float32_step() const;

 private:
  /// Tests whether all values are multiples of `base`, apart from rounding to millimetres in a text
  /// file.
  struct Lattice {
    double base = 0.0;
    bool is_alive = true;
    std::int64_t divisor = 0;           ///< greatest common divisor of all multiples
    std::vector<std::int64_t> samples;  ///< the first different multiples

    void add(double value);
    void add_multiple(std::int64_t multiple);
    void merge(const Lattice& other);
    template <typename Next>
    [[nodiscard]] double largest_step(double limit, const Next& next) const;
  };

  void add_to_lattices(double value);

  Lattice binary_, decimal_;
  double largest_ = 0.0;  ///< largest magnitude of the values
};

/// The steps of all three axes of coordinates in file units.
class CoordinateSteps {
 public:
  CoordinateSteps() : CoordinateSteps(Eigen::Vector3d::Ones()) {}

  /// `unit_m`: metres per file unit by axis.
  explicit CoordinateSteps(const Eigen::Vector3d& unit_m,
                           double tolerable_m = kMaxCoordinateStep_m);

  /// Non-finite values are ignored.
  void add(const Eigen::Vector3d& x_in_file);
  void merge(const CoordinateSteps& other);
  [[nodiscard]] bool may_have_steps() const;

  /// Steps by axis, metres; 0 where no step is found. If one axis shows float32 rounding, the
  /// float32 steps are given for all axes.
  [[nodiscard]] Eigen::Vector3d steps_m() const;

  [[nodiscard]] bool went_through_float32() const;

 private:
  Eigen::Vector3d unit_m_;
  double tolerable_m_;
  std::array<AxisSteps, 3> axes_;
};

/// The non-zero steps, the largest first: "y in steps of 10 m, x in steps of 1 m".
std::string steps_text(const Eigen::Vector3d& steps_m);

}  // namespace ridgeline::io
