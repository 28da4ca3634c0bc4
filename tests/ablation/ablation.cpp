// SPDX-License-Identifier: BSD-3-Clause
// ablation FOLDER [--views VIEWS] [--held-out] [--only NAME[+NAME...],...] [--patch VAIHINGEN]:
// measures the gain from each extension beyond the papers. Disables the extensions one at a time
// (those joined by `+` together) on the training villages (seeds 1 to 8 and 21 to 28) and on seeds
// 1 to 10 of the other renderer; with --held-out, on seeds 101 to 110 of both. With --views, in the
// format of `simulate --views` (for example strip:3,cross:2), only on the first three of these
// scenes. Prints Markdown tables: matches, roof lines found, errors by class against true lines, z
// against LIDAR, processor time, and the difference from the default with a 95 % bootstrap interval
// over the scenes. Vaihingen has only LIDAR, so its interval is from a clustered bootstrap over
// planes.
#include "tests/other_scenes/write_scene.h"
#include "tests/support/csv_rows.h"
#include "tests/support/paths.h"
#include "tests/support/run_program.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace fs = std::filesystem;
using ridgeline::test::CsvRow;

/// An extension, and the entry of a config file that disables it.
struct Extension {
  const char* name;
  const char* group;
  const char* entry;
};

constexpr std::array kExtensions{
    Extension{"faint_edges", "extract", "faint_edges: false"},
    Extension{"junction_cuts", "extract", "junction_cuts: false"},
    Extension{"separate_edges", "extract", "separate_edges: false"},
    Extension{"soft_edges", "extract", "soft_edges: false"},
    Extension{"matched_radiometry", "match", "matched_radiometry: false"},
    Extension{"hidden_walls", "match", "hidden_walls: false"},
    Extension{"match_surface", "match", "surface: false"},
    Extension{"guided", "match", "guided: false"},
    Extension{"register_profiles", "reconstruct", "register_profiles: false"},
    Extension{"shared_errors", "reconstruct", "shared_errors: false"},
    Extension{"faces_beside", "reconstruct", "faces_beside: false"},
    Extension{"common_part", "reconstruct", "common_part: false"},
    Extension{"consensus", "reconstruct", "consensus: false, surface: false"},
    Extension{"surface", "reconstruct", "surface: false"},
    Extension{"gable_share", "reconstruct", "gable_share: 0"},
    Extension{"step_share", "reconstruct", "step_share: 0"}};

/// Extensions that are disabled together; the default disables none.
struct Variant {
  std::string name;
  std::vector<Extension> left_out;
};

/// The requested runs.
struct Plan {
  fs::path folder;
  std::string views;  ///< in the format of `simulate --views`; empty: a pair
  bool is_held_out = false;
  std::vector<Variant> variants{{"default", {}}};
  std::string vaihingen;  ///< patch file of Vaihingen; empty: not run
};

constexpr int kScenesOfManyViews = 3;  // per renderer

/// Results of one variant on one scene.
struct SceneFigures {
  double correct = 0.0, wrong = 0.0, missed = 0.0;
  double roof_lines = 0.0, roof_found = 0.0;
  struct Errors {
    double n = 0.0, sum_squares_m2 = 0.0, sum_medians_m = 0.0, gross = 0.0;
  };
  std::map<std::string, Errors> errors;  ///< by class, against true lines
  double judged = 0.0, sum_z2 = 0.0, beyond = 0.0;
};

double number(const CsvRow& row, const std::string& column) {
  const std::string& text = row.at(column);
  return text.empty() ? 0.0 : std::stod(text);
}

void check(bool holds, const std::string& what) {
  if (!holds) throw std::runtime_error(what);
}

