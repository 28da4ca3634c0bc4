// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/as_flags.h"
#include "apps/common/command.h"
#include "evaluate/files/run_record.h"
#include "evaluate/files/version.h"
#include "io/error.h"
#include "io/text/nearest_name.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace ridgeline::apps {
namespace {

constexpr std::array kCommands{
    Command{"demo", "run all steps on sample data and print the tables",
            "  ridgeline demo\n"
            "  ridgeline demo --out results --no-report",
            add_demo},
    Command{"evaluate", "judge 3D lines of any tool against a point cloud",
            "  ridgeline evaluate --lines roofs.gpkg --cloud 'tiles/*.laz' --out results\n"
            "  ridgeline evaluate --lines a.geojson b.dxf --cloud lidar.las --patch patch.yaml "
            "--out results\n"
            "  ridgeline evaluate --lines roofs.gpkg --cloud 'tiles/*.laz' --area "
            "513000,5403000,513025,5403050 --out runs/1",
            add_evaluate},
    Command{"pool", "one result of lines that were judged area by area",
            "  ridgeline pool runs/* --out town\n"
            "  ridgeline pool runs/1 runs/2 --out town --no-report",
            add_pool},
    Command{"gate", "fail when accuracy is below the gates (exit code 3)",
            "  ridgeline gate --init > gates.yaml\n"
            "  ridgeline gate results --gates gates.yaml --junit gates.xml",
            add_gate},
    Command{"compare", "compare the same lines between methods, tools or runs",
            "  ridgeline compare before after\n"
            "  ridgeline compare ours theirs others",
            add_compare},
    Command{"report", "write report.html and its figures for a results folder",
            "  ridgeline report results\n"
            "  ridgeline report results --gates gates.yaml --project 'Block 7'",
            add_report},
    Command{"run", "reconstruct 3D lines of patches and judge them against LIDAR",
            "  ridgeline run patch.yaml --out results\n"
            "  ridgeline run patches/*.yaml --out results --methods direct,joint,lines --resume",
            add_run},
    Command{"block", "reconstruct a large area as patches merged into one result",
            "  ridgeline block block.yaml --out town\n"
            "  ridgeline block block.yaml --out town --plan; ridgeline block block.yaml --out town "
            "--task 1-4",
            add_block},
    Command{"extract", "extract line segments of an image with their uncertainty",
            "  ridgeline extract left.tif --out segments.csv\n"
            "  ridgeline extract left.tif --patch patch.yaml --out segments.csv --overlay seen.png",
            add_extract},
    Command{"match", "match line segments between the two images of a patch",
            "  ridgeline match patch.yaml --out matches.csv\n"
            "  ridgeline match patch.yaml --matcher chio --out matches.csv --overlay seen.png",
            add_match},
    Command{"reconstruct", "reconstruct 3D lines from the matched segments of a patch",
            "  ridgeline reconstruct patch.yaml --out lines.geojson\n"
            "  ridgeline reconstruct patch.yaml --matches matches.csv --method network --out "
            "lines.geojson",
            add_reconstruct},
    Command{
        "edges", "find the roof edges of a point cloud as 3D lines",
        "  ridgeline edges --cloud 'tiles/*.laz' --out edges.gpkg\n"
        "  ridgeline edges --cloud lidar.las --classes 2,6 --min-length-m 2 --out edges.dxf\n\n"
        "Curved roofs, trees, and planes with fewer than eight points are not found. Eaves, verges "
        "and steps\nare moved out to where the roof most probably ends; moved_out_m states by "
        "how much.",
        add_edges},
    Command{
        "patch", "write a patch file from an orientation, an area and images",
        "  ridgeline patch --init roofs.yaml --orientation block.xml --images frames --area "
        "513000,5403000,513100,5403100 --lidar 'tiles/*.laz'\n"
        "  ridgeline patch --init roofs.yaml --orientation opk.csv --cameras cameras.yaml --images "
        "'frames/*.tif' --area area.geojson --height-range 230,290",
        add_patch},
    Command{"simulate", "create a synthetic village: images, LIDAR, true lines",
            "  ridgeline simulate --out village\n"
            "  ridgeline simulate --out town --extent-m 1000,1000 --no-images --seed 7\n"
            "  ridgeline simulate --out frames --frame-px 4000,3000 --orientation inpho\n"
            "  ridgeline simulate --out block --block 2,3",
            add_simulate},
    Command{"info", "describe files or folders and how to use them",
            "  ridgeline info lidar.laz roofs.gpkg\n"
            "  ridgeline info patch.yaml",
            add_info},
    Command{"config", "print all parameters with meaning and range, for --config",
            "  ridgeline config > parameters.yaml\n"
            "  ridgeline config --preset published",
            add_config},
};

constexpr const char* kOutputRules =
    "Existing files are only replaced if ridgeline wrote them; others need --overwrite.";

std::string version_text() {
  std::string text = fmt::format("ridgeline {} ({})\n", results::kVersion, results::kGitHash);
  const nlohmann::ordered_json all = results::versions();
  for (const auto& [library, version] : all.items()) {
    if (library == "ridgeline" || library == "git_hash") continue;
    text += fmt::format("  {} {}\n", library, version.get<std::string>());
  }
  return text;
}

struct GlobalOptions {
  int jobs = 0;
  bool quiet = false;
  std::string log_level = "info";
};

void add_global_options(CLI::App& app, GlobalOptions& options) {
  app.fallthrough();
  app.require_subcommand(1);
  app.set_version_flag("--version", version_text);
  app.add_option("--jobs", options.jobs, "number of threads; 0: all; results do not depend on it")
      ->check(CLI::Range(0, 1024))
      ->option_text("N=0");
  app.add_flag("--quiet", options.quiet, "print only errors on stderr");
  app.add_option("--log-level", options.log_level, "log level: debug, info, warning or error")
      ->check(CLI::IsMember({"debug", "info", "warning", "error"}))
      ->option_text("LEVEL=info")
      ->group("");  // most users only need --quiet, and without it the help fits one screen
}

/// The log message, with option names of the libraries replaced by flags.
class MessageWithFlags : public spdlog::custom_flag_formatter {
 public:
  void format(const spdlog::details::log_msg& message,
              const std::tm& /*time*/,
              spdlog::memory_buf_t& out) override {
    const std::string text = as_flags({message.payload.data(), message.payload.size()});
    out.append(text.data(), text.data() + text.size());
  }
  [[nodiscard]] std::unique_ptr<spdlog::custom_flag_formatter> clone() const override {
    return std::make_unique<MessageWithFlags>();
  }
};

void set_up_log(const GlobalOptions& options) {
  auto log = spdlog::stderr_color_mt("ridgeline");
  auto formatter = std::make_unique<spdlog::pattern_formatter>();
  formatter->add_flag<MessageWithFlags>('*').set_pattern("%^%l%$: %*");
  log->set_formatter(std::move(formatter));
  log->set_level(options.quiet ? spdlog::level::err : spdlog::level::from_str(options.log_level));
  spdlog::set_default_logger(log);
}

/// Some messages of libraries contain line breaks; scripts read one line.
int fail(std::string message, ExitCode code) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  fmt::print(stderr, "ridgeline: {}\n", as_flags(message));
  return code;
}

