#include "shell/view_menu.h"

#include <QApplication>
#include <QClipboard>
#include <QMenu>
#include <QMessageBox>
#include <QToolTip>

#include "facenav/core/error.h"
#include "shell/screenshot.h"
#include "shell/shown_words.h"

namespace facenav::ui {
namespace {

void keepPicture(QWidget& view) {
  try {
    const QString words = keepScreenshot(view);
    if (!words.isEmpty()) QToolTip::showText(view.mapToGlobal(QPoint(0, 0)), words, &view);
  } catch (const Error& error) {
    QMessageBox::warning(&view, QObject::tr("The picture was not kept"), shownWords(error));
  }
}

}  // namespace

QString coordinatesAsText(const Point<Mri>& place) {
  return QString("%1 %2 %3")
      .arg(place.mm.x(), 0, 'f', 1)
      .arg(place.mm.y(), 0, 'f', 1)
      .arg(place.mm.z(), 0, 'f', 1);
}

QMenu* makeViewMenu(QWidget& view, const ViewOffers& offers) {
  auto* menu = new QMenu(&view);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  if (offers.place) {
    const QString text = coordinatesAsText(*offers.place);
    menu->addAction(QObject::tr("Copy the coordinates %1 (RAS, mm)").arg(text), menu,
                    [text] { QApplication::clipboard()->setText(text); });
    if (offers.goTo) menu->addAction(QObject::tr("Go to this place"), menu, offers.goTo);
    menu->addSeparator();
  }
  if (offers.reset) menu->addAction(QObject::tr("Reset the view"), menu, offers.reset);
  menu->addAction(QObject::tr("Save a picture of the view\u2026"), menu, [&view] { keepPicture(view); });
  return menu;
}

void openViewMenu(QWidget& view, const QPoint& at, const ViewOffers& offers) {
  makeViewMenu(view, offers)->popup(view.mapToGlobal(at));
}

}  // namespace facenav::ui
