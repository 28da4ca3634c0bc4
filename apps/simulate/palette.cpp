// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/palette.h"

#include "apps/simulate/noise.h"

#include <array>
#include <span>

namespace ridgeline::simulate {
namespace {

/// Reflectance in red, green, blue and near infrared; based on the spectra of urban materials in
/// Herold, Roberts, Gardner, Dennison 2004, rounded.
using Entry = std::array<float, 4>;

constexpr std::array<Entry, 8> kTiledRoofs{{{0.34F, 0.16F, 0.10F, 0.44F},  // new clay
                                            {0.26F, 0.13F, 0.09F, 0.36F},
                                            {0.20F, 0.11F, 0.08F, 0.28F},  // old clay
                                            {0.16F, 0.11F, 0.08F, 0.21F},
                                            {0.30F, 0.20F, 0.13F, 0.38F},  // with lichen
                                            {0.11F, 0.11F, 0.12F, 0.13F},  // slate
                                            {0.07F, 0.07F, 0.075F, 0.08F},
                                            {0.17F, 0.16F, 0.15F, 0.19F}}};  // concrete
constexpr std::array<Entry, 4> kFlatRoofs{{{0.26F, 0.25F, 0.23F, 0.28F},     // gravel
                                           {0.15F, 0.15F, 0.15F, 0.16F},     // bitumen
                                           {0.34F, 0.34F, 0.34F, 0.36F},     // membrane
                                           {0.12F, 0.14F, 0.07F, 0.34F}}};   // planted
constexpr std::array<Entry, 6> kWalls{{{0.66F, 0.64F, 0.60F, 0.68F},
                                       {0.60F, 0.53F, 0.40F, 0.64F},
                                       {0.55F, 0.50F, 0.44F, 0.58F},
                                       {0.62F, 0.58F, 0.36F, 0.66F},
                                       {0.48F, 0.47F, 0.47F, 0.50F},
                                       {0.52F, 0.36F, 0.30F, 0.58F}}};
constexpr std::array<Entry, 3> kGutters{{{0.34F, 0.34F, 0.35F, 0.33F},  // zinc
                                         {0.20F, 0.13F, 0.09F, 0.30F},  // copper, old
                                         {0.58F, 0.57F, 0.55F, 0.60F}}};
constexpr std::array<Entry, 3> kChimneys{
    {{0.28F, 0.14F, 0.10F, 0.36F}, {0.42F, 0.40F, 0.37F, 0.44F}, {0.20F, 0.19F, 0.19F, 0.21F}}};
constexpr std::array<Entry, 7> kCars{{{0.60F, 0.60F, 0.60F, 0.60F},
                                      {0.30F, 0.31F, 0.32F, 0.31F},
                                      {0.04F, 0.04F, 0.045F, 0.05F},
                                      {0.03F, 0.04F, 0.04F, 0.05F},
                                      {0.05F, 0.08F, 0.22F, 0.10F},
                                      {0.32F, 0.03F, 0.03F, 0.35F},
                                      {0.10F, 0.11F, 0.12F, 0.12F}}};
constexpr std::array<Entry, 3> kLeaves{{{0.050F, 0.100F, 0.035F, 0.46F},
                                        {0.040F, 0.080F, 0.030F, 0.40F},
                                        {0.075F, 0.115F, 0.040F, 0.52F}}};
constexpr std::array<Entry, 1> kGrass{{{0.105F, 0.150F, 0.060F, 0.44F}}};
constexpr std::array<Entry, 1> kAsphalt{{{0.125F, 0.124F, 0.122F, 0.15F}}};
constexpr std::array<Entry, 1> kPaint{{{0.50F, 0.50F, 0.48F, 0.52F}}};
constexpr std::array<Entry, 1> kGlass{{{0.045F, 0.055F, 0.070F, 0.06F}}};
constexpr std::array<Entry, 2> kFrames{
    {{0.62F, 0.62F, 0.60F, 0.64F}, {0.18F, 0.13F, 0.10F, 0.24F}}};
constexpr std::array<Entry, 1> kSolar{{{0.030F, 0.035F, 0.060F, 0.05F}}};
constexpr std::array<Entry, 3> kPaving{
    {{0.32F, 0.30F, 0.27F, 0.35F}, {0.24F, 0.24F, 0.23F, 0.26F}, {0.36F, 0.26F, 0.19F, 0.42F}}};
constexpr std::array<Entry, 1> kTimber{{{0.17F, 0.13F, 0.10F, 0.26F}}};

std::span<const Entry> choices(Material material, bool flat_roof) {
  switch (material) {
    case Material::kGround:
      return kGrass;
    case Material::kStreet:
      return kAsphalt;
    case Material::kMarking:
      return kPaint;
    case Material::kRoof:
      return flat_roof ? std::span<const Entry>(kFlatRoofs) : kTiledRoofs;
    case Material::kGutter:
      return kGutters;
    case Material::kWall:
    case Material::kGardenWall:
      return kWalls;
    case Material::kChimney:
      return kChimneys;
    case Material::kFoliage:
      return kLeaves;
    case Material::kWood:
      return kTimber;
    case Material::kCar:
      return kCars;
    case Material::kGlass:
      return kGlass;
    case Material::kFrame:
      return kFrames;
    case Material::kSolar:
      return kSolar;
    case Material::kPaving:
      return kPaving;
  }
  return kGrass;
}

}  // namespace

Spectrum base_reflectance(Material material, bool flat_roof, std::uint32_t key) {
  const std::span<const Entry> entries = choices(material, flat_roof);
  const std::uint32_t h = hash(key, static_cast<std::uint32_t>(material));
  const Entry& entry = entries[h % entries.size()];
  constexpr float kSpread = 0.12F;  // no two houses are exactly alike
  const float gain = 1.0F + kSpread * (2.0F * unit(hash(h)) - 1.0F);
  return gain * Spectrum(entry[0], entry[1], entry[2], entry[3]);
}

}  // namespace ridgeline::simulate
