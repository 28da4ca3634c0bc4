#include "tests/evaluate/faces/judged_building.h"
#include <gmock/gmock.h>
#include <cstdio>
namespace ridgeline::test {
namespace {
TEST(Explore, Shapes) {
  for (int s = 0; s < kNumRoofShapes; ++s) {
    const MadeBuilding made = make_building({.shape = static_cast<RoofShape>(s), .length_m = 14, .width_m = 10, .pitch_deg = 38, .azimuth_deg = 20, .t_junctions = s == 0});
    const evaluate::RoofBuilding b = roof_of(made);
    const auto e = evaluate::judge_faces(scan_of(made, {}), std::span(&b, 1), {})[0];
    std::printf("shape %d\n", s);
    for (const auto& f : e) {
      double worst = 0;
      for (const auto& o : f.edges) if (std::abs(o.offset_m) > std::abs(worst)) worst = o.offset_m;
      std::printf("  %s %s %s area %.1f n %d/%d unexpl %d shift %.3f+-%.3f angle %.2f+-%.2f share %.3f cov %.3f beyond %.2f missing %.2f edges %zu worst %.2f\n", f.id.c_str(), name(f.status), text(f.verdict).c_str(), f.area_m2, f.fit.n, f.n_over, f.n_unexplained, f.difference.shift_m.value, f.difference.shift_m.half_width, f.difference.angle_deg.value, f.difference.angle_deg.half_width, f.share_on_plane, f.covered_share, f.beyond_m2, f.missing_m2, f.edges.size(), worst);
    }
  }
}
}
}
