#pragma once
// A robot that uses a window as a person does, by mouse and keyboard, and looks at it after every step:
// window_checks.h, and the kept pictures where they are asked for. It waits for what a step brings about,
// never for a time.

#include <QAbstractButton>
#include <QElapsedTimer>
#include <QSize>
#include <QStringList>
#include <QWidget>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>

#include "support/kept_pictures.h"
#include "support/window_checks.h"

namespace facenav::walk {

struct Look {
  const char* name;
  QSize size;
  double text_scale = 1;
  const testing::KeptPictures* pictures = nullptr;  // null: none are compared
};

class Robot {
 public:
  /// Whether a step stays on its page: there no button may move.
  enum class Page { stays, changes };

  /// `job` begins the names of the pictures. The window must be shown.
  Robot(QWidget& window, QString job, const Look& look);
  ~Robot();
  Robot(const Robot&) = delete;
  Robot& operator=(const Robot&) = delete;

  /// Acts, waits until `is_there`, then looks. After a step that failed, all others do nothing.
  void step(const QString& name, Page page, const std::function<void()>& act,
            const std::function<bool()>& is_there, int limit_ms = 20000);
  bool hasFailed() const { return has_failed_; }

  // Actions of a step.
  /// Presses the visible button, by its text, or the text after its symbol.
  void press(const QString& words);
  /// Chooses the tab of that name.
  void pressTab(const QString& words);
  void clickAt(QWidget& part, const QPoint& at);
  void click(QWidget& part) { clickAt(part, part.rect().center()); }
  void drag(QWidget& part, const QPoint& from, const QPoint& to);
  void key(int key, Qt::KeyboardModifiers held = Qt::NoModifier);
  void type(const QString& text);
  /// Gives the next dialog for a folder this one, and accepts it.
  void answerFolder(const QString& folder);
  /// Chooses from the next menu the entry that contains the words.
  void chooseInMenu(const QString& words);

 private:
  void look(const QString& name, const std::function<QStringList()>& moved);
  void compare(const QString& name);
  QStringList faults(const std::function<QStringList()>& moved) const;
  void fail(const QString& words);

  QWidget& window_;
  QString job_;
  Look look_;
  QPoint mouse_{-1, -1};
  std::optional<testing::ButtonPlaces> before_;  // the step
  std::set<QString> reported_;                   // each fault is told once
  bool has_failed_ = false;
  QElapsedTimer since_;
};

/// The visible button of the window with these words, else one whose words begin so: without symbol, mark of
/// a key and doubled spaces. Null if there is none.
QAbstractButton* buttonOf(const QWidget& window, const QString& words);

inline QString pathOf(const std::filesystem::path& path) { return QString::fromStdString(path.string()); }

/// The visible part of that type with that object or accessible name; null if there is none.
template <class Part>
Part* part(const QWidget& window, const QString& name = {}) {
  for (auto* each : window.findChildren<Part*>())
    if (each->isVisible() && (name.isEmpty() || each->objectName() == name || each->accessibleName() == name))
      return each;
  return nullptr;
}

}  // namespace facenav::walk
