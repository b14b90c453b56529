#pragma once
// ProjectorPresenter: what the projector shows on the head during guidance (pictures/projected_guide.h).
// Drawn on its own thread; a picture that does not match the newest state is not shown.

#include <QObject>
#include <QSize>
#include <memory>

#include "facenav/cameras/projector_model.h"
#include "facenav/pictures/overlay_worker.h"
#include "treat/treat_presenter.h"

namespace facenav::ui {

class ProjectorPresenter : public QObject {
  Q_OBJECT

 public:
  ProjectorPresenter(TreatPresenter& treat, CaseModel& model, QObject* parent = nullptr);
  ~ProjectorPresenter() override;

  /// Opens projector.yml and remembers it. Returns false, after refused(), if it cannot be read.
  bool open(const QString& file);
  /// The file opened last, or projector.yml of the recording in use; empty if none is known.
  QString knownFile() const;
  void close();
  bool isOpen() const { return projector_.has_value(); }
  QSize size() const;
  /// Asks for the picture of a state; drawn() delivers it. Does nothing unless one is open.
  void ask(std::shared_ptr<const session::NavigationState> state);

 signals:
  void changed();
  void drawn(std::shared_ptr<const facenav::pictures::DrawnOverlay> picture);
  void refused(const QString& words);

 private:
  void begin();

  TreatPresenter& treat_;
  CaseModel& model_;
  std::optional<cameras::ProjectorModel> projector_;
  std::unique_ptr<pictures::OverlayWorker> worker_;  // null if not open
};

}  // namespace facenav::ui
