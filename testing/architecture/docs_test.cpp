// The manual as a test: each verb has its page, each command that a page shows is understood, each link leads
// to a file and a heading.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "support/command_line.h"

namespace facenav::testing {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = FACENAV_SOURCE_DIR;
const fs::path kManual = kRoot / "resources" / "doc";

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<fs::path> pages() {
  std::vector<fs::path> found{kRoot / "README.md", kRoot / "modules" / "README.md"};
  for (const auto& entry : fs::directory_iterator(kManual))
    if (entry.path().extension() == ".md") found.push_back(entry.path());
  return found;
}

/// Help of each verb under its words, "facenav rig new", as the program prints it.
const std::map<std::string, std::string>& helpOfVerbs() {
  static const auto all = [] {
    std::map<std::string, std::string> help;
    std::string words;
    for (const auto& line : linesOf(runFacenav("help --all").output)) {
      if (line.rfind("-- ", 0) == 0)
        help[words = line.substr(3)];
      else
        help[words] += line + "\n";
    }
    return help;
  }();
  return all;
}

std::set<std::string> verbs() {
  std::set<std::string> found;
  for (const auto& [words, ignored] : helpOfVerbs())
    if (std::count(words.begin(), words.end(), ' ') == 1) found.insert(words.substr(words.find(' ') + 1));
  return found;
}

/// Matches of the expression's first group, in order.
std::vector<std::string> matches(const std::string& text, const std::regex& expression) {
  std::vector<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), expression), end; at != end; ++at)
    found.push_back((*at)[1]);
  return found;
}

const std::regex kLink(R"(\]\(([^)\s]+)\))");

/// Rows of the manual's table of verbs: verb -> pages named in its row.
std::map<std::string, std::vector<std::string>> tableOfVerbs() {
  static const std::regex kRow(R"(^\| `facenav ([a-z-]+)` \|)");
  std::map<std::string, std::vector<std::string>> table;
  for (const auto& line : linesOf(readText(kManual / "README.md")))
    for (const auto& verb : matches(line, kRow)) table[verb] = matches(line, kLink);
  return table;
}

