// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/run_program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <system_error>

namespace ridgeline::test {
namespace {

constexpr int kNotStarted = 127;

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
/// Nameless and gone at the end. A file in place of a pipe: it never fills up and blocks the child.
using CaptureFile = std::unique_ptr<std::FILE, CloseFile>;

CaptureFile capture_file() {
  CaptureFile file(std::tmpfile());
  if (!file) throw std::system_error(errno, std::generic_category(), "tmpfile");
  return file;
}

std::string content_of(std::FILE* file) {
  std::rewind(file);
  std::string content;
  for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) {
    content += static_cast<char>(c);
  }
  return content;
}

[[noreturn]] void become(std::vector<char*>& argv,
                         const char* folder,
                         std::vector<std::string>& environment,
                         int out,
                         int err) {
  const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
  dup2(nothing, STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(err, STDERR_FILENO);
  for (std::string& variable : environment) putenv(variable.data());
  if (chdir(folder) == 0) execv(argv.front(), argv.data());
  _exit(kNotStarted);
}

int exit_code_of(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  constexpr int kSignalBase = 128;
  return WIFEXITED(status) ? WEXITSTATUS(status) : kSignalBase + WTERMSIG(status);
}

}  // namespace

ProgramResult run_program(const std::string& program,
                          const std::vector<std::string>& arguments,
                          const std::filesystem::path& folder,
                          const std::vector<std::string>& environment) {
  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  std::vector<std::string> variables = environment;

  const CaptureFile out = capture_file();
  const CaptureFile err = capture_file();
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) {
    become(argv, folder.c_str(), variables, fileno(out.get()), fileno(err.get()));
  }
  ProgramResult result;
  result.exit_code = exit_code_of(child);
  if (result.exit_code == kNotStarted) {
    throw std::system_error(ENOEXEC, std::generic_category(), program);
  }
  result.out = content_of(out.get());
  result.err = content_of(err.get());
  return result;
}

}  // namespace ridgeline::test
