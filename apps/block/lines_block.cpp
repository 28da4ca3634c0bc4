// SPDX-License-Identifier: BSD-3-Clause
#include "apps/block/lines_block.h"

#include "apps/block/lines_plan.h"
#include "apps/evaluate/write_evaluation.h"
#include "apps/pipeline/made_from.h"
#include "io/error.h"
#include "io/files/atomic_file.h"
#include "io/project/lines_block_file.h"
#include "io/results/cloud_name.h"
#include "io/results/finish_judging.h"
#include "io/results/judged_map.h"
#include "io/results/judged_parts.h"
#include "io/results/part_files.h"
#include "io/results/prepare_lines.h"
#include "io/results/write_results.h"
#include "reconstruct/geometry/check.h"

#include <fmt/core.h>
#include <spdlog/spdlog.h>

#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

namespace ridgeline::apps {
namespace fs = std::filesystem;
namespace {

io::ReadOptions read_options(const io::LinesBlockFile& block, const LinesBlockOptions& given) {
  io::ReadOptions options;
  options.classes = block.classes;
  options.exclude_withheld = block.exclude_withheld;
  options.last_returns = block.last_returns;
  if (!block.bounds.empty()) options.bounds_in_file = io::plan_bounds(block.bounds);
  if (!block.origin.empty()) {
    options.frame = LocalFrame{{block.origin[0], block.origin[1], block.origin[2]}};
  }
  options.assume_crs = block.crs;
  options.strict = given.strict;
  options.salvage = given.salvage;
  return options;
}

results::JudgeFilesOptions judge_files_options(const io::LinesBlockFile& block,
                                               const LinesBlockOptions& given) {
  results::JudgeFilesOptions options;
  options.line_paths = block.lines;
  options.cloud_paths = block.lidar;
  options.patch_name = block.block.empty() ? results::cloud_name(block.lidar) : block.block;
  options.reference_lines = block.reference_lines;
  options.cloud = read_options(block, given);
  options.lines.assume_crs = block.crs;
  options.scale_to_ground = block.scale_to_ground;
  options.cloud_memory_mib = given.cloud_memory_mib;
  options.geoid = given.shift.geoid;
  options.n_decoys = 0;  // a task knows only some of the lines
  const Parameters parameters = read_parameters(given.parameters);
  options.max_aligned_angle_deg = parameters.method.estimation.lines.max_aligned_angle_deg;
  options.judge = parameters.judge;
  options.summary = given.summary;
  validate(options.summary);
  return options;
}

/// The options on which results depend, without the paths, which the plan has as inputs.
nlohmann::ordered_json options_of_plan(const results::JudgeFilesOptions& options) {
  nlohmann::ordered_json json = echo(options);
  json.erase("lines");
  json.erase("cloud");
  json["bca"] = options.summary.bootstrap.bca;
  json["strict"] = options.cloud.strict;
  json["salvage"] = options.cloud.salvage;
  return json;
}

class LinesBlock final : public BlockSteps {
 public:
  LinesBlock(const std::string& block_file, std::string out, LinesBlockOptions given)
      : block_(io::read_lines_block(block_file)),
        out_(std::move(out)),
        given_(std::move(given)),
        options_(judge_files_options(block_, given_)),
        inputs_(inputs_of(options_, "")) {}

  void plan() override {
    const nlohmann::ordered_json now = state();
    if (fs::exists(plan_path())) return refuse_other_plan(now);
    const Opened opened(options_);
    const LinesPlan plan{
        now, cells_of(opened.prepared.lines, opened.cloud.frame(), block_.patch_size_m)};
    write_parts(plan, opened);
    io::write_file(plan_path(), plan.to_json());  // last: a plan is there with all its parts
  }

  [[nodiscard]] std::size_t n_tasks() const override { return the_plan().cells.size(); }

