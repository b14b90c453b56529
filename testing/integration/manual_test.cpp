// The manual's site, as `./facenav.sh manual` makes it without pictures: its links, its list of pages, its
// search, and that it names every refusal of the code.

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "support/run_program.h"

namespace facenav::testing {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = FACENAV_SOURCE_DIR;

/// The site, made once for all tests; empty where the generator is not installed.
const fs::path& site() {
  static const TemporaryFolder kFolder;
  static const fs::path kSite = [] {
    if (std::system("/usr/bin/python3 -c 'import sphinx, myst_parser' 2>/dev/null") != 0) return fs::path();
    const auto made = runProgram((kSource / "resources/manual/make_manual.py").string(),
                                 "'" + (kFolder.path() / "made").string() + "'");
    EXPECT_EQ(made.status, 0) << made.output << made.errors;
    return kFolder.path() / "made" / "html";
  }();
  return kSite;
}

class ManualSite : public ::testing::Test {
 protected:
  void SetUp() override {
    if (site().empty()) GTEST_SKIP() << "python3-sphinx and python3-myst-parser are not installed";
  }
  static std::string pageOf(const fs::path& markdown) {
    return markdown.stem() == "README" ? "index" : markdown.stem().string();
  }
  static std::vector<fs::path> sources() {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(kSource / "resources" / "doc"))
      if (entry.path().extension() == ".md") found.push_back(entry.path());
    return found;
  }
};

std::vector<std::string> matches(const std::string& text, const std::regex& expression) {
  std::vector<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), expression), end; at != end; ++at)
    found.push_back((*at)[1]);
  return found;
}

TEST_F(ManualSite, EveryLinkLeadsToAPageAndAPlaceOfIt) {
  static const std::regex kLink(R"((?:href|src)=\"([^\"]+)\")"), kPlace(R"(id=\"([^\"]+)\")");
  std::map<std::string, std::set<std::string>> places;
  std::map<std::string, std::vector<std::string>> links;
  for (const auto& entry : fs::directory_iterator(site())) {
    if (entry.path().extension() != ".html") continue;
    const auto text = readText(entry.path());
    const auto ids = matches(text, kPlace);
    places[entry.path().filename().string()] = {ids.begin(), ids.end()};
    links[entry.path().filename().string()] = matches(text, kLink);
  }
  int followed = 0;
  for (const auto& [page, all] : links)
    for (std::string link : all) {
      EXPECT_EQ(link.find("http"), std::string::npos) << page << ": " << link << ": it needs a network";
      const auto hash = link.find('#');
      const std::string file = hash == 0 ? page : link.substr(0, std::min(hash, link.find('?')));
      EXPECT_TRUE(fs::exists(site() / file)) << page << ": " << link;
      if (hash == std::string::npos || hash + 1 == link.size()) continue;
      ++followed;
      EXPECT_TRUE(places[file].count(link.substr(hash + 1))) << page << ": " << link;
    }
  EXPECT_GT(followed, 100);
}

TEST_F(ManualSite, EveryPageIsInTheListOfPages) {
  const auto index = readText(site() / "index.html");
  for (const auto& source : sources())
    if (pageOf(source) != "index") {
      EXPECT_NE(index.find("class=\"reference internal\" href=\"" + pageOf(source) + ".html\""),
                std::string::npos)
          << source;
    }
}

TEST_F(ManualSite, TheSearchFindsWordsOfEveryPage) {
  const std::string script = readText(site() / "searchindex.js"), begin = "Search.setIndex(";
  ASSERT_EQ(script.rfind(begin, 0), 0u);
  const auto index = nlohmann::json::parse(script.substr(begin.size(), script.rfind(')') - begin.size()));
  std::map<int, int> words;
  for (const auto& [word, pages] : index["terms"].items())
    for (const auto& page : pages.is_array() ? pages : nlohmann::json::array({pages}))
      ++words[page.get<int>()];
  std::set<std::string> searched;
  for (std::size_t i = 0; i < index["docnames"].size(); ++i) {
    searched.insert(index["docnames"][i].get<std::string>());
    EXPECT_GT(words[int(i)], 40) << index["docnames"][i];
  }
  for (const auto& source : sources()) EXPECT_TRUE(searched.count(pageOf(source))) << source;
}

TEST_F(ManualSite, ItNamesNoPathOfThisMachine) {
  for (const auto& entry : fs::recursive_directory_iterator(site())) {
    if (!entry.is_regular_file()) continue;
    const auto text = readText(entry.path());
    for (const auto& folder : {kSource, site().parent_path()})
      EXPECT_EQ(text.find(folder.string()), std::string::npos) << entry.path();
  }
}

/// The page of messages holds what the code throws: messages of three kinds of places, and most of their
/// number.
TEST_F(ManualSite, ThePageOfMessagesHoldsEveryRefusalOfTheCode) {
  const auto page = readText(site() / "messages.html");
  for (const char* words : {"not aligned: the face does not fit this MRI",  // by a function of the same file
                            "the face landmark model cannot be read",       // thrown
                            "one camera stands in front of the other", "holds no DICOM images"})  // returned
    EXPECT_NE(page.find(words), std::string::npos) << words;
  EXPECT_GT(matches(page, std::regex("(<tr )")).size(), 700u);
}

}  // namespace
}  // namespace facenav::testing