/// The results of `method` by scene, from the tables of a run.
std::map<std::string, SceneFigures> figures_of(const fs::path& results, const std::string& method) {
  std::map<std::string, SceneFigures> scenes;
  for (const CsvRow& row : ridgeline::test::read_csv(results / "table1.csv")) {
    SceneFigures& scene = scenes[row.at("patch")];
    scene.correct = number(row, "correct");
    scene.wrong = number(row, "false");
    scene.missed = number(row, "missed");
  }
  for (const CsvRow& row : ridgeline::test::read_csv(results / "reference_completeness.csv")) {
    const std::string& kind = row.at("kind");
    if (row.at("method") != method || kind == "all" || kind == "ground") continue;
    scenes[row.at("patch")].roof_lines += number(row, "n_reference_lines");
    scenes[row.at("patch")].roof_found += number(row, "n_reconstructed");
  }
  for (const CsvRow& row : ridgeline::test::read_csv(results / "reference_errors.csv")) {
    if (row.at("method") != method) continue;
    const double n = number(row, "n_on_reference");
    const double rms_m = number(row, "rms_m");
    scenes[row.at("patch")].errors[row.at("class")] = {
        n, n * rms_m * rms_m, n * number(row, "median_m"), n * number(row, "gross_share")};
  }
  for (auto& [patch, scene] : scenes) {
    std::ifstream file(results / patch / ("evaluation." + method + ".json"));
    const auto calibration = nlohmann::json::parse(file)["calibration"];
    scene.judged = calibration["n"];
    if (scene.judged == 0.0) continue;
    scene.sum_z2 = scene.judged * calibration["median_z2"].get<double>();
    scene.beyond = scene.judged * calibration["share_beyond_99_9"].get<double>();
  }
  return scenes;
}

using Scenes = std::vector<SceneFigures>;

SceneFigures sum_of(const Scenes& scenes) {
  SceneFigures sum;
  for (const SceneFigures& s : scenes) {
    sum.correct += s.correct;
    sum.wrong += s.wrong;
    sum.missed += s.missed;
    sum.roof_lines += s.roof_lines;
    sum.roof_found += s.roof_found;
    sum.judged += s.judged;
    sum.sum_z2 += s.sum_z2;
    sum.beyond += s.beyond;
    for (const auto& [line_class, e] : s.errors) {
      SceneFigures::Errors& total = sum.errors[line_class];
      total.n += e.n;
      total.sum_squares_m2 += e.sum_squares_m2;
      total.sum_medians_m += e.sum_medians_m;
      total.gross += e.gross;
    }
  }
  return sum;
}

double rms_m(const SceneFigures& f, const std::string& line_class) {
  const SceneFigures::Errors& e = f.errors.at(line_class);
  return e.n > 0.0 ? std::sqrt(e.sum_squares_m2 / e.n) : 0.0;
}

struct Measure {
  const char* name;
  std::function<double(const SceneFigures&)> of;
};

const std::vector<Measure>& measures() {
  static const std::vector<Measure> all{
      {"quality %",
       [](const SceneFigures& f) { return 100.0 * f.correct / (f.correct + f.wrong + f.missed); }},
      {"roof lines %", [](const SceneFigures& f) { return 100.0 * f.roof_found / f.roof_lines; }},
      {"not_aligned mm", [](const SceneFigures& f) { return 1e3 * rms_m(f, "not_aligned"); }},
      {"median mm",
       [](const SceneFigures& f) {
         const SceneFigures::Errors& e = f.errors.at("not_aligned");
         return 1e3 * e.sum_medians_m / e.n;
       }},
      {"aligned mm", [](const SceneFigures& f) { return 1e3 * rms_m(f, "aligned"); }},
      {"gross", [](const SceneFigures& f) { return f.errors.at("total").gross; }}};
  return all;
}

/// 95 % bootstrap interval of the difference of a measure over all scenes; both variants are
/// evaluated on the same scenes, drawn with replacement.
std::array<double, 2> interval(const Measure& measure, const Scenes& with, const Scenes& without) {
  constexpr int kReplicates = 2000;
  std::mt19937_64 random(1);
  std::uniform_int_distribution<std::size_t> draw(0, with.size() - 1);
  std::vector<double> differences;
  for (int r = 0; r < kReplicates; ++r) {
    Scenes a, b;
    for (std::size_t i = 0; i < with.size(); ++i) {
      const std::size_t scene = draw(random);
      a.push_back(with[scene]);
      b.push_back(without[scene]);
    }
    differences.push_back(measure.of(sum_of(b)) - measure.of(sum_of(a)));
  }
  std::ranges::sort(differences);
  return {differences[kReplicates / 40], differences[kReplicates - 1 - kReplicates / 40]};
}

/// The config file of a variant.
std::string config_of(const Variant& variant) {
  std::map<std::string, std::string> groups{{"judge", ""}};
  for (const auto& [name, group, entry] : variant.left_out) {
    std::string& entries = groups[group];
    entries += (entries.empty() ? "" : ", ") + std::string(entry);
  }
  std::string config;
  for (const auto& [group, entries] : groups) config += fmt::format("{}: {{{}}}\n", group, entries);
  return config;
}

