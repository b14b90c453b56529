#include "treat/tip_presenter.h"

#include <QTime>
#include <cmath>

#include "facenav/core/error.h"
#include "shell/shown_words.h"

namespace facenav::ui {

TipPresenter::TipPresenter(TreatPresenter& treat, QObject* parent) : QObject(parent), treat_(treat) {
  connect(&treat_, &TreatPresenter::changed, this, [this] {
    if (!treat_.isAligned() && !treat_.isRunning()) last_.clear();
    emit changed();
  });
}

void TipPresenter::follow(const session::NavigationState& state) {
  const auto& check = treat_.alignmentSeen().check;
  reading_.reset();
  if (spot_ && (!treat_.isRunning() || Timestamp::now() - spot_->picked > kSpotHolds_s)) forgetSpot();
  if (!treat_.isRunning() || Timestamp::now() - refused_ > kRefusalHolds_s) refusal_.clear();
  if (spot_)
    reading_ = spot_->reading;
  else if (check && treat_.isRunning())
    reading_ = steps::readTip(state, treat_.tip(), *check);
  const QString now = offSkin() + skinWords() + offPlace() + placeWords() + words();
  if (now == shown_) return;
  shown_ = now;
  emit changed();
}

void TipPresenter::pick(stereo::PictureSide side, const QPointF& px, const session::NavigationState& state) {
  const auto& check = treat_.alignmentSeen().check;
  if (!check || !treat_.isRunning() || !treat_.rig()) return;
  forgetSpot();
  last_.clear();
  refusal_ = !state.rig_correction
                 ? tr("Not found in the other picture. Click a spot with detail that both cameras see.")
                 : tr("A camera moved, so that a clicked spot cannot be measured. Use the coil's tip.");
  refused_ = Timestamp::now();
  try {
    if (const auto reading = steps::readPickedSpot(state, *treat_.rig(), side, {px.x(), px.y()}, *check)) {
      spot_ = {*reading, Timestamp::now()};
      treat_.showSpot(reading->tip);
      refusal_.clear();
    }
  } catch (const Error& error) {
    refusal_ = shownWords(error);
  }
  follow(state);
}

void TipPresenter::forgetSpot() {
  spot_.reset();
  treat_.showSpot({});
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
  return tr("mm from %1").arg(shownWords(reading_->nearest->name));
}

QString TipPresenter::words() const {
  if (!treat_.isAligned() && !treat_.isRunning())
    return tr("Align first (step 2); then the MRI's skin is drawn over both pictures.");
  if (!refusal_.isEmpty()) return refusal_;
  if (!last_.isEmpty()) return last_;
  if (!treat_.isRunning()) return tr("Start guidance (step 3): the coil's tip is read while it is tracked.");
  if (spot_)
    return tr("The clicked spot, white in both pictures (\u00b1%1 mm): is it where these figures say?")
        .arg(std::max(0.1, 2 * spot_->reading.sigma_mm), 0, 'f', 1);
  if (!reading_)
    return tr(
        "Show face and coil to both cameras. Or hold a finger to nose or ear and click its tip in a "
        "picture.");
  if (!isNear())
    return tr("Hold the coil's tip to nose or ear. Or hold a finger there and click its tip in a picture.");
  return tr("Is the tip where these figures say?");
}

bool TipPresenter::canJudge() const { return treat_.isRunning() && refusal_.isEmpty() && isNear(); }

void TipPresenter::judge(steps::TipVerdict verdict) {
  if (!canJudge()) return;
  treat_.judgeTip(verdict, *reading_);
  last_ = QTime::currentTime().toString("HH:mm ") +
          (verdict == steps::TipVerdict::right ? tr("matches: %1") : tr("DOES NOT MATCH, align again: %1"))
              .arg(shownWords(inWords(*reading_)));
  forgetSpot();
  emit changed();
}

}  // namespace facenav::ui