  [[nodiscard]] std::string name_of(std::size_t i) const override {
    const LinesCell& cell = cell_at(i);
    const auto range = [&](std::int64_t place) {
      const double low_m = static_cast<double>(place) * block_.patch_size_m;
      return fmt::format("{:.10g}..{:.10g}", low_m, low_m + block_.patch_size_m);
    };
    return fmt::format("x {}, y {} ({} lines)", range(cell.column), range(cell.row), cell.n_lines);
  }

  [[nodiscard]] Foreseen foreseen_of_task(std::size_t i) const override {
    return foreseen_of_judging(cell_at(i).n_lines, given_.cloud_memory_mib);
  }

  [[nodiscard]] Foreseen foreseen_of_merge() const override {
    std::size_t n_lines = 0;
    for (const LinesCell& cell : the_plan().cells) n_lines += cell.n_lines;
    return foreseen_of_judging(n_lines, 0);
  }

  void run_task(std::size_t i) override {
    (void)cell_at(i);  // there must be such a task
    refuse_changes();
    if (results::is_part(results_path(i), task_key(i))) return;
    const std::optional<results::LinesPart> part =
        results::read_lines_part(lines_path(i), plan_key());
    if (!part) {
      throw io::IoError(lines_path(i), "is missing or damaged; remove " + plan_path() +
                                           " and make the plan again");
    }
    io::ReadOptions cloud_options = options_.cloud;
    cloud_options.frame = part->frame;
    cloud_options.plan_scale = part->plan_scale;
    io::CloudFiles cloud(options_.cloud_paths, cloud_options);
    results::write_part(results_path(i), task_key(i),
                        results::judge_part(cloud, part->lines, options_.judge, memory_bytes()));
  }

  std::size_t merge() override {
    refuse_changes();
    const results::OutputFolder out(out_, results::paths_of(inputs_));
    for (const std::string& name : results::result_names(options_.line_paths)) (void)out.path(name);
    results::RunRecord record("evaluate");  // all that reads results takes them for those of one
    record.set_options(echo(options_));
    record.set("block", {{"path", block_.path}, {"n_tasks", n_tasks()}});
    Opened opened(options_);
    record.end_stage("read_lines");
    results::JudgedParts parts(opened.prepared.lines);
    if (const std::size_t n_missing = add_all(opened, parts); n_missing > 0) return n_missing;
    results::JudgedBatches batches = parts.join(opened.cloud, options_.judge, memory_bytes());
    const results::JudgedFiles judged = finish_judging(
        std::move(opened.prepared), std::move(batches), opened.cloud, options_, record);
    write_evaluation(judged, options_, inputs_of(options_, given_.parameters.config), out,
                     {.folder = out_,
                      .schema = given_.schema,
                      .plane_points = "",
                      .report = given_.report,
                      .page = given_.page},
                     record);
    return 0;
  }

 private:
  /// All lines and the cloud.
  struct Opened {
    explicit Opened(const results::JudgeFilesOptions& options)
        : lines(read_lines_to_judge(options)),
          cloud(options.cloud_paths, options.cloud),
          prepared(prepare_lines(std::move(lines), cloud, options)) {}

    results::LinesToJudge lines;  ///< moved into `prepared`
    io::CloudFiles cloud;
    results::PreparedLines prepared;
  };

  /// The numbers of the lines of each task.
  [[nodiscard]] std::vector<results::LineNumbers> numbers_of(const LinesPlan& plan,
                                                             const Opened& opened) const {
    return numbers_by_cell(plan.cells, opened.prepared.lines, opened.cloud.frame(),
                           block_.patch_size_m);
  }

  /// Writes the lines of each task, so that a task need not read those of all.
  void write_parts(const LinesPlan& plan, const Opened& opened) const {
    const std::vector<results::LineNumbers> numbers = numbers_of(plan, opened);
    const std::string key = key_of({plan.to_json()});
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      results::write_part(
          lines_path(i), key,
          results::LinesPart{.frame = opened.cloud.frame(),
                             .plan_scale = opened.cloud.plan_scale(),
                             .lines = results::lines_of(opened.prepared.lines, numbers[i])});
    }
  }