/// The words that a user may have meant: the options of the given subcommand and the global ones;
/// without a subcommand, also the commands.
std::vector<std::string> known_words(const CLI::App& app) {
  std::vector<std::string> words;
  const std::vector<CLI::App*> given = app.get_subcommands();
  for (const CLI::App* parent :
       std::array<const CLI::App*, 2>{given.empty() ? &app : given.front(), &app}) {
    for (const CLI::Option* option : parent->get_options()) {
      for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
    }
  }
  if (given.empty()) {
    for (const Command& command : kCommands) words.emplace_back(command.name);
  }
  return words;
}

/// CLI11 reports a missing option before an unknown word. Report the unknown word instead, because
/// it is often the missing option, misspelled.
std::string usage_message(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<CLI::App*> given = app.get_subcommands();
  const std::string help =
      fmt::format("see ridgeline {}--help", given.empty() ? "" : given.front()->get_name() + " ");
  const std::vector<std::string> unknown = app.remaining(true);
  if (unknown.empty()) return fmt::format("{} ({})", error.what(), help);
  const std::vector<std::string> words = known_words(app);
  const std::string_view nearest = io::nearest_name(unknown.front(), {words.begin(), words.end()});
  return fmt::format("unknown argument {}, did you mean {}? ({})", fmt::join(unknown, " "), nearest,
                     help);
}

