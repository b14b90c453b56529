#include "facenav/core/error.h"

#include <algorithm>

#include "facenav/core/shown_address.h"

namespace facenav {
inline namespace core {
namespace {

std::string oneLine(const std::string& happened, const std::string& where, const std::string& remedy) {
  std::string line = happened;
  if (!where.empty()) line = where + ": " + line;
  if (!remedy.empty()) line += "; " + remedy;
  std::replace_if(
      line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
  return line;
}

}  // namespace

Error::Error(const std::string& what_happened, const std::string& where, const std::string& remedy)
    : std::runtime_error(shownAddress(oneLine(what_happened, where, remedy))) {}

void expectationFailed(const char* condition, const char* file, int line, const std::string& message) {
  throw std::logic_error(std::string("internal error (please report): ") + message + " [" + condition + ", " +
                         file + ":" + std::to_string(line) + "]");
}

}  // namespace core
}  // namespace facenav