/// A heading's anchor, as GitHub makes it.
std::string anchorOf(const std::string& heading) {
  std::string anchor;
  for (const char c : heading) {
    if (std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_')
      anchor += char(std::tolower(static_cast<unsigned char>(c)));
    if (c == ' ') anchor += '-';
  }
  return anchor;
}

bool hasAnchor(const fs::path& page, const std::string& anchor) {
  for (const auto& line : linesOf(readText(page))) {
    const auto text = line.find_first_not_of('#');
    if (text == 0 || text == std::string::npos || line[text] != ' ') continue;
    if (anchorOf(line.substr(text + 1)) == anchor) return true;
  }
  return false;
}

/// Fault of a link of this page; empty if there is none.
std::string faultOf(const std::string& link, const fs::path& page) {
  if (link.find("://") != std::string::npos) return {};
  const auto hash = link.find('#');
  const fs::path file = hash == 0 ? page : page.parent_path() / link.substr(0, hash);
  if (!fs::exists(file)) return "no such file";
  if (hash == std::string::npos || hasAnchor(file, link.substr(hash + 1))) return {};
  return "no such heading";
}

/// Commands of the program in the page's blocks of code, without comments.
std::vector<std::string> commandsOf(const fs::path& page) {
  std::vector<std::string> commands;
  bool is_code = false;
  for (const auto& line : linesOf(readText(page))) {
    if (line.rfind("```", 0) == 0) is_code = !is_code;
    if (is_code && line.rfind("facenav ", 0) == 0) commands.push_back(line.substr(0, line.find(" #")));
  }
  return commands;
}

/// Longest verb that the command begins with; empty if there is none.
std::string verbOf(const std::string& command) {
  std::string known, words;
  std::istringstream stream(command);
  for (std::string word; stream >> word;) {
    words += (words.empty() ? "" : " ") + word;
    if (!helpOfVerbs().count(words)) break;
    known = words;
  }
  return known == "facenav" ? "" : known;
}

bool isOptionOf(const std::string& option, const std::string& verb) {
  return std::regex_search(helpOfVerbs().at(verb), std::regex("(^|[ ,])" + option + "([^a-z-]|$)"));
}

TEST(Manual, EveryVerbHasItsRowAndItsPage) {
  const auto table = tableOfVerbs();
  ASSERT_GT(verbs().size(), 30u);
  for (const auto& verb : verbs()) {
    ASSERT_TRUE(table.count(verb)) << verb << " is missing in resources/doc/README.md";
    for (const auto& page : table.at(verb)) {
      if (fs::path(page).extension() != ".md") continue;  // the verb's code
      EXPECT_NE(readText(kManual / page).find("facenav " + verb), std::string::npos)
          << page << " does not show " << verb;
    }
    EXPECT_GE(table.at(verb).size(), verb == "help" ? 1u : 2u) << verb << ": its page and its code";
  }
}

TEST(Manual, TheTableNamesNoOtherVerb) {
  for (const auto& [verb, ignored] : tableOfVerbs()) EXPECT_TRUE(verbs().count(verb)) << verb;
}

TEST(Manual, TheTableOfVerbsIsAlphabetical) {
  std::vector<std::string> rows =
      matches(readText(kManual / "README.md"), std::regex(R"(\n\| `facenav ([a-z-]+)` \|)"));
  EXPECT_TRUE(std::is_sorted(rows.begin(), rows.end()));
}

TEST(Manual, EveryCommandInItIsUnderstood) {
  static const std::regex kOption(R"((--[a-z][a-z0-9-]*))");
  int options = 0;
  for (const auto& page : pages())
    for (const auto& command : commandsOf(page)) {
      if (command.rfind("facenav  ", 0) == 0 || command.rfind("facenav VERB", 0) == 0) continue;
      const std::string verb = verbOf(command);
      ASSERT_NE(verb, "") << page << ": " << command;
      for (const auto& option : matches(command, kOption)) {
        ++options;
        EXPECT_TRUE(isOptionOf(option, verb)) << page << ": " << command << ": " << option;
      }
    }
  EXPECT_GT(options, 80);
}

TEST(Manual, EveryLinkLeadsToAFileAndAHeading) {
  for (const auto& page : pages())
    for (const auto& link : matches(readText(page), kLink))
      EXPECT_EQ(faultOf(link, page), "") << page << ": " << link;
}

/// Titles of the banners that withhold a pose: "CAMERAS MOVED: calibrate them again".
std::set<std::string> bannerTitles() {
  static const std::regex kTitle("\"([A-Z][A-Z' ]{3,}): [^\"]*[a-z%]");
  static const std::set<std::string> kGuidance{"ADJUST", "ALIGNING", "LOST",    "ON TARGET",
                                               "PAUSED", "READY",    "STARTING"};
  std::set<std::string> titles;
  for (const auto* folder : {"modules/treat", "modules/steps/treat", "ui/treat"})
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
      if (entry.path().extension() != ".cpp") continue;
      for (const auto& title : matches(readText(entry.path()), kTitle))
        if (!kGuidance.count(title)) titles.insert(title);
    }
  return titles;
}

TEST(Manual, EveryBannerHasItsCauseAndItsCure) {
  const auto page = readText(kManual / "messages.md");
  const auto titles = bannerTitles();
  EXPECT_GT(titles.size(), 25u);
  for (const auto& title : titles)
    EXPECT_TRUE(std::regex_search(page, std::regex("\\| \\*\\*" + title + "\\*\\* \\| [^|]+ \\| [^|]+ \\|")))
        << title << " is missing in resources/doc/messages.md";
}

/// A picture is named by the walk that makes it: JOB_LOOK_STEP, with _ in place of blanks.
TEST(Manual, EveryPictureThatAPageAsksForIsAStepOfAWalk) {
  static const std::regex kPicture("<!-- picture: (\\S+) .+ -->"), kStep("\"([a-z -]+)\",\\s+Page::");
  std::set<std::string> steps;
  for (const auto& entry : fs::directory_iterator(kRoot / "testing" / "walk"))
    if (entry.path().extension() == ".cpp")
      for (auto step : matches(readText(entry.path()), kStep)) {
        std::replace(step.begin(), step.end(), ' ', '_');
        steps.insert(step);
      }
  int asked = 0;
  for (const auto& page : pages())
    for (const auto& picture : matches(readText(page), kPicture)) {
      ++asked;
      const bool is_step = std::any_of(steps.begin(), steps.end(), [&](const std::string& step) {
        return picture.size() > step.size() && picture.substr(picture.size() - step.size() - 1) == "_" + step;
      });
      EXPECT_TRUE(is_step) << page << ": " << picture;
    }
  EXPECT_GE(asked, 12);
}

TEST(Manual, TheReadmeIsOneScreen) { EXPECT_LE(linesOf(readText(kRoot / "README.md")).size(), 70u); }

}  // namespace
}  // namespace facenav::testing
