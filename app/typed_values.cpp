#include "typed_values.h"

#include <filesystem>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/plain_words.h"

namespace facenav::app {
namespace {

std::string shortened(const std::string& text) {
  return text.size() <= 40 ? text : text.substr(0, 40) + "..";
}

std::string faultOfNumber(const std::string& typed) {
  return numberIn(typed) ? std::string() : "'" + shortened(typed) + "' is no number that can be used";
}

std::string faultOfText(const std::string& typed, Lines lines) {
  const std::string fault = faultOfWords(typed, kLongestNote, lines);
  return fault.empty() ? fault : "the text " + fault;
}

/// A device or a pipe is refused at once, not after the work.
std::string faultOfOutput(const std::string& typed) {
  namespace fs = std::filesystem;
  std::error_code fault;
  const auto status = fs::status(typed, fault);
  const bool is_replaceable = !fs::exists(status) || fs::is_regular_file(status) || fs::is_directory(status);
  return is_replaceable ? std::string()
                        : typed +
                              " is neither a file nor a folder, and is not replaced; '-o -' writes a file "
                              "to standard output";
}

bool startsWith(const std::string& text, const std::string& start) { return text.rfind(start, 0) == 0; }

/// Returns true for options that take what people write at length.
bool takesLines(const CLI::Option& option) {
  for (const char* name : {"note", "adverse-event", "reason", "override"})
    if (option.check_lname(name)) return true;
  return false;
}

void check(CLI::Option& option) {
  const std::string type = option.get_type_name();
  if (option.get_expected_max() == 0 || type.empty()) return;  // a flag
  const bool is_number = startsWith(type, "FLOAT") || startsWith(type, "INT") || startsWith(type, "UINT");
  const Lines lines = takesLines(option) ? Lines::many : Lines::one;
  if (option.check_sname("o")) option.check(CLI::Validator(faultOfOutput, ""));
  option.check(CLI::Validator(
      [is_number, lines](std::string& typed) {
        return is_number ? faultOfNumber(typed) : faultOfText(typed, lines);
      },
      ""));
}

}  // namespace

CLI::Validator understoodBy(std::function<void(const std::string&)> read) {
  return CLI::Validator(
      [read = std::move(read)](std::string& typed) -> std::string {
        try {
          read(typed);
        } catch (const Error& error) {
          return error.what();
        }
        return {};
      },
      "");
}

CLI::Validator folderToMake() {
  return CLI::Validator(
      [](std::string& typed) {
        return typed == "-" ? std::string("a folder cannot be written to standard output") : std::string();
      },
      "");
}

bool asksForStandardOutput(const std::vector<std::string>& words) {
  for (const std::string option :
       {"-o", "--output", "--picture", "--slices", "--projected", "--protocol-template"})
    for (std::size_t i = 0; i < words.size(); ++i) {
      const bool is_next = words[i] == option && i + 1 < words.size() && words[i + 1] == "-";
      if (is_next || words[i] == option + "=-" || words[i] == "-o-") return true;
    }
  return false;
}

void checkTypedValues(CLI::App& program) {
  for (CLI::Option* option : program.get_options()) check(*option);
  for (CLI::App* verb : program.get_subcommands([](CLI::App*) { return true; })) checkTypedValues(*verb);
}

}  // namespace facenav::app
