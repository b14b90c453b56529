#include "shell/help_window.h"

#include <QAbstractTextDocumentLayout>
#include <QFile>
#include <QHBoxLayout>
#include <QPushButton>
#include <QScrollBar>
#include <QShortcut>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextDocument>
#include <QUrl>
#include <QVBoxLayout>

#include "shell/work_area.h"

namespace facenav::ui {
namespace {

const char* const kIndex = "README.md";

QString resourceOf(const QString& page) { return ":/facenav/doc/" + page; }

/// A heading's anchor, as the manual's links name it.
QString anchorOf(const QString& heading) {
  QString anchor;
  for (const QChar c : heading.toLower())
    if (c == ' ')
      anchor += '-';
    else if (c.isLetterOrNumber() || c == '-' || c == '_')
      anchor += c;
  return anchor;
}

}  // namespace

HelpWindow::HelpWindow(QWidget* parent)
    : QWidget(parent, Qt::Window), text_(new QTextBrowser(this)), back_(new QPushButton(tr("Back"), this)) {
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

void HelpWindow::addKey(QWidget& window, const QString& page, const QString& heading) {
  auto* key = new QShortcut(Qt::Key_F1, &window);
  key->setWhatsThis(tr("help for this page"));
  connect(key, &QShortcut::activated, &window,
          [&window, page, heading] { of(window).showPage(page, heading); });
}

void HelpWindow::showPage(const QString& page, const QString& heading) {
  QFile file(resourceOf(page));
  if (!file.open(QIODevice::ReadOnly)) {
    if (page != kIndex) showPage(kIndex);
    return;
  }
  if (!page_.isEmpty() && page_ != page) earlier_ << page_;
  page_ = page;
  text_->setMarkdown(QString::fromUtf8(file.readAll()));
  setWindowTitle(tr("FaceNav help: %1").arg(text_->document()->firstBlock().text()));
  present();
  goToHeading(heading);
}

void HelpWindow::showHtml(const QString& title, const QString& html) {
  if (!page_.isEmpty()) earlier_ << page_;
  page_.clear();
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