/// Runs all variants on the patches; the results of each go into a folder with its name. Returns
/// their processor times.
std::map<std::string, double> run_variants(const std::vector<Variant>& variants,
                                           const fs::path& folder,
                                           const std::vector<std::string>& patches) {
  std::map<std::string, double> seconds;
  for (const Variant& variant : variants) {
    const fs::path config = folder / (variant.name + ".yaml");
    std::ofstream(config) << config_of(variant);
    std::vector<std::string> arguments{"run",       "--out",         variant.name, "--no-report",
                                       "--methods", "joint,network", "--config",   config.string()};
    arguments.insert(arguments.end(), patches.begin(), patches.end());
    const auto result = ridgeline::test::run_program(ridgeline::test::program(), arguments, folder);
    check(result.exit_code == 0, result.err);
    seconds[variant.name] = result.processor_s;
    std::fprintf(stderr, "%s: %s, %.1f s\n", folder.filename().c_str(), variant.name.c_str(),
                 result.processor_s);
  }
  return seconds;
}

Scenes scenes_of(const fs::path& results, const std::string& method) {
  Scenes scenes;
  for (const auto& [patch, figures] : figures_of(results, method)) scenes.push_back(figures);
  return scenes;
}

std::string row_of(const Variant& variant, const SceneFigures& f, double seconds) {
  std::string row =
      fmt::format("| {} | {:.0f} / {:.0f} / {:.0f} ", variant.name, f.correct, f.wrong, f.missed);
  for (const Measure& measure : measures()) row += fmt::format("| {:.1f} ", measure.of(f));
  const auto of_judged = [&](double sum, double scale) {
    return f.judged > 0.0 ? fmt::format("{:.2f}", scale * sum / f.judged) : std::string("-");
  };
  return row + fmt::format("| {} | {} | {:.1f} |\n", of_judged(f.sum_z2, 1.0),
                           of_judged(f.beyond, 100.0), seconds);
}

void print_set(const std::string& title,
               const std::vector<Variant>& variants,
               const fs::path& folder,
               const std::vector<std::string>& patches) {
  const std::map<std::string, double> seconds = run_variants(variants, folder, patches);
  for (const std::string method : {"joint", "network"}) {
    std::string head = "| without | correct / false / missed |";
    std::string rule = "|---|--:|";
    std::string changes = "| without |";
    for (const Measure& measure : measures()) {
      head += fmt::format(" {} |", measure.name);
      changes += fmt::format(" {} |", measure.name);
      rule += "--:|";
    }
    fmt::print(
        "\n{}, {} scenes, `{}`\n\n{} median z² | beyond 3.29 % | processor s |\n{}--:|--:|--:|\n",
        title, patches.size(), method, head, rule);
    const Scenes with = scenes_of(folder / variants[0].name, method);
    for (const Variant& variant : variants) {
      fmt::print("{}", row_of(variant, sum_of(scenes_of(folder / variant.name, method)),
                              seconds.at(variant.name)));
    }
    fmt::print("\nChange without it, 95 % interval by scene\n\n{}\n{}\n", changes,
               rule.substr(0, rule.size() - 4));
    for (std::size_t v = 1; v < variants.size(); ++v) {
      const Scenes without = scenes_of(folder / variants[v].name, method);
      fmt::print("| {} |", variants[v].name);
      for (const Measure& measure : measures()) {
        const auto [low, high] = interval(measure, with, without);
        fmt::print(" {:+.1f} ({:+.1f}, {:+.1f}) |",
                   measure.of(sum_of(without)) - measure.of(sum_of(with)), low, high);
      }
      fmt::print("\n");
    }
  }
}

/// The seeds of a set of scenes: the given training seeds, or the held-out ones.
std::vector<int> seeds_of(const Plan& plan, std::vector<int> seeds) {
  if (plan.is_held_out) seeds = {101, 102, 103, 104, 105, 106, 107, 108, 109, 110};
  if (!plan.views.empty()) seeds.resize(kScenesOfManyViews);
  return seeds;
}

