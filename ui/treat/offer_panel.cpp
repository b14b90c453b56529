#include "treat/offer_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "shell/narrow_label.h"
#include "shell/users_words.h"

namespace facenav::ui {
namespace {

bool isSameOffer(const std::optional<OfferedPose>& a, const std::optional<OfferedPose>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return a->name == b->name && a->mri_T_coil.matrix() == b->mri_T_coil.matrix();
}

}  // namespace

OfferPanel::OfferPanel(OffersPresenter& offers, Page page, QWidget* parent)
    : QFrame(parent), offers_(offers), page_(page) {
  setObjectName("offer");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  auto* row = new QHBoxLayout;
  heading_ = new QLabel(tr("offered target"), this);
  names_ = new QComboBox(this);
  names_->setAccessibleName(tr("offered target"));
  names_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  names_->setMinimumContentsLength(9);
  markUsersWords(*names_);
  row->addWidget(heading_);
  row->addWidget(names_, 1);
  column->addLayout(row);
  words_ = new QLabel(this);
  words_->setObjectName("offer_words");
  makeNarrow(*words_);
  column->addWidget(words_);
  auto* buttons = new QWidget(this);
  makeButtons(buttons);
  column->addWidget(buttons);
  connect(names_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &OfferPanel::showChosen);
  connect(&offers_, &OffersPresenter::changed, this, &OfferPanel::fill);
  fill();
}

void OfferPanel::makeButtons(QWidget* parent) {
  auto* row = new QHBoxLayout(parent);
  row->setContentsMargins(0, 0, 0, 0);
  const bool is_plan = page_ == Page::plan;
  preview_ = new QPushButton(is_plan ? tr("Preview") : tr("Show in Plan"), parent);
  preview_->setToolTip(is_plan ? tr("draws the offered coil in the head, in place of the active target's")
                               : tr("goes to Plan, where the offered coil is drawn in the head"));
  take_ = new QPushButton(tr("Take"), parent);
  take_->setToolTip(tr("puts it into the plan, one step to undo; the chosen target stays as it is"));
  refuse_ = new QPushButton(tr("Refuse"), parent);
  refuse_->setToolTip(tr("puts it away; it returns only if the other program moves it"));
  for (auto* button : {preview_, take_, refuse_}) row->addWidget(button, 1);
  if (is_plan) {
    preview_->setCheckable(true);
    preview_->setChecked(true);
    connect(preview_, &QPushButton::toggled, this, &OfferPanel::showChosen);
  } else {
    connect(preview_, &QPushButton::clicked, this, [this] { offers_.show(names_->currentText()); });
  }
  connect(take_, &QPushButton::clicked, this, [this] { offers_.take(names_->currentText()); });
  connect(refuse_, &QPushButton::clicked, this, [this] { offers_.refuse(names_->currentText()); });
}

void OfferPanel::showOffer(const QString& name) {
  names_->setCurrentText(name);
  preview_->setChecked(true);
  showChosen();
}

void OfferPanel::fill() {
  all_ = offers_.all();
  const QString chosen = names_->currentText();
  const QSignalBlocker no_choice(names_);
  names_->clear();
  for (const auto& offer : all_) names_->addItem(offer.name);
  names_->setCurrentIndex(std::max(0, names_->findText(chosen)));
  setVisible(!all_.empty());
  showChosen();
}

void OfferPanel::showChosen() {
  const int chosen = names_->currentIndex();
  std::optional<OfferedPose> next;
  if (chosen >= 0 && chosen < int(all_.size())) next = all_[std::size_t(chosen)];
  words_->setText(next ? next->words : QString());
  if (page_ != Page::plan || !preview_->isChecked()) next.reset();
  const bool is_same = isSameOffer(next, previewed_);
  previewed_ = std::move(next);
  if (!is_same) emit previewChanged();
}

}  // namespace facenav::ui
