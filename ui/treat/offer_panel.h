#pragma once
// OfferPanel: a target that a client of the server offers, with Take and Refuse. In Plan it is drawn in the
// head; in Treat a button leads there. Hidden while there is no offer.

#include <QFrame>

#include "treat/offers_presenter.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace facenav::ui {

class OfferPanel : public QFrame {
  Q_OBJECT

 public:
  enum class Page { plan, treat };
  OfferPanel(OffersPresenter& offers, Page page, QWidget* parent = nullptr);

  /// The offer to draw in the head; nothing if there is none, or it shall not be drawn.
  const std::optional<OfferedPose>& previewed() const { return previewed_; }
  /// Chooses an offer and draws it.
  void showOffer(const QString& name);

 signals:
  void previewChanged();

 private:
  void makeButtons(QWidget* parent);
  void fill();
  void showChosen();

  OffersPresenter& offers_;
  Page page_;
  std::vector<OfferedPose> all_;
  std::optional<OfferedPose> previewed_;
  QComboBox* names_;
  QLabel *heading_, *words_;
  QPushButton *preview_, *take_, *refuse_;
};

}  // namespace facenav::ui