std::vector<std::string> make_villages(const Plan& plan, const fs::path& folder) {
  std::vector<std::string> patches;
  for (const int seed : seeds_of(plan, {1, 2, 3, 4, 5, 6, 7, 8, 21, 22, 23, 24, 25, 26, 27, 28})) {
    const std::string name = std::to_string(seed);
    std::vector<std::string> arguments{"simulate",
                                       "--out",
                                       name,
                                       "--seed",
                                       name,
                                       "--extent-m",
                                       "80,80",
                                       "--street-azimuth-deg",
                                       std::to_string(17 * (seed - 1) % 90)};
    if (!plan.views.empty()) arguments.insert(arguments.end(), {"--views", plan.views});
    const auto result = ridgeline::test::run_program(ridgeline::test::program(), arguments, folder);
    check(result.exit_code == 0, result.err);
    patches.push_back((folder / name / "patch.yaml").string());
  }
  return patches;
}

std::vector<std::string> make_other_scenes(const Plan& plan, const fs::path& folder) {
  const auto flight = ridgeline::other::flight_plan(plan.views.empty() ? "strip:2" : plan.views);
  std::vector<std::string> patches;
  for (const int seed : seeds_of(plan, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10})) {
    const fs::path scene = folder / std::to_string(seed);
    fs::create_directories(scene);
    ridgeline::other::write_scene(scene.string(), static_cast<std::uint64_t>(seed), flight);
    patches.push_back((scene / "patch.yaml").string());
  }
  return patches;
}

void print_vaihingen(const std::vector<Variant>& variants,
                     const fs::path& folder,
                     const std::string& patch) {
  (void)run_variants(variants, folder, {patch});
  fmt::print(
      "\nVaihingen against LIDAR, `joint`: RMS m with its 95 % interval over planes\n\n"
      "| without | matches | total | n | aligned | n |\n|---|--:|--:|--:|--:|--:|\n");
  for (const Variant& variant : variants) {
    std::map<std::string, CsvRow> rows;
    for (const CsvRow& row : ridgeline::test::read_csv(folder / variant.name / "table2.csv")) {
      if (row.at("method") == "joint") rows[row.at("class")] = row;
    }
    fmt::print("| {} | {} |", variant.name, rows["total"].at("n_lines"));
    for (const char* line_class : {"total", "aligned"}) {
      const CsvRow& row = rows[line_class];
      fmt::print(" {:.3f} ({:.3f}, {:.3f}) | {} |", number(row, "rms_m"), number(row, "ci95_low_m"),
                 number(row, "ci95_high_m"), row.at("n_evaluated"));
    }
    fmt::print("\n");
  }
}

fs::path made(const fs::path& folder) {
  fs::create_directories(folder);
  return fs::absolute(folder);
}

std::vector<std::string> parts_of(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

Variant variant_of(const std::string& name) {
  Variant variant{name, {}};
  for (const std::string& part : parts_of(name, '+')) {
    const auto* const found = std::ranges::find(
        kExtensions, part, [](const Extension& e) { return std::string(e.name); });
    check(found != kExtensions.end(), "no extension " + part);
    variant.left_out.push_back(*found);
  }
  return variant;
}

/// Throws std::runtime_error for unknown arguments.
Plan plan_of(const std::vector<std::string>& arguments) {
  check(!arguments.empty(), "usage: see the head of ablation.cpp");
  Plan plan;
  plan.folder = arguments[0];
  std::string only;
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    if (arguments[i] == "--held-out") {
      plan.is_held_out = true;
      continue;
    }
    const std::map<std::string, std::string*> values{
        {"--views", &plan.views}, {"--only", &only}, {"--patch", &plan.vaihingen}};
    const auto found = values.find(arguments[i]);
    check(found != values.end() && i + 1 < arguments.size(), "not known: " + arguments[i]);
    *found->second = arguments[++i];
  }
  for (const std::string& name : parts_of(only, ',')) plan.variants.push_back(variant_of(name));
  if (!only.empty()) return plan;
  for (const Extension& extension : kExtensions)
    plan.variants.push_back({extension.name, {extension}});
  return plan;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const Plan plan = plan_of({argv + 1, argv + argc});
    const fs::path villages = made(plan.folder / "villages");
    print_set(plan.is_held_out ? "Held-out villages" : "Training villages", plan.variants, villages,
              make_villages(plan, villages));
    const fs::path other = made(plan.folder / "other_scenes");
    print_set("Other renderer", plan.variants, other, make_other_scenes(plan, other));
    if (!plan.vaihingen.empty()) {
      print_vaihingen(plan.variants, made(plan.folder / "vaihingen"),
                      fs::absolute(plan.vaihingen).string());
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "ablation: %s\n", error.what());
    return 1;
  }
  return 0;
}
