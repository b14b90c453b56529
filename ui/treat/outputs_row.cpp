#include "treat/outputs_row.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "shell/elided_label.h"

namespace facenav::ui {

OutputsRow::OutputsRow(TreatPresenter& treat, QWidget* parent) : QWidget(parent), treat_(treat) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  auto* row = new QHBoxLayout;
  serve_ = new QCheckBox(tr("serve poses"), this);
  serve_->setObjectName("serve_poses");
  serve_->setToolTip(
      tr("gives the poses of head and coil to programs on this computer (NaviNIBS, 3D Slicer) by "
         "OpenIGTLink, port %1")
          .arg(links::kIgtlPort));
  accept_ = new QCheckBox(tr("take targets"), this);
  accept_->setObjectName("accept_orders");
  accept_->setToolTip(
      tr("takes from these programs targets (offered, never chosen) and the commands start, stop and pulse"));
  receivers_ = new ElidedLabel(this);
  receivers_->setObjectName("receivers");
  news_ = new ElidedLabel(this);
  news_->setObjectName("order_news");
  news_->hide();
  row->addWidget(serve_);
  row->addWidget(accept_);
  row->addWidget(receivers_, 1);
  column->addLayout(row);
  column->addWidget(news_);
  connect(serve_, &QCheckBox::toggled, this, &OutputsRow::serve);
  connect(accept_, &QCheckBox::toggled, this, [this] {
    if (serve_->isChecked()) serve();
  });
  connect(&treat_, &TreatPresenter::changed, this, &OutputsRow::showState);
  connect(&timer_, &QTimer::timeout, this, [this] {
    const QString news = treat_.obeyOrders();
    if (!news.isEmpty()) news_->set(news);
    showState();
  });
  timer_.start(250);  // clients come, go and send by themselves
  showState();
}

void OutputsRow::serve() {
  treat_.sendTo(serve_->isChecked() ? QStringLiteral("igtl") : QString(), accept_->isChecked());
}

void OutputsRow::showState() {
  const QSignalBlocker no_toggle(serve_);
  serve_->setChecked(treat_.isSending());
  const QStringList receivers = treat_.receivers();
  const QString words = !treat_.isSending()   ? QString()
                        : receivers.isEmpty() ? tr("nobody is connected")
                                              : receivers.join("; ");
  if (words != receivers_->text()) receivers_->set(words);
  accept_->setVisible(treat_.isSending());
  news_->setVisible(treat_.isSending() && accept_->isChecked() && !news_->text().isEmpty());
}

}  // namespace facenav::ui
