// Checks that the window's languages are complete: every text of the window and every sentence of the modules
// is in each catalogue, translated, with the same values, and the window marks what it shows.
// resources/languages/check.py finds the faults.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "support/run_program.h"

namespace facenav {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = FACENAV_SOURCE_DIR;

testing::CommandResult check(const fs::path& root) {
  const std::string script = (root / "resources/languages/check.py").string();
  return testing::runProgram("/usr/bin/python3", "-B '" + script + "'");
}

void write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

TEST(Languages, AreCompleteAndTheWindowMarksItsTexts) {
  const auto found = check(kRoot);
  EXPECT_EQ(found.status, 0) << found.output << found.errors
                             << "\nrun resources/languages/update.py, and translate what is new";
}

// A small tree with one fault of each kind: the check is not blind.
TEST(Languages, EachKindOfFaultIsFound) {
  const testing::TemporaryFolder folder;
  const fs::path& root = folder.path();
  for (const char* script : {"core_sentences.py", "update.py", "check.py"}) {
    const fs::path place = fs::path("resources/languages") / script;
    fs::create_directories((root / place).parent_path());
    fs::copy_file(kRoot / place, root / place);
  }
  write(root / "ui/page.cpp", R"(namespace facenav::ui {
class Page : public QWidget {
  Q_OBJECT
  void fill();
};
void Page::fill() {
  button_->setText("press it here");
  label_->setText(tr("%1 of %2 pulses").arg(1).arg(2));
  label_->setToolTip(tr("all pulses"));
  label_->setText(tr(words_.name));
}
})");
  write(root / "app/gui_main.cpp", "");
  write(root / "modules/rig/words.cpp",
        R"(std::string words(double mm) { return "the head moved by " + fixed(mm, 1) + " mm"; })");
  write(root / "resources/languages/facenav_xx.ts", R"(<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja">
<context><name>facenav::ui::Page</name>
<message><source>%1 of %2 pulses</source><translation>P %1</translation></message>
<message><source>gone</source><translation>G</translation></message>
</context>
</TS>)");
  const auto found = check(root);
  EXPECT_EQ(found.status, 1) << found.errors;
  for (const char* fault :
       {"ui/page.cpp shows a text without tr(): press it here",
        "ui/page.cpp gives tr() a value, use shownWords or QT_TRANSLATE_NOOP: words_.name",
        "facenav_xx.ts lacks, in facenav::ui::Page: all pulses",
        "facenav_xx.ts lacks, in core: the head moved by %1 mm",
        "facenav_xx.ts has an unused text, in facenav::ui::Page: gone",
        "facenav_xx.ts has other values, in facenav::ui::Page: %1 of %2 pulses -> P %1"})
    EXPECT_NE(found.output.find(fault), std::string::npos) << fault << "\nis missing in:\n" << found.output;
}

// What an exception says is English. It is logged, or kept for a place that translates it, or shown by a
// function that does.
TEST(Languages, TheWindowShowsNoExceptionInEnglish) {
  const std::vector<std::string> right{"shownWords(", "inWindowWords(", "logWarning(",
                                       "failure = ",  "failure_ = ",    "throw Error("};
  int seen = 0;
  for (const auto& entry : fs::recursive_directory_iterator(kRoot / "ui")) {
    std::ifstream source(entry.path());
    for (std::string line; entry.is_regular_file() && std::getline(source, line);) {
      if (line.find("what()") == std::string::npos) continue;
      ++seen;
      EXPECT_TRUE(std::any_of(right.begin(), right.end(),
                              [&](const auto& each) { return line.find(each) != std::string::npos; }))
          << entry.path() << ": " << line;
    }
  }
  EXPECT_GT(seen, 8);
}

}  // namespace
}  // namespace facenav
