#include "treat/outputs_row.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QSignalBlocker>

#include "shell/elided_label.h"

namespace facenav::ui {

OutputsRow::OutputsRow(TreatPresenter& treat, QWidget* parent) : QWidget(parent), treat_(treat) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  serve_ = new QCheckBox(tr("serve poses"), this);
  serve_->setObjectName("serve_poses");
  serve_->setToolTip(
      tr("gives the poses of head and coil to programs on this computer (NaviNIBS, 3D Slicer) by "
         "OpenIGTLink, port %1")
          .arg(links::kIgtlPort));
  receivers_ = new ElidedLabel(this);
  receivers_->setObjectName("receivers");
  row->addWidget(serve_);
  row->addWidget(receivers_, 1);
  connect(serve_, &QCheckBox::toggled, this,
          [this](bool is_on) { treat_.sendTo(is_on ? QStringLiteral("igtl") : QString()); });
  connect(&treat_, &TreatPresenter::changed, this, &OutputsRow::showState);
  connect(&timer_, &QTimer::timeout, this, &OutputsRow::showState);
  timer_.start(1000);  // clients come and go by themselves
  showState();
}

void OutputsRow::showState() {
  const QSignalBlocker no_toggle(serve_);
  serve_->setChecked(treat_.isSending());
  const QStringList receivers = treat_.receivers();
  const QString words = !treat_.isSending()   ? QString()
                        : receivers.isEmpty() ? tr("nobody is connected")
                                              : receivers.join("; ");
  if (words != receivers_->text()) receivers_->set(words);
}

}  // namespace facenav::ui
