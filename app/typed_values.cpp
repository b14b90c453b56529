#include "typed_values.h"

#include <algorithm>
#include <filesystem>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/plain_words.h"

namespace facenav::app {
namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

std::string shortened(const std::string& text) {
  return text.size() <= 40 ? text : text.substr(0, 40) + "..";
}

std::string faultOfNumber(const std::string& typed) {
  if (numberIn(typed)) return {};
  std::string with_point = typed;
  std::replace(with_point.begin(), with_point.end(), ',', '.');
  const bool is_comma = with_point != typed && numberIn(with_point);
  return "'" + shortened(typed) + "' is no number that can be used" +
         (is_comma ? "; write " + with_point : "");
}

/// Empty where a script's variable was not set. Where nothing is a value, it takes something back.
std::string faultOfText(const std::string& typed, Lines lines, bool may_be_empty) {
  if (typed.empty() && !may_be_empty) return "the text is empty: give one, or leave the option out";
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

bool isNamed(const CLI::Option& option, std::initializer_list<const char*> names) {
  return std::any_of(names.begin(), names.end(), [&](const char* name) { return option.check_name(name); });
}

void check(CLI::Option& option) {
  const std::string type = option.get_type_name();
  if (option.get_expected_max() == 0 || type.empty()) return;  // a flag
  const bool is_number = startsWith(type, "FLOAT") || startsWith(type, "INT") || startsWith(type, "UINT");
  // What people write at length, and what may be taken back by nothing.
  const bool is_prose = isNamed(option, {"--note", "--adverse-event", "--reason", "--override"});
  const bool may_be_empty = isNamed(option, {"--note", "--session", "LABEL", "--unit"});
  const Lines lines = is_prose ? Lines::many : Lines::one;
  if (isNamed(option, {"--picture", "--slices", "--projected"})) option.check(namedLike({".png"}, "picture"));
  if (option.check_sname("o")) option.check(CLI::Validator(faultOfOutput, ""));
  // The first of the option's checks: a range would call "3,5" too large.
  option.transform(CLI::Validator(
      [=](std::string& typed) {
        return is_number ? faultOfNumber(typed) : faultOfText(typed, lines, may_be_empty);
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

CLI::Validator namedLike(const std::vector<std::string>& endings, const std::string& what) {
  return CLI::Validator(
      [=](std::string& typed) -> std::string {
        namespace fs = std::filesystem;
        std::error_code ignored;
        const bool is_file =
            typed != "-" && (!fs::exists(typed, ignored) || fs::is_regular_file(typed, ignored));
        const std::string ending = lower(fs::path(typed).extension());
        if (!is_file || std::count(endings.begin(), endings.end(), ending) > 0) return {};
        return "'" + shortened(typed) + "' is no name of a " + what + "; write " + endings.front();
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
