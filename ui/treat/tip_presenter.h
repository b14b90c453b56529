#pragma once
// TipPresenter: the check of the alignment that a person judges (align/alignment_seen.h). The coil's tip is
// held to nose or ear, or a spot is clicked in a live picture (a finger's tip, a mole); the page shows where
// it is on the MRI's skin, and the person judges right or wrong. The judgement is an event of the session; a
// wrong one withholds guidance until a measured check passes.

#include <QObject>
#include <QPointF>
#include <optional>

#include "treat/treat_presenter.h"

namespace facenav::ui {

class TipPresenter : public QObject {
  Q_OBJECT

 public:
  explicit TipPresenter(TreatPresenter& treat, QObject* parent = nullptr);

  /// Takes the newest state; called about 30 times a second.
  void follow(const session::NavigationState& state);
  /// Measures a spot clicked in a picture of `state`. It replaces the coil's tip until it is judged, for at
  /// most kSpotHolds_s. If it cannot be measured, the reason is shown for kRefusalHolds_s and nothing can be
  /// judged.
  void pick(stereo::PictureSide side, const QPointF& px, const session::NavigationState& state);
  static constexpr double kSpotHolds_s = 30, kRefusalHolds_s = 6;
  /// "0.8", "3.2"; a dash if the tip is not known, or too far from the head to be judged.
  QString offSkin() const;
  QString offPlace() const;
  /// "mm outside the skin", "mm from nose tip".
  QString skinWords() const;
  QString placeWords() const;
  /// What to do, or the last judgement: "14:05 matches: 0.8 mm outside the skin, 3.2 mm from nose tip".
  QString words() const;
  /// True if the tip is near the head in a running session.
  bool canJudge() const;
  /// Does nothing unless canJudge().
  void judge(steps::TipVerdict verdict);
  const std::optional<guidance::TipReading>& reading() const { return reading_; }

 signals:
  void changed();

 private:
  struct Spot {
    guidance::TipReading reading;
    Timestamp picked;
  };
  bool isNear() const { return reading_ && reading_->isNear(); }
  void forgetSpot();

  TreatPresenter& treat_;
  std::optional<guidance::TipReading> reading_;
  std::optional<Spot> spot_;
  QString refusal_;  // refusal of the newest click
  Timestamp refused_;
  QString shown_, last_;
};

}  // namespace facenav::ui
