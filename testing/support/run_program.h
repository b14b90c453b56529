#pragma once
// Runs a program as a user does and returns its exit status and both outputs.

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "support/test_data.h"

namespace facenav::testing {

struct CommandResult {
  int status = -1;  // exit status; 128 + signal if a signal killed it
  std::string output, errors;
};

inline std::string readText(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// `arguments`: as typed after the program's name; paths must be quoted by the caller.
inline CommandResult runProgram(const std::string& program, const std::string& arguments,
                                int timeout_s = 120) {
  const TemporaryFolder folder;
  const auto out = folder.path() / "out", err = folder.path() / "err";
  const std::string command = "timeout " + std::to_string(timeout_s) + " '" + program + "' " + arguments +
                              " >'" + out.string() + "' 2>'" + err.string() + "' </dev/null";
  const int raw = std::system(command.c_str());
  CommandResult result;
  result.status = WIFEXITED(raw) ? WEXITSTATUS(raw) : 128 + WTERMSIG(raw);
  result.output = readText(out);
  result.errors = readText(err);
  return result;
}

}  // namespace facenav::testing
