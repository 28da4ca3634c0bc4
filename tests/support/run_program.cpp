// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/run_program.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <system_error>

namespace ridgeline::test {
namespace {

constexpr int kNotStarted = 127;

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
/// A file without a name that is gone once it is closed. Unlike a pipe it never fills up and blocks
/// the child.
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

/// The variables of this process, and those given in place of them.
std::vector<std::string> with_variables(const std::vector<std::string>& given) {
  std::vector<std::string> all = given;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string_view name_and_equals(*variable, std::string_view(*variable).find('=') + 1);
    const bool is_given = std::ranges::any_of(
        given, [&](const std::string& one) { return one.starts_with(name_and_equals); });
    if (!is_given) all.emplace_back(*variable);
  }
  return all;
}

/// What execve() takes. The texts must outlive it.
std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// Nothing here may take a lock, as memory does: another thread may have held it during the fork,
/// and is not there to give it back.
[[noreturn]] void become(char* const* argv,
                         char* const* variables,
                         const char* folder,
                         int out,
                         int err,
                         unsigned processor_limit_s) {
  const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
  dup2(nothing, STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(err, STDERR_FILENO);
  if (processor_limit_s > 0) {         // of the program as well: execve() keeps limits
    constexpr unsigned kOfClock = 20;  // for a program that waits for ever
    alarm(kOfClock * processor_limit_s);
    const rlimit limit{processor_limit_s, RLIM_INFINITY};
    if (setrlimit(RLIMIT_CPU, &limit) != 0) _exit(kNotStarted);
  }
  if (chdir(folder) == 0) execve(argv[0], argv, variables);
  _exit(kNotStarted);
}

double seconds_of(const timeval& time) {
  constexpr double kMicro = 1e-6;
  return static_cast<double>(time.tv_sec) + kMicro * static_cast<double>(time.tv_usec);
}

void wait_for(pid_t child, ProgramResult& result) {
  int status = 0;
  rusage usage{};
  while (wait4(child, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  constexpr int kSignalBase = 128;
  constexpr double kKibInMib = 1024.0;
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : kSignalBase + WTERMSIG(status);
  result.peak_memory_mib = static_cast<double>(usage.ru_maxrss) / kKibInMib;
  result.processor_s = seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
}

}  // namespace

ProgramResult run_program(const std::string& program,
                          const std::vector<std::string>& arguments,
                          const std::filesystem::path& folder,
                          const std::vector<std::string>& environment,
                          unsigned processor_limit_s) {
  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> variables = with_variables(environment);
  const std::vector<char*> argv = pointers_to(words);
  const std::vector<char*> envp = pointers_to(variables);

  const CaptureFile out = capture_file();
  const CaptureFile err = capture_file();
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) {
    become(argv.data(), envp.data(), folder.c_str(), fileno(out.get()), fileno(err.get()),
           processor_limit_s);
  }
  ProgramResult result;
  wait_for(child, result);
  if (result.exit_code == kNotStarted) {
    throw std::system_error(ENOEXEC, std::generic_category(), program);
  }
  result.out = content_of(out.get());
  result.err = content_of(err.get());
  return result;
}

}  // namespace ridgeline::test
