// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/beyond/close_edges/close_edges.h"

#include "reconstruct/appearance/image_sampler.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ridgeline::reconstruct {
namespace {

double bell_density(double z) { return std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi); }

/// The parameters of two blurred steps with tilts: x_1, tilt_1, x_2, tilt_2, then c_0, c_1, c_2 of
/// each band.
class TwoSteps {
 public:
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 4 + 3 * kMaxBands, 1>;
  using Matrix = Eigen::
      Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 4 + 3 * kMaxBands, 4 + 3 * kMaxBands>;

  TwoSteps(double first_px, double second_px, int n_bands, double blur_px)
      : parameters_(Vector::Zero(4 + 3 * n_bands)), n_bands_(n_bands), blur_px_(blur_px) {
    parameters_[0] = first_px;
    parameters_[2] = second_px;
  }

  /// One iteration of least squares. The colours enter linearly, so the first iteration finds them
  /// for the given offsets.
  bool improve(std::span<const ProfileSample> samples, bool colours_only) {
    const Eigen::Index n = parameters_.size();
    Matrix normal = Matrix::Zero(n, n);
    Vector right = Vector::Zero(n);
    for (const ProfileSample& s : samples) add(s, colours_only, normal, right);
    // This keeps offsets and tilts unchanged if they are held fixed or not determined by the
    // samples.
    normal.diagonal().array() += 1e-9 * static_cast<double>(samples.size());
    const Eigen::LDLT<Matrix> solver(normal);
    if (solver.info() != Eigen::Success) return false;
    const Vector change = solver.solve(right);
    if (!change.allFinite()) return false;
    parameters_ += change;
    return true;
  }

  [[nodiscard]] ProfileStep step(Eigen::Index which) const {
    double squares = 0.0;
    for (int band = 0; band < n_bands_; ++band) {
      const double c = parameters_[4 + 3 * band + 1 + which];
      squares += c * c;
    }
    return {parameters_[2 * which], parameters_[2 * which + 1], std::sqrt(squares)};
  }

  /// Whether the second step reverses the colour change of the first one, summed over the bands.
  [[nodiscard]] bool turns_back() const {
    double product = 0.0;
    for (int band = 0; band < n_bands_; ++band) {
      product += parameters_[4 + 3 * band + 1] * parameters_[4 + 3 * band + 2];
    }
    return product < 0.0;
  }

 private:
  void add(const ProfileSample& s, bool colours_only, Matrix& normal, Vector& right) const {
    std::array<double, 2> response{}, slope{};
    for (std::size_t i = 0; i < 2; ++i) {
      const auto offset = static_cast<Eigen::Index>(2 * i);
      const double z =
          (s.across - parameters_[offset] - parameters_[offset + 1] * s.tau) / blur_px_;
      response[i] = step_response(z);
      slope[i] = colours_only ? 0.0 : -bell_density(z) / blur_px_;
    }
    for (int band = 0; band < n_bands_; ++band) {
      const Eigen::Index at = 4 + 3 * band;
      const Eigen::Vector3d c = parameters_.segment<3>(at);
      Eigen::Matrix<double, 7, 1> row;
      row << c[1] * slope[0], c[1] * slope[0] * s.tau, c[2] * slope[1], c[2] * slope[1] * s.tau,
          1.0, response[0], response[1];
      const double misclosure = s.colour[band] - c[0] - c[1] * response[0] - c[2] * response[1];
      const std::array<Eigen::Index, 7> unknowns{0, 1, 2, 3, at, at + 1, at + 2};
      normal(unknowns, unknowns) += row * row.transpose();
      right(unknowns) += row * misclosure;
    }
  }

  Vector parameters_;
  int n_bands_;
  double blur_px_;
};