std::string footer_of(const Command& command, bool writes) {
  return fmt::format("{}Examples:\n{}", writes ? fmt::format("{}\n\n", kOutputRules) : "",
                     command.examples);
}

/// Answers --help and --version.
int print_answer(const CLI::App& app, const CLI::ParseError& error) {
  std::ostringstream text;
  const int code = app.exit(error, text, std::cerr);
  std::string answer = text.str();
  if (answer.ends_with("\n\n")) answer.pop_back();
  if (const std::size_t gap = answer.find("\n\nOptions:"); gap != answer.npos)
    answer.erase(gap, 1);  // the help then fits one screen
  fmt::print("{}", answer);
  return code;
}

int parse_and_run(CLI::App& app, int argc, char** argv) {
  GlobalOptions global;
  add_global_options(app, global);
  std::optional<Run> chosen;
  for (const Command& command : kCommands) {
    CLI::App* subcommand = app.add_subcommand(command.name, command.summary);
    const Run run = command.add(*subcommand);
    subcommand->footer(footer_of(command, subcommand->get_option_no_throw("--out") != nullptr));
    subcommand->callback([&chosen, run] { chosen = run; });
  }
  app.get_help_ptr()->group(
      "");  // readers of the help already know it, and its line would need a second screen
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return print_answer(app, error);
    return fail(usage_message(app, error), kWrongInput);
  }
  set_up_log(global);
  const int threads = global.jobs > 0 ? global.jobs : tbb::info::default_concurrency();
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(threads));
  return (*chosen)();
}

int guarded_main(int argc, char** argv) {
  CLI::App app("Reconstructs 3D lines from oriented aerial images and judges lines against LIDAR",
               "ridgeline");
  try {
    return parse_and_run(app, argc, argv);
  } catch (const io::IoError& error) {
    return fail(error.what(), kWrongInput);
  } catch (const std::invalid_argument& error) {
    return fail(error.what(), kWrongInput);
  } catch (const std::filesystem::filesystem_error& error) {  // permissions, a vanished file
    return fail(fmt::format("{}: {}", error.path1().string(), error.code().message()), kWrongInput);
  } catch (const std::exception& error) {
    return fail(fmt::format("internal error: {}", error.what()), kInternalError);
  }
}

/// The number of a closed stream would be reused for the next file opened, and output would go
/// there.
void open_standard_streams() {
  for (const auto& [stream, device] :
       {std::pair(STDIN_FILENO, "/dev/null"), std::pair(STDOUT_FILENO, "/dev/full"),
        std::pair(STDERR_FILENO, "/dev/null")}) {
    if (fcntl(stream, F_GETFD) == -1) open(device, O_RDWR);
  }
}

/// Buffers the output until the results are complete, so that a reader that exits early does not
/// interrupt the work.
void hold_back_stdout() {
  static std::array<char, std::size_t{1} << 20U> buffer;  // without it glibc ignores the size
  std::signal(SIGPIPE, SIG_IGN);
  if (isatty(STDOUT_FILENO) == 0) std::setvbuf(stdout, buffer.data(), _IOFBF, buffer.size());
}

/// A reader that closes its end early, such as `head`, is not an error.
int end_of_stdout(int code) {
  if (std::fflush(stdout) == 0 || errno == EPIPE) return code;
  return fail(
      fmt::format("standard output: cannot be written: {}", std::generic_category().message(errno)),
      code == kDone ? kWrongInput : static_cast<ExitCode>(code));
}

}  // namespace
}  // namespace ridgeline::apps

// NOLINTNEXTLINE(bugprone-exception-escape): a failing handler may end the program
int main(int argc, char** argv) {
  ridgeline::apps::open_standard_streams();
  ridgeline::apps::hold_back_stdout();
  return ridgeline::apps::end_of_stdout(ridgeline::apps::guarded_main(argc, argv));
}
