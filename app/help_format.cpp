#include "help_format.h"

#include <sstream>

namespace facenav::app {
namespace {

constexpr std::size_t kWidth = 80, kOptionColumn = 28, kVerbColumn = 17;

/// Length of the part of an overlong word that fits on a line of `width`.
std::size_t fittingPart(const std::string& word, std::size_t width) {
  const std::size_t mark = word.find_last_of(",)]}/", width - 1);
  return mark == std::string::npos || mark == 0 ? width : mark + 1;
}

void appendWrapped(const std::string& line, std::size_t width, std::vector<std::string>& lines) {
  const std::size_t start = std::min(line.find_first_not_of(' '), line.size());
  std::string indent(std::min(start, width / 2), ' ');
  const std::string next_indent = indent.empty() ? "" : indent + "  ";
  std::string current = indent;
  std::istringstream words(line.substr(start));
  for (std::string word; words >> word;) {
    const bool is_first = current.size() == indent.size();
    if (!is_first && current.size() + 1 + word.size() <= width) {
      current += ' ' + word;
      continue;
    }
    if (!is_first) {
      lines.push_back(current);
      indent = next_indent;
    }
    for (current = indent + word; current.size() > width;) {
      const std::size_t part = fittingPart(current, width);
      lines.push_back(current.substr(0, part));
      indent = next_indent;
      current = indent + current.substr(part);
    }
  }
  lines.push_back(current);
}

/// Wraps `text` and indents each line but the first.
std::string paragraph(const std::string& text, std::size_t indent = 0) {
  std::string out;
  for (const std::string& line : wrappedLines(text, kWidth - indent))
    out += (out.empty() ? "" : std::string(indent, ' ')) + line + '\n';
  return out;
}

/// Formats a name with its explanation from `column` on; a name that is too long gets its own line.
std::string twoColumns(const std::string& name, const std::string& explanation, std::size_t column) {
  std::string out;
  auto left = wrappedLines(name, kWidth - 6);
  for (std::size_t i = 0; i < left.size(); ++i) out += std::string(i == 0 ? 2 : 6, ' ') + left[i] + '\n';
  if (explanation.empty()) return out;
  if (left.size() == 1 && left.front().size() + 3 <= column) {
    out.pop_back();
    out.append(column - out.size(), ' ');
  } else {
    out.append(column, ' ');
  }
  return out + paragraph(explanation, column);
}

void replaceAll(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
}

}  // namespace

std::vector<std::string> wrappedLines(const std::string& text, std::size_t width) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) appendWrapped(line, width, lines);
  return lines;
}

HelpFormat::HelpFormat() {
  column_width(kOptionColumn);
  label("SUBCOMMAND", "VERB");
}

std::string HelpFormat::make_usage(const CLI::App* app, std::string name) const {
  return paragraph(Formatter::make_usage(app, std::move(name)), 7);
}

std::string HelpFormat::make_description(const CLI::App* app) const {
  return paragraph(Formatter::make_description(app));
}

std::string HelpFormat::make_subcommand(const CLI::App* verb) const {
  return twoColumns(verb->get_display_name(true), verb->get_description(), kVerbColumn);
}

std::string HelpFormat::make_option(const CLI::Option* option, bool is_positional) const {
  return twoColumns(make_option_name(option, is_positional) + make_option_opts(option),
                    make_option_desc(option), get_column_width());
}

std::string HelpFormat::make_option_opts(const CLI::Option* option) const {
  // CLI11 names both the type and the check of its range: "FLOAT:FLOAT in [0 - 1]".
  std::string text = Formatter::make_option_opts(option);
  for (const char* type : {"FLOAT", "INT", "UINT"})
    for (const char* range : {":FLOAT in", ":INT in", ":UINT in"})
      replaceAll(text, std::string(type) + range, std::string(type) + " in");
  for (const char* check : {"{", "DIR", "FILE"}) replaceAll(text, std::string("TEXT:") + check, check);
  return text;
}

std::string HelpFormat::make_footer(const CLI::App* app) const { return paragraph(app->get_footer()); }

}  // namespace facenav::app
