#include "json_lines.h"

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"

namespace facenav::casefile {

JsonLines readJsonLines(const std::filesystem::path& path) {
  JsonLines read;
  if (!std::filesystem::exists(path)) return read;
  const std::string content = readWholeFile(path);
  int number = 0;
  for (std::size_t begin = 0; begin < content.size();) {
    ++number;
    const std::string place = path.string() + ", line " + std::to_string(number);
    const std::size_t end = content.find('\n', begin);
    if (end == std::string::npos) {
      read.problems.push_back(place + ": the last line was cut short and is ignored");
      break;
    }
    if (end > begin) {
      try {
        read.lines.push_back(JsonReader::readText(content.substr(begin, end - begin), place));
      } catch (const Error&) {
        read.problems.push_back(place + ": the line is damaged and is ignored");
      }
    }
    begin = end + 1;
  }
  return read;
}

}  // namespace facenav::casefile
