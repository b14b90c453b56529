#pragma once
// Every page of the window, and a case that fills them: for tests that look at all of them.

#include <filesystem>
#include <functional>
#include <vector>

class QAbstractButton;
class QString;
class QWidget;

namespace facenav::ui {
class MainWindow;
}

namespace facenav::ui::fixtures {

struct Page {
  const char* name;
  std::function<void(MainWindow&)> show;
};

/// Lists the pages in the order of the clinic's path. The window needs an open case.
std::vector<Page> everyPage();

/// These pages, and the tools of Treat.
std::vector<Page> pagesAndTools();

/// Lets layouts and drawing come to rest.
void settle();

/// Treat's first step; its words follow the language.
QAbstractButton* camerasButton(QWidget& in);

/// The visible button with these words; null: none.
QAbstractButton* buttonWith(QWidget& in, const QString& words);

/// Writes a case with findings, three targets and two sessions; returns its folder.
std::filesystem::path writeFullCase(const std::filesystem::path& folder);

}  // namespace facenav::ui::fixtures