/// The two offsets that best describe the profile, if they are clearly better than a single one.
std::optional<std::array<double, 2>> two_offsets(const StepBasis& basis,
                                                 const BinnedProfile& profile) {
  // Residual sum of squares of two steps divided by that of one step.
  constexpr double kMaxRatio = 0.5;
  constexpr Eigen::Index kMinSeparation = 5;  // bins
  constexpr Eigen::Index kMaxSeparation = 30;
  const StepEquations equations(basis, profile);
  const Eigen::Index n = basis.offsets_px.size();
  double best = 0.0;
  std::array<Eigen::Index, 2> at{};
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = i + kMinSeparation; j < std::min(n, i + kMaxSeparation + 1); ++j) {
      const double gain = equations.gain(i, j);
      if (gain <= best) continue;
      best = gain;
      at = {i, j};
    }
  }
  if (at[0] == 0 || at[1] == n - 1) return std::nullopt;  // the profile has an edge farther away
  if (profile.squares - best > kMaxRatio * (profile.squares - best_gain(basis, profile))) {
    return std::nullopt;
  }
  return std::array{basis.offsets_px[at[0]], basis.offsets_px[at[1]]};
}

/// Whether the least squares solution is close to its initial values and has two edges that do not
/// cross.
bool is_sound(const std::array<ProfileStep, 2>& steps, const std::array<double, 2>& begin) {
  constexpr double kMaxMove_px = 0.7;
  constexpr double kMinWidth_px = 0.4;
  constexpr double kCrossing_px = -0.3;  // a strip may taper to a point
  constexpr double kMaxTilt_px = 1.5;
  constexpr double kMinStrengthRatio = 0.25;  // weaker step divided by the stronger one
  for (std::size_t i = 0; i < 2; ++i) {
    if (std::abs(steps[i].offset_px - begin[i]) > kMaxMove_px) return false;
    if (std::abs(steps[i].tilt_px) > kMaxTilt_px) return false;
  }
  const double width = steps[1].offset_px - steps[0].offset_px;
  const double narrowing = std::abs(steps[1].tilt_px - steps[0].tilt_px);
  const auto [weak, strong] = std::minmax(steps[0].height, steps[1].height);
  return width >= kMinWidth_px && width - narrowing >= kCrossing_px &&
         weak >= kMinStrengthRatio * strong;
}

}  // namespace

CloseEdgeFinder::CloseEdgeFinder(double blur_px)
    : unit_px_(std::max(1.0, blur_px)),
      blur_(blur_px / unit_px_),
      basis_(profile_half_width_px(blur_), profile_half_width_px(blur_) - 1.8 * blur_, blur_) {}

std::optional<std::array<ProfileStep, 2>> CloseEdgeFinder::find(const cv::Mat& image,
                                                                const Segment2& segment) const {
  constexpr int kPasses = 6;
  // Two steps in the same direction may also be one step with a wider blur, for example a soft
  // shadow.
  constexpr double kMinOneWayWidth_px = 0.9;
  const double half_width = profile_half_width_px(blur_);
  const std::vector<ProfileSample> samples = profile_samples(image, segment, half_width, unit_px_);
  if (samples.size() < kMinProfileSamples) return std::nullopt;
  const auto begin = two_offsets(basis_, BinnedProfile(samples, half_width));
  if (!begin) return std::nullopt;
  TwoSteps model((*begin)[0], (*begin)[1], image.channels(), blur_);
  if (!model.improve(samples, true)) return std::nullopt;
  for (int pass = 0; pass < kPasses; ++pass) {
    if (!model.improve(samples, false)) return std::nullopt;
  }
  std::array<ProfileStep, 2> steps{model.step(0), model.step(1)};
  if (!is_sound(steps, *begin)) return std::nullopt;
  const double width = steps[1].offset_px - steps[0].offset_px;
  if (width < kMinOneWayWidth_px && !model.turns_back()) return std::nullopt;
  for (ProfileStep& step : steps) {
    step.offset_px *= unit_px_;
    step.tilt_px *= unit_px_;
  }
  return steps;
}

}  // namespace ridgeline::reconstruct
