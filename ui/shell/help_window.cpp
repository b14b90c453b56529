#include "shell/help_window.h"

#include <QAbstractTextDocumentLayout>
#include <QApplication>
#include <QFile>
#include <QHBoxLayout>
#include <QPushButton>
#include <QScrollBar>
#include <QShortcut>
#include <QTextBlock>
#include <QTextDocument>
#include <QUrl>
#include <QVBoxLayout>

#include "shell/manual_text.h"
#include "shell/work_area.h"

namespace facenav::ui {
namespace {

const char* const kIndex = "README.md";

QString resourceOf(const QString& page) { return ":/facenav/doc/" + page; }

const char* const kPlacePage = "help_page";  // properties of a widget that has its own place in the manual
const char* const kPlaceHeading = "help_heading";

}  // namespace

HelpWindow::HelpWindow(QWidget* parent)
    : QWidget(parent, Qt::Window), text_(new ManualText(this)), back_(new QPushButton(tr("Back"), this)) {
  auto* column = new QVBoxLayout(this);
  column->addWidget(text_, 1);
  auto* row = new QHBoxLayout;
  auto* index = new QPushButton(tr("All pages"), this);
  auto* close_it = new QPushButton(tr("Close"), this);
  back_->setToolTip(tr("the page before (Alt+Left)"));
  back_->setShortcut(QKeySequence::Back);
  index->setToolTip(tr("the list of the manual's pages"));
  close_it->setToolTip(tr("closes the help (Esc)"));
  close_it->setShortcut(Qt::Key_Escape);
  row->addWidget(back_);
  row->addWidget(index);
  row->addStretch(1);
  row->addWidget(close_it);
  column->addLayout(row);
  text_->setOpenLinks(false);
  text_->setAccessibleName(tr("help"));
  connect(text_, &QTextBrowser::anchorClicked, this, &HelpWindow::follow);
  connect(back_, &QPushButton::clicked, this, &HelpWindow::goBack);
  connect(index, &QPushButton::clicked, this, [this] { showPage(kIndex); });
  connect(close_it, &QPushButton::clicked, this, &QWidget::close);
  fitIntoWorkArea(*this, {820, 720});
}

HelpWindow& HelpWindow::of(QWidget& window) {
  if (auto* made = window.findChild<HelpWindow*>(QString(), Qt::FindDirectChildrenOnly)) return *made;
  return *new HelpWindow(&window);
}

void HelpWindow::addKey(QWidget& window, const QString& page, const std::function<QString()>& heading) {
  auto* key = new QShortcut(Qt::Key_F1, &window);
  key->setWhatsThis(tr("help for this page"));
  connect(key, &QShortcut::activated, &window, [&window, page, heading] {
    if (!showPlaceOf(QApplication::focusWidget(), window)) of(window).showPage(page, heading());
  });
}

void HelpWindow::addKey(QWidget& window, const QString& page, const QString& heading) {
  addKey(window, page, [heading] { return heading; });
}

void HelpWindow::setPlace(QWidget& part, const QString& page, const QString& heading) {
  part.setProperty(kPlacePage, page);
  part.setProperty(kPlaceHeading, heading);
}

bool HelpWindow::showPlaceOf(const QWidget* part, QWidget& window) {
  for (; part && part != &window; part = part->parentWidget()) {
    const QString page = part->property(kPlacePage).toString();
    if (page.isEmpty()) continue;
    of(window).showPage(page, part->property(kPlaceHeading).toString());
    return true;
  }
  return false;
}

void HelpWindow::showPage(const QString& page, const QString& heading) {
  QFile file(resourceOf(page));
  if (!file.open(QIODevice::ReadOnly)) {
    if (page != kIndex) showPage(kIndex);
    return;
  }
  if (!page_.isEmpty() && page_ != page) earlier_ << page_;
  page_ = page;
  text_->showPage(QString::fromUtf8(file.readAll()));
  heading_ = hasHeading(*text_->document(), heading) ? heading : QString();
  setWindowTitle(tr("FaceNav help: %1").arg(text_->document()->firstBlock().text()));
  present();
  goToHeading(heading);
}

void HelpWindow::showHtml(const QString& title, const QString& html) {
  if (!page_.isEmpty()) earlier_ << page_;
  page_.clear();
  heading_.clear();
  text_->setHtml(html);
  setWindowTitle(title);
  present();
}

QString HelpWindow::text() const { return text_->toPlainText(); }

void HelpWindow::present() {
  back_->setEnabled(!earlier_.isEmpty());
  show();
  raise();
  activateWindow();
  text_->setFocus();
}

/// Follows a link of the manual. A link to the source has no page here and does nothing.
void HelpWindow::follow(const QUrl& link) {
  const QString page = link.path().isEmpty() ? page_ : link.path();
  if (link.isRelative() && QFile::exists(resourceOf(page))) showPage(page, link.fragment());
}

void HelpWindow::goBack() {
  if (earlier_.isEmpty()) return;
  const QString page = earlier_.takeLast();
  page_.clear();  // going back is no step to come back from
  showPage(page);
}

void HelpWindow::goToHeading(const QString& heading) {
  if (heading.isEmpty()) return text_->verticalScrollBar()->setValue(0);
  for (QTextBlock block = text_->document()->begin(); block.isValid(); block = block.next()) {
    if (block.blockFormat().headingLevel() == 0 || anchorOf(block.text()) != heading) continue;
    text_->setTextCursor(QTextCursor(block));
    const QRectF place = text_->document()->documentLayout()->blockBoundingRect(block);
    return text_->verticalScrollBar()->setValue(int(place.top()));
  }
}

}  // namespace facenav::ui
