#include "treat/outputs_row.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "shell/elided_label.h"
#include "shell/shown_words.h"

namespace facenav::ui {

namespace {

const QString kServerWords = QStringLiteral("igtl");

QHBoxLayout* plainRow(QWidget* widget) {
  auto* row = new QHBoxLayout(widget);
  row->setContentsMargins(0, 0, 0, 0);
  return row;
}

}  // namespace

OutputsRow::OutputsRow(TreatPresenter& treat, QWidget* parent) : QWidget(parent), treat_(treat) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(makeServer());
  news_ = new ElidedLabel(this);
  news_->setObjectName("order_news");
  news_->hide();
  column->addWidget(news_);
  column->addWidget(makeOthers());
  connect(&treat_, &TreatPresenter::changed, this, &OutputsRow::showState);
  connect(&timer_, &QTimer::timeout, this, [this] {
    const QString news = treat_.obeyOrders();
    if (!news.isEmpty()) news_->set(news);
    showState();
  });
  timer_.start(250);  // clients come, go and send by themselves
  showState();
}

QWidget* OutputsRow::makeServer() {
  auto* bar = new QWidget(this);
  auto* row = plainRow(bar);
  serve_ = new QCheckBox(tr("serve poses"), bar);
  serve_->setObjectName("serve_poses");
  serve_->setToolTip(
      tr("gives the poses of head and coil to programs on this computer (NaviNIBS, 3D Slicer) by "
         "OpenIGTLink, port %1")
          .arg(links::kIgtlPort));
  accept_ = new QCheckBox(tr("take targets"), bar);
  accept_->setObjectName("accept_orders");
  accept_->setToolTip(
      tr("takes from these programs targets (offered, never chosen) and the commands start, stop and pulse"));
  receivers_ = new ElidedLabel(bar);
  receivers_->setObjectName("receivers");
  row->addWidget(serve_);
  row->addWidget(accept_);
  row->addWidget(receivers_, 1);
  connect(serve_, &QCheckBox::clicked, this, &OutputsRow::send);
  connect(accept_, &QCheckBox::clicked, this, [this] {
    if (!serve_->isChecked()) return;
    treat_.sendTo(otherWords());  // the server opens anew with what it takes
    serve_->setChecked(true);
    send();
  });
  return bar;
}

QWidget* OutputsRow::makeOthers() {
  auto* bar = new QWidget(this);
  auto* row = plainRow(bar);
  send_ = new QCheckBox(tr("send to"), bar);
  send_->setObjectName("send_to");
  send_->setToolTip(tr("sends to the programs named beside it; off at each start"));
  others_ = new QLineEdit(treat_.otherOutputs(), bar);
  others_->setAccessibleName(tr("outputs to other programs"));
  others_->setObjectName("other_outputs");
  others_->setPlaceholderText(QStringLiteral("lsl, invesalius:5000, osc:9000"));
  others_->setToolTip(tr("outputs with commas between them: %1. Without a host: this computer.")
                          .arg(shownWords(links::liveOutputWords())));
  row->addWidget(send_);
  row->addWidget(others_, 1);
  connect(send_, &QCheckBox::clicked, this, &OutputsRow::send);
  connect(others_, &QLineEdit::editingFinished, this, [this] {
    if (others_->text().trimmed() == treat_.otherOutputs()) return;
    if (!treat_.setOtherOutputs(others_->text())) return others_->setText(treat_.otherOutputs());
    if (send_->isChecked()) send();
  });
  return bar;
}

QString OutputsRow::otherWords() const { return send_->isChecked() ? treat_.otherOutputs() : QString(); }

void OutputsRow::send() {
  const QString server = serve_->isChecked() ? kServerWords : QString();
  treat_.sendTo(server + " " + otherWords(), accept_->isChecked());
  showState();
}

void OutputsRow::showState() {
  QStringList open = treat_.sendsTo();
  const QSignalBlocker no_toggle(serve_), no_switch(send_);
  serve_->setChecked(open.removeAll(kServerWords) > 0);
  send_->setChecked(!open.isEmpty());
  const QStringList receivers = treat_.receivers();
  const QString words = !treat_.isSending()   ? QString()
                        : receivers.isEmpty() ? tr("nobody is connected")
                                              : receivers.join("; ");
  if (words != receivers_->text()) receivers_->set(words);
  accept_->setVisible(serve_->isChecked());
  news_->setVisible(serve_->isChecked() && accept_->isChecked() && !news_->text().isEmpty());
}

}  // namespace facenav::ui
