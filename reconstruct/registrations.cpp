// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/registrations.h"

#include "reconstruct/estimate/beyond/profile_registration.h"
#include "reconstruct/estimate/beyond/shared_errors.h"
#include "reconstruct/geometry/transformed.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace ridgeline::reconstruct {
namespace {

/// Comparison of the profile across the base edge of each track with those across its other edges,
/// by observation. The first one is not compared.
std::vector<std::vector<ComparedProfiles>> profiles_of(const Scene& scene,
                                                       std::span<const Track> tracks,
                                                       double max_angle_deg) {
  struct Place {
    std::size_t track, observation;
  };
  std::map<std::pair<std::size_t, std::size_t>, std::vector<Place>> places;  // by pair of views
  std::vector<std::vector<ComparedProfiles>> profiles;
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    const std::size_t base = tracks[t].base().view;
    const std::vector<Observation>& observations = tracks[t].observations;
    profiles.emplace_back(observations.size());
    for (std::size_t s = 1; s < observations.size(); ++s) {
      if (observations[s].view != base) places[{base, observations[s].view}].push_back({t, s});
    }
  }
  for (const auto& [views, of_pair] : places) {
    const auto matches = transformed(of_pair, [&](const Place& p) {
      return Correspondence{tracks[p.track].base().segment,
                            tracks[p.track].observations[p.observation].segment};
    });
    const std::vector<ComparedProfiles> compared =
        compare_profiles(stereo_pair(scene, {views.first, views.second}), matches, max_angle_deg);
    for (std::size_t i = 0; i < of_pair.size(); ++i)
      profiles[of_pair[i].track][of_pair[i].observation] = compared[i];
  }
  return profiles;
}

/// The registrations of each track from the profiles across its edges. The base edge is as certain
/// as the edge most similar to it.
std::vector<Registrations> registrations_by_profiles(const Scene& scene,
                                                     std::span<const Track> tracks,
                                                     const EstimationOptions& options) {
  const EstimateExtensionOptions& beyond = options.beyond;
  return transformed(profiles_of(scene, tracks, options.lines.max_aligned_angle_deg),
                     [&](const std::vector<ComparedProfiles>& by_observation) {
                       Registrations all(by_observation.size());
                       std::optional<double> best;
                       for (std::size_t s = 1; s < all.size(); ++s) {
                         if (beyond.register_profiles)
                           all[s].shift_px = by_observation[s].right_shift_px;
                         const std::optional<double>& similarity = by_observation[s].similarity;
                         if (!beyond.shared_errors || !similarity) continue;
                         all[s].sigma_scale = own_sigma_scale(*similarity);
                         best = std::min(best.value_or(all[s].sigma_scale), all[s].sigma_scale);
                       }
                       all[0].sigma_scale = best.value_or(1.0);
                       return all;
                     });
}

/// Scales the sigmas of each track by how well its observations agree.
/// @param registrations  of `tracked`
void scale_by_agreement(const TrackedSegments& tracked, std::vector<Registrations>& registrations) {
  const std::vector<ObservedTrack> lines =
      tracked_lines(tracked, registered(tracked), LineCovariance::kCentroid).lines;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const double scale = agreement_sigma_scale(lines[i]);
    for (Registration& r : registrations[i]) r.sigma_scale *= scale;
  }
}

}  // namespace

std::vector<Registrations> registrations_of(const Scene& scene,
                                            TrackedSegments tracked,
                                            const EstimationOptions& options) {
  const EstimateExtensionOptions& beyond = options.beyond;
  if (tracked.tracks.empty() || (!beyond.register_profiles && !beyond.shared_errors)) return {};
  std::vector<Registrations> registrations =
      registrations_by_profiles(scene, tracked.tracks, options);
  tracked.registrations = registrations;
  if (beyond.shared_errors) scale_by_agreement(tracked, registrations);
  return registrations;
}

}  // namespace ridgeline::reconstruct
