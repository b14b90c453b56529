#include "review/report_page.h"

#include <QLabel>
#include <QTextBrowser>
#include <QTextDocument>
#include <QVBoxLayout>
#include <utility>

#include "shell/appearance.h"
#include "shell/narrow_label.h"
#include "shell/report_pdf.h"
#include "shell/shown_words.h"

namespace facenav::ui {

ReportPage::ReportPage(ReviewPresenter& presenter, CaseModel& model, QWidget* parent)
    : QWidget(parent),
      presenter_(presenter),
      model_(model),
      words_(new QLabel(this)),
      text_(new QTextBrowser(this)) {
  words_->setObjectName("muted");
  makeNarrow(*words_);
  text_->setObjectName("report_text");
  text_->setAccessibleName(tr("report"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(words_);
  column->addWidget(text_, 1);
  connect(&presenter_, &ReviewPresenter::sessionChanged, this, [this] {
    is_outdated_ = true;
    if (isVisible()) make();
  });
  whenTextScales(this, [this] { fitWords(); });
  connect(&maker_, &TaskRunner::failed, this, [this](const QString& words) { words_->setText(words); });
}

void ReportPage::setWithName(bool has_name) {
  if (has_name == has_name_) return;
  has_name_ = has_name;
  is_outdated_ = true;
  if (isVisible()) make();
}

/// Makes the report on another thread; the atlas and the scalp are read for it.
void ReportPage::make() {
  if (!is_outdated_ || maker_.isRunning() || !model_.isOpen()) return;
  const auto session = presenter_.session();
  if (!session) {
    text_->clear();
    return words_->setText(presenter_.sessions().empty() ? tr("This case has no sessions yet.")
                                                         : tr("reading the session"));
  }
  is_outdated_ = false;
  words_->setText(tr("the report is being made"));
  maker_.start(tr("Making the report"),
               [this, session, store = model_.current().store,
                has_name = has_name_](TaskMonitor&) -> TaskRunner::Delivery {
                 report::ReportOptions options;
                 options.has_name = has_name;
                 options.language = reportLanguage();
                 auto made = std::make_shared<report::SessionReport>(
                     report::makeSessionReport(store, session->kept, options));
                 return [this, made, session] {
                   if (session == presenter_.session()) show(*made);
                   make();  // what changed meanwhile
                 };
               });
}

void ReportPage::show(const report::SessionReport& report) {
  auto* document = new QTextDocument(text_);
  fillReport(*document, report);
  document->setDocumentMargin(16);
  text_->setDocument(document);  // the view deletes only its own first document
  delete std::exchange(document_, document);
  words_->setText(
      tr("Write PDF keeps this as report.pdf and report.html, with pictures of the pulses, and pulses.csv."));
  fitWords();
}

void ReportPage::showEvent(QShowEvent*) { make(); }

/// Gives the words above the report the height of all their lines.
void ReportPage::fitWords() {
  words_->setMinimumHeight(words_->text().isEmpty() ? 0 : words_->heightForWidth(words_->width()));
}

void ReportPage::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fitWords();
}

}  // namespace facenav::ui
