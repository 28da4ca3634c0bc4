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

/// Finds the step that coordinates of one axis were rounded to: by float32 (a power of 2, 0.5 m at
/// the northings of UTM) or by too few decimals or digits (1, 5, 10 or so times a power of 10).
/// Values of a fine grid nearly always rule out a step within the first few, so the rest cost
/// nothing.
class AxisSteps {
 public:
  /// Steps of up to `tolerable`, file units, are not looked for.
  explicit AxisSteps(double tolerable = kMaxCoordinateStep_m);

  void add(double value) {
    if (may_have_step()) add_to_lattices(value);
  }
  void merge(const AxisSteps& other);

  /// Whether the values so far share a step.
  [[nodiscard]] bool may_have_step() const { return binary_.is_alive || decimal_.is_alive; }

  /// The largest step that all values are multiples of, file units. Nothing if there is none above
  /// the tolerable one, or if the values are so few that they may share it by chance or by design
  /// (two eaves of 3 and 6 m).
  [[nodiscard]] std::optional<double> step() const;

  /// Whether step() is a power of 2 that no decimal number explains: only float32 rounds so.
  [[nodiscard]] bool has_binary_step() const { return step() && !decimal_.is_alive; }

  /// The step of float32 at the largest of the values, file units; 0 once the values cannot share a
  /// step.
  [[nodiscard]] double float32_step() const;

 private:
  /// Whether all values are multiples of `base`, up to the millimetres that a text keeps of them.
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

  /// Values that are not finite are passed over.
  void add(const Eigen::Vector3d& x_in_file);
  void merge(const CoordinateSteps& other);
  [[nodiscard]] bool may_have_steps() const;

  /// Steps by axis, metres; 0 where no step is found. If one axis shows float32, all axes have the
  /// steps of float32.
  [[nodiscard]] Eigen::Vector3d steps_m() const;

  [[nodiscard]] bool went_through_float32() const;

 private:
  Eigen::Vector3d unit_m_;
  double tolerable_m_;
  std::array<AxisSteps, 3> axes_;
};

/// The steps that are not 0, the largest first: "y in steps of 10 m, x in steps of 1 m".
std::string steps_text(const Eigen::Vector3d& steps_m);

}  // namespace ridgeline::io
