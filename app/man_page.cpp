#include "man_page.h"

#include <algorithm>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "help_format.h"
#include "software_commit.h"
#include "verb_words.h"

namespace facenav::app {
namespace fs = std::filesystem;
namespace {

/// Text of a roff page: no character of it is a command. Line breaks stay.
std::string plain(const std::string& text) {
  std::string out;
  bool begins_line = true;
  for (const char c : text) {
    if (begins_line && (c == '.' || c == '\'')) out += "\\&";
    out += c == '\\' ? std::string("\\e") : c == '-' ? std::string("\\-") : std::string(1, c);
    begins_line = c == '\n';
  }
  return out;
}

std::string pageName(const std::string& words) {
  std::string name = words;
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

std::string entry(const std::string& name, const std::string& explanation) {
  return ".TP\n.B " + plain(name) + "\n" + plain(explanation.empty() ? "see above" : explanation) + "\n";
}

std::string optionsOf(const CLI::App& verb, bool is_positional) {
  const HelpFormat format;
  std::string out;
  for (const CLI::Option* option : verb.get_options())
    if (option->get_positional() == is_positional && !option->get_group().empty())
      out += entry(format.make_option_name(option, is_positional) + format.make_option_opts(option),
                   option->get_description());
  return out;
}

std::string usageOf(const NamedVerb& named) {
  std::string words = named.words;
  for (const CLI::Option* option : named.verb->get_options())
    if (option->get_positional())
      words += option->get_required() ? " " + option->get_name(true) : " [" + option->get_name(true) + "]";
  return words + (verbsBelow(*named.verb).empty() ? " [OPTIONS]" : " [OPTIONS] [VERB ..]");
}

std::string section(const std::string& title, const std::string& text) {
  return text.empty() ? std::string() : ".SH " + title + "\n" + text;
}

std::string pageOf(const NamedVerb& named) {
  const CLI::App& verb = *named.verb;
  const std::string description = verb.get_description();
  std::string page = ".TH \"" + pageName(named.words) + "\" 1 \"\" \"FaceNav " + versionInWords() + "\"\n";
  page += section("NAME", plain(pageName(named.words)) + " \\- " +
                              plain(description.substr(0, description.find('\n'))) + "\n");
  page += section("SYNOPSIS", ".B " + plain(usageOf(named)) + "\n");
  page += section("DESCRIPTION", plain(description) + "\n");
  page += section("ARGUMENTS", optionsOf(verb, true));
  page += section("OPTIONS", optionsOf(verb, false));
  std::string below, see = named.words.find(' ') == std::string::npos ? "" : ".BR facenav (1)\n";
  for (const CLI::App* each : verbsBelow(verb)) {
    below += entry(each->get_name(), each->get_description());
    see += ".BR " + plain(pageName(named.words + " " + each->get_name())) + " (1)\n";
  }
  page += section("VERBS", below);
  page += section("NOTES", verb.get_footer().empty() ? std::string() : plain(verb.get_footer()) + "\n");
  page += section("EXIT STATUS", "0 done, 1 failed, 2 wrong usage.\n");
  return page + section("SEE ALSO", see);
}

int writePages(const NamedVerb& named, const fs::path& folder) {
  writeWholeFile(folder / (pageName(named.words) + ".1"), pageOf(named), FileAccess::by_umask);
  int pages = 1;
  for (const CLI::App* below : verbsBelow(*named.verb))
    pages += writePages({below, named.words + " " + below->get_name()}, folder);
  return pages;
}

}  // namespace

int writeManPages(const CLI::App& program, const fs::path& folder) {
  std::error_code fault;
  fs::create_directories(folder, fault);
  if (fault)
    throw Error("cannot be made (" + fault.message() + ")", folder.string(), "choose another folder");
  return writePages({&program, program.get_name()}, folder);
}

}  // namespace facenav::app
