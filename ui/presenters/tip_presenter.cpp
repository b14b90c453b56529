#include "presenters/tip_presenter.h"

#include <QTime>
#include <cmath>

namespace facenav::ui {

TipPresenter::TipPresenter(TreatPresenter& treat, QObject* parent) : QObject(parent), treat_(treat) {
  connect(&treat_, &TreatPresenter::changed, this, [this] {
    if (!treat_.isAligned()) last_.clear();
    emit changed();
  });
}

void TipPresenter::follow(const session::NavigationState& state) {
  const auto& check = treat_.alignmentSeen().check;
  reading_.reset();
  if (check && treat_.isRunning()) reading_ = workflow::readTip(state, treat_.tip(), *check);
  const QString now = offSkin() + skinWords() + offPlace() + placeWords() + words();
  if (now == shown_) return;
  shown_ = now;
  emit changed();
}

QString TipPresenter::offSkin() const {
  return isNear() ? QString::number(std::abs(reading_->off_skin_mm), 'f', 1) : QString(QChar(0x2013));
}

QString TipPresenter::offPlace() const {
  return isNear() && reading_->nearest ? QString::number(reading_->off_place_mm, 'f', 1)
                                       : QString(QChar(0x2013));
}

QString TipPresenter::skinWords() const {
  if (!isNear()) return tr("mm from the skin");
  return reading_->off_skin_mm < 0 ? tr("mm inside the skin") : tr("mm outside the skin");
}

QString TipPresenter::placeWords() const {
  if (!isNear() || !reading_->nearest) return tr("mm from nose or ear");
  return tr("mm from %1").arg(QString::fromStdString(reading_->nearest->name));
}

QString TipPresenter::words() const {
  if (!treat_.isAligned())
    return tr("Align first (step 2); then the MRI's skin is drawn over both pictures.");
  if (!last_.isEmpty()) return last_;
  if (!treat_.isRunning()) return tr("Start guidance (step 3): the coil's tip is read while it is tracked.");
  if (!reading_) return tr("Show face and coil to both cameras.");
  if (!isNear()) return tr("Hold the coil's tip to nose or ear.");
  return tr("Is the tip where these figures say?");
}

bool TipPresenter::canJudge() const { return treat_.isRunning() && isNear(); }

void TipPresenter::judge(workflow::TipVerdict verdict) {
  if (!canJudge()) return;
  treat_.judgeTip(verdict, *reading_);
  last_ =
      QTime::currentTime().toString("HH:mm ") +
      (verdict == workflow::TipVerdict::right ? tr("judged right: %1") : tr("judged WRONG, align again: %1"))
          .arg(QString::fromStdString(inWords(*reading_)));
  emit changed();
}

}  // namespace facenav::ui
