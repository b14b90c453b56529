#include "treat/return_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace facenav::ui {

ReturnPanel::ReturnPanel(ReturnPresenter& presenter, QWidget* parent)
    : QFrame(parent), presenter_(presenter) {
  setObjectName("warning");
  auto* row = new QHBoxLayout(this);
  words_ = new QLabel(this);
  words_->setObjectName("return_words");
  words_->setWordWrap(true);
  go_on_ = new QPushButton(tr("Go on with it"), this);
  go_on_->setObjectName("primary");
  go_on_->setToolTip(
      tr("keeps counting in the same session, on its own alignment; guidance comes when two seconds of "
         "measuring have shown that the face still fits it"));
  auto* begin_new = new QPushButton(tr("Begin a new one"), this);
  begin_new->setToolTip(tr("leaves that session as it is; align, and start guidance"));
  row->addWidget(words_, 1);
  row->addWidget(go_on_);
  row->addWidget(begin_new);
  connect(go_on_, &QPushButton::clicked, &presenter_, &ReturnPresenter::goOn);
  connect(begin_new, &QPushButton::clicked, &presenter_, &ReturnPresenter::beginNew);
  connect(&presenter_, &ReturnPresenter::changed, this, &ReturnPanel::showState);
  showState();
}

void ReturnPanel::showState() {
  setVisible(presenter_.isOffered());
  if (!presenter_.isOffered()) return;
  const QString missing = presenter_.missing();
  words_->setText(missing.isEmpty() ? presenter_.words()
                                    : presenter_.words() + tr(" To go on: %1.").arg(missing));
  go_on_->setEnabled(missing.isEmpty());
}

}  // namespace facenav::ui
