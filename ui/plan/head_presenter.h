#pragma once
// HeadPresenter: landmarks of the open case's head (nasion, inion, tragi), and what is measured from them:
// EEG sites and Beam F3. Binds the window to plan/case_landmarks.h and plan/presets.h.

#include <QObject>
#include <optional>

#include "facenav/plan/presets.h"
#include "shell/case_model.h"

namespace facenav::ui {

class HeadPresenter : public QObject {
  Q_OBJECT

 public:
  explicit HeadPresenter(CaseModel& model, QObject* parent = nullptr);

  /// Measures of the open case's head; found at the first call (a second or two). Null without a case, or
  /// when the landmarks cannot be read: refused() says why.
  const steps::HeadMeasures* measures();
  /// Puts a landmark at the skin nearest to a place. Refused far from the skin.
  void setLandmark(surface::Landmark which, const Point<Mri>& p);
  /// Finds the landmark again, which replaces a manual position.
  void findAgain(surface::Landmark which);
  /// "nasion  R1 A84 I40  ± 2 mm, by hand", one per line.
  QString describe();
  /// Position of an EEG site, "Beam F3" or "Beam F4". Returns nothing, with a reason by refused(), if it
  /// cannot be measured.
  std::optional<Point<Mri>> site(const QString& name);
  /// All EEG sites on the skin; empty, with a reason by refused(), if they cannot be measured.
  std::vector<guidance::EegSite> sites();

 signals:
  void changed();
  void refused(const QString& words);

 private:
  template <class Step>
  void attempt(Step step);

  CaseModel& model_;
  std::optional<steps::HeadMeasures> measures_;
};

/// "nasion", "left tragus", in the window's language.
QString landmarkWords(surface::Landmark which);

}  // namespace facenav::ui
