#pragma once
// Formats --help: no line is longer than 80 columns, and the verbs are grouped.

#include <CLI/CLI.hpp>

namespace facenav::app {

/// Wraps `text` into lines of at most `width` letters. It breaks at spaces, in a longer word after a comma or
/// a bracket, else anywhere. A line break in `text` stays. A line that begins with blanks keeps them; its
/// wrapped lines are indented by two more.
std::vector<std::string> wrappedLines(const std::string& text, std::size_t width);

class HelpFormat : public CLI::Formatter {
 public:
  HelpFormat();

  std::string make_usage(const CLI::App* app, std::string name) const override;
  std::string make_description(const CLI::App* app) const override;
  std::string make_subcommand(const CLI::App* verb) const override;
  std::string make_option(const CLI::Option* option, bool is_positional) const override;
  std::string make_option_opts(const CLI::Option* option) const override;
  std::string make_footer(const CLI::App* app) const override;
};

}  // namespace facenav::app
