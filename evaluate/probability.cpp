// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/probability.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace ridgeline::evaluate {

namespace bm = boost::math;

double normal_quantile(double probability) { return bm::quantile(bm::normal(), probability); }
double normal_cdf(double z) { return bm::cdf(bm::normal(), z); }
double normal_tail(double z) { return bm::cdf(bm::complement(bm::normal(), z)); }

double chi_square_quantile(double dof, double probability) {
  return bm::quantile(bm::chi_squared(dof), probability);
}
double chi_square_upper_quantile(double dof, double tail) {
  return bm::quantile(bm::complement(bm::chi_squared(dof), tail));
}

double student_t_quantile(double dof, double probability) {
  return bm::quantile(bm::students_t(dof), probability);
}

}  // namespace ridgeline::evaluate
