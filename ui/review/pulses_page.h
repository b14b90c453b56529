#pragma once
// PulsesPage: the pulses on cortex and scalp, coloured by a column that can be chosen, or the map of the
// MEPs under the coil's axis or by the field; below them the column's histogram and its drift over time.

#include <QWidget>
#include <memory>

#include "facenav/scene/pulse_layer.h"
#include "review/field_map_presenter.h"
#include "review/review_presenter.h"

class QCheckBox;
class QComboBox;
class QLabel;

namespace facenav::ui {

class ChartView;
class ColourLegend;
class SceneView;

class PulsesPage : public QWidget {
  Q_OBJECT

 public:
  PulsesPage(ReviewPresenter& presenter, CaseModel& model, QWidget* parent = nullptr);
  ~PulsesPage() override;

  FieldMapPresenter& fieldMap() { return field_map_; }

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* makeChoice();
  void showCase();
  void showSession();
  void showPulses();
  void showCharts();
  bool isExplained(const std::shared_ptr<const ReviewedSession>& session) const;
  void showHeat(const std::shared_ptr<const ReviewedSession>& session);
  void showMapWords();

  ReviewPresenter& presenter_;
  CaseModel& model_;
  FieldMapPresenter field_map_;
  SceneView* scene_;
  std::unique_ptr<scene::PulseLayer> layer_;  // destroyed before scene_
  QComboBox* column_;
  QCheckBox *heat_, *by_field_, *skin_;
  ColourLegend* legend_;
  QLabel* map_words_;
  ChartView *histogram_, *drift_;
  QString placed_for_;  // session for which the camera was turned to the target
  bool is_outdated_ = true;
};

}  // namespace facenav::ui
