#pragma once
// OverlayPresenter: overlays of the open case (plan/overlays.h): adds files of other programs in the
// background, removes them, and changes how they are shown. Every change is saved in the case at once.

#include <QObject>
#include <memory>
#include <vector>

#include "facenav/plan/overlays.h"
#include "shell/case_model.h"
#include "shell/task_runner.h"

namespace facenav::ui {

class OverlayPresenter : public QObject {
  Q_OBJECT

 public:
  explicit OverlayPresenter(CaseModel& model, QObject* parent = nullptr);

  const std::vector<casefile::OverlayEntry>& entries() const { return entries_; }
  const casefile::OverlayEntry* find(const QString& name) const;
  /// The displayed overlays, in Mri.
  std::vector<scene::Overlay> shown() const;
  /// Adds a file. `space`: empty if the file determines it. refused() gives the reason if it cannot be added.
  void add(const QString& file, std::optional<casefile::OverlaySpace> space, const QString& name);
  void remove(const QString& name);
  /// Opacity, threshold, end of colours, unit, and whether it is shown.
  void change(const casefile::OverlayEntry& entry);
  /// "map, MNI, from ±2.1 to ±8.4 z".
  QString describe(const casefile::OverlayEntry& entry) const;
  bool isBusy() const { return runner_.isRunning(); }

 signals:
  void changed();
  void refused(const QString& words);

 private:
  void forget(const QString& name);
  void load();

  CaseModel& model_;
  TaskRunner runner_;
  std::vector<casefile::OverlayEntry> entries_;
  std::vector<scene::Overlay> loaded_;  // the entries that could be read
  int subject_ = 0;
};

}  // namespace facenav::ui
