// SPDX-License-Identifier: BSD-3-Clause
#include "tests/cli/cli_fixture.h"

#include "io/files/sha256.h"
#include "tests/support/paths.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace ridgeline::cli {
namespace fs = std::filesystem;
namespace {

fs::path scene_of_suite;

/// The patch of `SmallPatch`, in a folder `1`, as long as the program runs.
class Village {
 public:
  Village();
  Village(const Village&) = delete;
  Village& operator=(const Village&) = delete;
  ~Village() { fs::remove_all(folder_); }
  [[nodiscard]] fs::path patch() const { return folder_ / "1"; }

 private:
  fs::path folder_;
};

fs::path temporary_folder() {
  std::string pattern = (fs::temp_directory_path() / "ridgeline-cli-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
  return pattern;
}

Village::Village() : folder_(temporary_folder()) {
  const ProgramResult made =
      test::run_program(test::program(),
                        {"simulate", "--out", "1", "--seed", "2", "--extent-m", "48,48",
                         "--samples-per-side", "1", "--focal-length-px", "7000"},
                        folder_);
  EXPECT_EQ(made.exit_code, 0) << made.err;
}

}  // namespace

std::string read(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  EXPECT_TRUE(stream.is_open()) << file << " does not exist";
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void write(const fs::path& file, std::string_view content) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << content;
}

nlohmann::json read_json(const fs::path& file) {
  return nlohmann::json::parse(read(file), nullptr, false);
}

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

fs::path shared_data(std::string_view folder) { return fs::path(test::shared_data_dir()) / folder; }

testing::AssertionResult is_refusal(const ProgramResult& result) {
  const auto lines = std::count(result.err.begin(), result.err.end(), '\n');
  if (result.exit_code == 1 && lines == 1 && result.err.starts_with("ridgeline: ")) {
    return testing::AssertionSuccess();
  }
  return testing::AssertionFailure()
         << "exit code " << result.exit_code << ", stderr of " << lines << " lines: " << result.err;
}

Cli::Cli() : folder_(temporary_folder()) { fs::copy(scene_of_suite, folder_ / "scene"); }

Cli::~Cli() { fs::remove_all(folder_); }

void Cli::SetUpTestSuite() {
  scene_of_suite = temporary_folder();
  const ProgramResult result = test::run_program(
      test::program(),
      {"simulate", "--out", ".", "--seed", "3", "--extent-m", "60,60", "--no-images"},
      scene_of_suite);
  ASSERT_EQ(result.exit_code, 0) << result.err;
}

void Cli::TearDownTestSuite() { fs::remove_all(scene_of_suite); }

nlohmann::json Cli::data_of(const std::string& report) const {
  const std::string page = read(path(report));
  const std::string open = "id=\"report-data\">";
  const std::size_t begin = page.find(open) + open.size();
  return nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

SmallPatch::SmallPatch() {
  static const Village village;
  fs::copy(village.patch(), path("patch"));
}

void SmallPatch::edit_patch(std::string_view from, std::string_view to) const {
  std::string text = read(path("patch/patch.yaml"));
  const std::size_t at = text.find(from);
  ASSERT_NE(at, std::string::npos) << from << " is not in " << text;
  write(path("patch/patch.yaml"), text.replace(at, from.size(), to));
}

ProgramResult Cli::run(const std::vector<std::string>& arguments,
                       const std::vector<std::string>& environment) const {
  return test::run_program(test::program(), arguments, folder_, environment);
}

ProgramResult Cli::evaluate(const std::string& lines,
                            const std::string& out,
                            const std::vector<std::string>& more) const {
  std::vector<std::string> arguments{"evaluate",        "--lines", lines, "--cloud",
                                     "scene/lidar.las", "--out",   out};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run(arguments);
}

std::map<std::string, std::string> Cli::results_in(const std::string& folder) const {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(path(folder))) {
    if (!entry.is_regular_file() || entry.path().filename() == "run.json") continue;
    files[fs::relative(entry.path(), path(folder)).string()] =
        io::sha256_of_file(entry.path().string());
  }
  return files;
}

}  // namespace ridgeline::cli
