#include "robot.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QPushButton>
#include <QTabBar>
#include <QTimer>
#include <QWindow>
#include <QtTest/QTest>
#include <cstdio>
#include <cstdlib>

#include "gui/gui_fixtures.h"
#include "shell/scroll_column.h"

namespace facenav::walk {
namespace {

using ui::fixtures::waitFor;

constexpr int kLayout_ms = 1500;  // at most, until a new layout is in force
constexpr int kPicture_ms = 8000, kStill_ms = 900;
constexpr double kStillLevels = 0.5;  // grey levels between pictures of a window at rest
constexpr int kPoll_ms = 20;

/// Parts whose content differs from run to run: times, dates, random numbers, live figures.
const QStringList& changing() {
  static const QStringList kNames{"header",       "taskbar",   "worklist",    "sessions",
                                  "pulses",       "session",   "report",      "pause_words",
                                  "session_time", "end_words", "check_words", "last_pulse"};
  return kNames;
}

/// The words without their symbol, mark of a key or line.
QString plain(const QString& text) {
  const QString words = text.section('\n', -1).simplified();
  return QString(words).replace("&&", "\x01").remove('&').replace("\x01", "&");
}

/// Calls `act` as soon as `is_there`, also while a dialog or menu runs its own loop.
void whenever(const std::function<bool()>& is_there, const std::function<void()>& act) {
  auto* poll = new QTimer(qApp);
  auto ends = std::make_shared<QElapsedTimer>();
  ends->start();
  QObject::connect(poll, &QTimer::timeout, qApp, [=] {
    if (!is_there() && ends->elapsed() < kPicture_ms) return;
    poll->stop();
    poll->deleteLater();
    is_there() ? act() : void(ADD_FAILURE() << "no dialog or menu came");
  });
  poll->start(kPoll_ms);
}

}  // namespace

QAbstractButton* buttonOf(const QWidget& window, const QString& words) {
  QAbstractButton* begins = nullptr;
  for (auto* button : window.findChildren<QAbstractButton*>()) {
    if (!button->isVisible() || button->window() != &window) continue;
    if (plain(button->text()) == words) return button;
    if (!begins && plain(button->text()).startsWith(words)) begins = button;
  }
  return begins;
}

Robot::Robot(QWidget& window, QString job, const Look& look)
    : window_(window), job_(std::move(job)), look_(look) {
  // Where other programs left the pointer, a button would look as if the mouse were on it.
  QCursor::setPos(QGuiApplication::primaryScreen()->geometry().bottomRight());

  window_.resize(look_.size);
  QApplication::setCursorFlashTime(0);  // a picture does not change by itself
  QApplication::setActiveWindow(&window_);
  since_.start();
}

Robot::~Robot() {
  std::printf("%s at %s: %.1f s\n", qPrintable(job_), look_.name, 1e-3 * double(since_.elapsed()));
}

void Robot::fail(const QString& words) {
  has_failed_ = true;
  ADD_FAILURE() << words.toStdString();
}

void Robot::step(const QString& name, Page page, const std::function<void()>& act,
                 const std::function<bool()>& is_there, int limit_ms) {
  if (has_failed_) return;
  SCOPED_TRACE((job_ + ", " + look_.name + ": " + name).toStdString());
  mouse_ = {-1, -1};
  before_.emplace(window_);
  act();
  if (!has_failed_ && !waitFor(is_there, limit_ms)) fail("what the step should bring about did not come");
  if (const char* folder = std::getenv("FACENAV_GUI_PICTURES")) {
    QApplication::processEvents();
    window_.grab().save(
        QString("%1/%2_%3_%4.png").arg(folder, job_, look_.name, QString(name).replace(' ', '_')));
  }
  if (has_failed_) return;
  look(name, [&] { return page == Page::stays ? before_->moved(mouse_) : QStringList(); });
}

QStringList Robot::faults(const std::function<QStringList()>& moved) const {
  QStringList all = testing::cutTexts(window_) + testing::misplacedParts(window_) + moved();
  if (window_.size() != look_.size)
    all << QString("the window became %1 x %2").arg(window_.width()).arg(window_.height());
  return all;
}

void Robot::look(const QString& name, const std::function<QStringList()>& moved) {
  QStringList found;
  waitFor([&] { return (found = faults(moved)).isEmpty(); }, kLayout_ms);
  for (const QString& fault : found)
    if (reported_.insert(fault).second) ADD_FAILURE() << fault.toStdString();
  if (look_.pictures) compare(name);
}

/// Waits until the picture is like the kept one, or, where a new one is kept, until nothing moves any more.
void Robot::compare(const QString& name) {
  using Use = testing::KeptPictures::Use;
  const auto& kept = *look_.pictures;
  const QString file = QString(job_ + "_" + name).replace(' ', '_');
  const double enough = kept.use() == Use::compare ? kept.tolerance(file) : kStillLevels;
  QImage picture = testing::smallPicture(window_, changing());
  QElapsedTimer still;
  still.start();
  waitFor(
      [&] {
        const QImage now = testing::smallPicture(window_, changing());
        if (testing::difference(now, picture) > kStillLevels) still.restart();
        picture = now;
        return kept.use() == Use::renew ? still.elapsed() > kStill_ms
                                        : kept.differenceFrom(file, picture) <= enough;
      },
      kPicture_ms);
  const QString fault = kept.show(file, picture);
  if (fault.isEmpty()) return;
  ADD_FAILURE() << fault.toStdString();
  if (const char* folder = std::getenv("FACENAV_GUI_PICTURES"))
    picture.save(QString("%1/small_%2.png").arg(folder, file));
}

void Robot::press(const QString& words) {
  auto* button = buttonOf(window_, words);
  if (!button) return fail("there is no button " + words);
  if (!button->isEnabled() && !waitFor([&] { return button->isEnabled(); }))
    return fail(words + " is disabled");
  ui::ScrollColumn::bringIntoView(*button);
  QApplication::processEvents();
  before_.emplace(window_);  // scrolling is this step's own wish
  click(*button);
}

void Robot::pressTab(const QString& words) {
  for (auto* tabs : window_.findChildren<QTabBar*>())
    for (int i = 0; i < tabs->count(); ++i)
      if (tabs->isVisible() && tabs->tabText(i) == words) return clickAt(*tabs, tabs->tabRect(i).center());
  fail("there is no tab " + words);
}

/// Clicks into the window, not at the part: what lies over the part gets the click.
void Robot::clickAt(QWidget& part, const QPoint& at) {
  mouse_ = part.mapTo(&window_, at);
  const auto* hit = window_.childAt(mouse_);
  if (hit != &part && (!hit || !part.isAncestorOf(hit)))
    return fail(QString("a click at %1,%2 does not reach %3")
                    .arg(mouse_.x())
                    .arg(mouse_.y())
                    .arg(part.metaObject()->className()));
  QTest::mouseClick(window_.windowHandle(), Qt::LeftButton, {}, mouse_);
}

void Robot::drag(QWidget& part, const QPoint& from, const QPoint& to) {
  constexpr int kMoves = 4;
  auto* window = window_.windowHandle();
  mouse_ = part.mapTo(&window_, from);
  QTest::mousePress(window, Qt::LeftButton, {}, mouse_);
  for (int i = 1; i <= kMoves; ++i) {
    mouse_ = part.mapTo(&window_, from + (to - from) * i / kMoves);
    QTest::mouseMove(window, mouse_);
  }
  QTest::mouseRelease(window, Qt::LeftButton, {}, mouse_);
}

void Robot::key(int key, Qt::KeyboardModifiers held) {
  QApplication::setActiveWindow(&window_);
  QWidget* focus = window_.focusWidget();
  QTest::keyClick(focus ? focus : &window_, Qt::Key(key), held);
}

void Robot::type(const QString& text) {
  if (QWidget* focus = window_.focusWidget()) QTest::keyClicks(focus, text);
}

void Robot::answerFolder(const QString& folder) {
  const auto dialog = [] { return qobject_cast<QFileDialog*>(QApplication::activeModalWidget()); };
  whenever([dialog] { return dialog() && dialog()->isVisible(); },
           [dialog, folder] {
             dialog()->findChild<QLineEdit*>("fileNameEdit")->setText(folder);
             for (auto* button : dialog()->findChildren<QPushButton*>())
               if (button->isDefault() && button->isEnabled())
                 return QTest::mouseClick(button, Qt::LeftButton);
             ADD_FAILURE() << "the dialog cannot be accepted";
             dialog()->reject();
           });
}

void Robot::chooseInMenu(const QString& words) {
  const auto menu = [] { return qobject_cast<QMenu*>(QApplication::activePopupWidget()); };
  whenever([menu] { return menu() && menu()->isVisible(); },
           [menu, words] {
             for (auto* action : menu()->actions())
               if (action->text().contains(words))
                 return QTest::mouseClick(menu(), Qt::LeftButton, {},
                                          menu()->actionGeometry(action).center());
             ADD_FAILURE() << "the menu has no " << words.toStdString();
             menu()->close();
           });
}

}  // namespace facenav::walk
