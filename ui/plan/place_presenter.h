#pragma once
// PlacePresenter: names a place of the open case's brain: patient RAS and MNI coordinates, AAL and Brodmann
// label; and reads typed coordinates.

#include <QObject>

#include "facenav/atlas/brain_template.h"
#include "shell/case_model.h"
#include "shell/services.h"

namespace facenav::ui {

struct Place {
  Point<Mri> ras;
  std::optional<Point<Mni>> mni;  // absent: the case has no atlas
  QString aal, brodmann;          // empty: no label nearby
};

class PlacePresenter : public QObject {
  Q_OBJECT

 public:
  PlacePresenter(const Services& services, CaseModel& model, QObject* parent = nullptr);

  Place at(const Point<Mri>& ras) const;
  /// "RAS  -37.2  -21.0  58.1" / "MNI  -38  -22  56" / "Precentral_L, BA 4 (2 mm away)".
  QString describe(const Point<Mri>& ras) const;
  /// Reads "-37 -21 58", "RAS -37,-21,58", "MNI -38 -22 56" (see readCoordinates). `is_mni` applies if
  /// neither word is typed. Returns nothing, with the reason in `words`, if it cannot be read, the case has
  /// no atlas, or the place lies more than surface::kFarthestOutside_mm outside the head.
  std::optional<Point<Mri>> read(const QString& typed, bool is_mni, QString& words) const;
  bool hasAtlas() const { return model_.isOpen() && model_.current().atlas; }

 private:
  const atlas::BrainTemplate* labels() const;
  QString outsideWords(const Point<Mri>& place) const;

  const Services& services_;
  CaseModel& model_;
  mutable std::shared_ptr<const atlas::BrainTemplate> labels_;
  mutable bool has_tried_ = false;
};

}  // namespace facenav::ui