  [[nodiscard]] nlohmann::ordered_json state() {
    return states_.now(block_.path, inputs_, options_of_plan(options_));
  }

  void refuse_other_plan(const nlohmann::ordered_json& now) const {
    const auto found = difference(the_plan().made_from, now);
    if (!found) return;
    throw io::IoError(plan_path(), fmt::format("is the plan of other inputs or options: {} {}; use "
                                               "another folder for this block",
                                               found->what, found->how));
  }

  void refuse_changes() {
    const auto found = difference(the_plan().made_from, state());
    if (!found) return;
    throw io::IoError(found->what,
                      fmt::format("{}; undo that, or make another plan in another folder than {}",
                                  found->how, out_));
  }

  [[nodiscard]] const LinesPlan& the_plan() const {
    if (!plan_) {
      plan_ = read_lines_plan(plan_path());
      plan_key_ = key_of({plan_->to_json()});
    }
    return *plan_;
  }

  [[nodiscard]] const LinesCell& cell_at(std::size_t i) const {
    const std::vector<LinesCell>& cells = the_plan().cells;
    check(i < cells.size(), "task ", i, " of ", cells.size(), ", must be below their number");
    return cells[i];
  }

  [[nodiscard]] std::string plan_path() const { return (fs::path(out_) / "plan.json").string(); }
  [[nodiscard]] std::string lines_path(std::size_t i) const { return task_file(i, "lines"); }
  [[nodiscard]] std::string results_path(std::size_t i) const { return task_file(i, "judged"); }
  [[nodiscard]] std::string task_file(std::size_t i, const char* extension) const {
    return (fs::path(out_) / "tasks" / fmt::format("{:04}.{}", i, extension)).string();
  }

  /// What the plan and its parts depend on, as a hash.
  [[nodiscard]] const std::string& plan_key() const {
    (void)the_plan();
    return plan_key_;
  }
  /// What a task's results depend on, as a hash.
  [[nodiscard]] std::string task_key(std::size_t i) const {
    return key_of({plan_key(), std::to_string(i)});
  }

  [[nodiscard]] std::uint64_t memory_bytes() const { return options_.cloud_memory_mib << 20U; }

  /// Adds the results of all tasks. Warns of every task that has none.
  /// @return the number of tasks without results
  std::size_t add_all(const Opened& opened, results::JudgedParts& parts) const {
    const std::vector<results::LineNumbers> numbers = numbers_of(the_plan(), opened);
    std::size_t n_missing = 0;
    for (std::size_t i = 0; i < n_tasks(); ++i) {
      if (auto part = results::read_judged_part(results_path(i), task_key(i))) {
        parts.add(numbers[i], std::move(*part));
        continue;
      }
      ++n_missing;
      spdlog::warn("task {}, {}, has no results: {}", i + 1, name_of(i), results_path(i));
    }
    return n_missing;
  }

  io::LinesBlockFile block_;
  std::string out_;
  LinesBlockOptions given_;
  results::JudgeFilesOptions options_;
  std::vector<results::InputFile> inputs_;
  InputStates states_;
  mutable std::optional<LinesPlan> plan_;  ///< read when it is first asked for
  mutable std::string plan_key_;
};

}  // namespace

std::unique_ptr<BlockSteps> make_lines_block(const std::string& block_file,
                                             const std::string& out,
                                             const LinesBlockOptions& options) {
  check(!options.shift.apply,
        "--apply-shift: the shift is that of all lines, which are then judged once more, and a "
        "block judges them once; move the lines' file by the shift that the merge states");
  check_shift_options(options.shift);
  (void)results::map_schema_named(options.schema);
  return std::make_unique<LinesBlock>(block_file, out, options);
}

}  // namespace ridgeline::apps
