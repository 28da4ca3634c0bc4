// SPDX-License-Identifier: BSD-3-Clause
#include "tests/evaluate/faces/judged_building.h"

#include <gmock/gmock.h>

#include <cmath>
#include <cstdio>

namespace ridgeline::test {
namespace {

using evaluate::Estimate;
using evaluate::FaceEvaluation;
using evaluate::FaceStatus;

struct Hits {
  int n = 0, shift = 0, height = 0, pitch = 0, aspect = 0, along = 0, across = 0, tilted=0, sh1=0, p03=0, bad=0;
};

Hits run(double lo, double hi, int n, double tilt) {
  Hits h;
  Random random(7);
  for (int i = 0; i < n; ++i) {
    const BuildingSpec spec = random_gable(std::exp(random.uniform(std::log(lo), std::log(hi))), random);
    Fault fault{.shift_m = tilt<0?0.0:random.uniform(-1.0, 1.0), .pitch_deg = random.uniform(-tilt, tilt), .aspect_deg = random.uniform(-tilt, tilt)};
    const FaceEvaluation e = judged_with(spec, fault, {.seed = 1000U + i});
    ++h.n;
    if (e.status != FaceStatus::kEvaluated) { ++h.bad; std::printf("bad %s area %.1f n_over %d\n", name(e.status), e.area_m2, e.n_over); continue; }
    const auto in = [](const Estimate& x, double t) { return std::abs(x.value - t) <= x.half_width; };
    const auto& d = e.difference;
    h.shift += in(d.shift_m, fault.shift_m);
    h.sh1 += std::abs(d.shift_m.value - fault.shift_m) <= 0.01;
    h.pitch += d.pitch_deg && in(*d.pitch_deg, fault.pitch_deg);
    h.p03 += d.pitch_deg && std::abs(d.pitch_deg->value - fault.pitch_deg) <= 0.3;
    h.aspect += d.aspect_deg && in(*d.aspect_deg, fault.aspect_deg);
    if (tilt == 0) { h.along += in(d.along_deg, 0); h.across += in(d.across_deg, 0); h.tilted += d.tilted; }
  }
  std::printf("%g-%g m2 tilt %g: n %d bad %d shift %d pitch %d aspect %d along %d across %d tilted %d | 1cm %d 0.3deg %d\n", lo, hi, tilt, h.n, h.bad, h.shift, h.pitch, h.aspect, h.along, h.across, h.tilted, h.sh1, h.p03);
  return h;
}

TEST(Explore, Coverage) {run(50, 200, 2000, -1e-9);run(20, 21, 2000, -1e-9);run(8, 9, 2000, -1e-9);run(50, 200, 2000, 0);run(20, 21, 2000, 8);run(6,30,2000,8);run(50,200,2000,14);




}
}  // namespace
}  // namespace ridgeline::test
