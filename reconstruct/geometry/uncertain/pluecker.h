// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/geometry/uncertain/homogeneous.h"

#include <Eigen/Core>

#include <array>
#include <optional>

namespace ridgeline {

/// Points X = (X_0; X_h), planes A = (A_h; A_0) and Pluecker lines L = (L_h; L_0) with direction
/// L_h, moment L_0 = X_0 x L_h and L_h . L_0 = 0, and the matrices that join, intersect and test
/// them (Foerstner and Wrobel 2016, section 7). The matrices of points and planes have the same
/// type, so the compiler does not notice if a barred matrix is used where a plain one is meant.
using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// The 6x4 matrix Pi. Pi(X) Y = X ^ Y is the join of two points; Pi'(A) L = 0 means that the line
/// lies in the plane.
Eigen::Matrix<double, 6, 4> pi_matrix(const Eigen::Vector4d& x);

/// The 6x4 matrix PiBar. PiBar(A) B = A n B is the intersection of two planes; PiBar'(X) L = 0
/// means that the point is on the line.
Eigen::Matrix<double, 6, 4> pi_bar_matrix(const Eigen::Vector4d& x);

/// The 4x4 matrix Gamma of rank 2. Gamma(L) A = L n A is the intersection of a line and a plane;
/// Pi'(A) L = -Gamma(L) A.
Eigen::Matrix4d gamma_matrix(const Vector6d& line);

/// The 4x4 matrix GammaBar of rank 2. GammaBar(L) X = L ^ X is the join of a line and a point;
/// PiBar'(X) L = -GammaBar(L) X.
Eigen::Matrix4d gamma_bar_matrix(const Vector6d& line);

/// The dual line D L = (L_0; L_h).
Vector6d dual(const Vector6d& line);

/// The 3x6 matrix Q. l = Q L is the image of a line; its sign is that of the join of the images of
/// two points of the line.
Eigen::Matrix<double, 3, 6> line_projection(const ProjectionMatrix& image_from_object);

/// Two independent rows of the four incidence conditions of a line, chosen by the largest component
/// of the line, so that the smaller singular value of the two rows stays above half the larger.
using RowPair = std::array<int, 2>;

/// Index (0..5) of the component of the line with the largest magnitude.
int dominant_component(const Vector6d& line);
RowPair point_on_line_rows(int dominant);  ///< rows of PiBar' and GammaBar
RowPair line_in_plane_rows(int dominant);  ///< rows of Pi' and Gamma

template <typename Derived>
Eigen::Matrix<double, 2, Derived::ColsAtCompileTime> select_rows(
    const Eigen::MatrixBase<Derived>& matrix, const RowPair& rows) {
  Eigen::Matrix<double, 2, Derived::ColsAtCompileTime> selected;
  selected << matrix.row(rows[0]), matrix.row(rows[1]);
  return selected;
}

/// The unit vector closest to `line` with L_h . L_0 = 0. If L_h = L_0 or L_h = -L_0, the closest
/// vector is not unique and the result is not finite. The result is meaningful only in a
/// conditioned frame, where directions and moments have comparable size.
Vector6d project_to_pluecker_quadric(const Vector6d& line);

/// Orthonormal basis, 6x4, of the four directions in which a unit Pluecker line can change and
/// remain a unit Pluecker line. It spans the null space of (D L, L)'.
Eigen::Matrix<double, 6, 4> line_tangent_basis(const Vector6d& line);

/// Signed distance between two lines in the unit of the coordinates, for any scale of the
/// homogeneous vectors; its sign changes with the sign of either vector. Not finite for parallel
/// lines.
double signed_distance(const Vector6d& a, const Vector6d& b);

/// The plane A = P' l through the projection centre and an image line; P is assumed to be free of
/// error (Ok et al. 2011, Eq. 5). The result is not normalised.
UncertainPlane3 projection_plane(const ProjectionMatrix& image_from_object,
                                 const UncertainLine2& line);

/// The plane A = P' l for a P with the covariance of vec(P), columns stacked. The published Eq. 5
/// has the Kronecker factors in the wrong order; here they are (I_4 x l') cov_P (I_4 x l).
UncertainPlane3 projection_plane(const ProjectionMatrix& image_from_object,
                                 const Eigen::Matrix<double, 12, 12>& cov_vec_p,
                                 const UncertainLine2& line);

/// Intersection of two uncorrelated planes, spherically normalised. std::nullopt for planes that
/// are parallel or identical to within rounding: the sine of the angle between the normals is below
/// 1e-9.
std::optional<UncertainLine3> intersection(const UncertainPlane3& a, const UncertainPlane3& b);

}  // namespace ridgeline
