#pragma once
// CaseModel: the one open case, loaded whole and shared read-only by the three workspaces.

#include <QObject>
#include <filesystem>
#include <memory>
#include <optional>

#include "facenav/casefile/case_store.h"
#include "facenav/core/task_monitor.h"

namespace facenav::ui {

struct LoadedCase {
  casefile::CaseStore store;
  QString id;
  std::shared_ptr<const volume::Volume> mri;
  std::shared_ptr<const volume::Mask> head_mask, brain_mask;  // brain may be null
  std::shared_ptr<const surface::ScalpSurface> scalp;
  std::shared_ptr<const surface::BrainModel> brain;  // may be null
  std::vector<std::string> findings;
  guidance::TreatmentPlan plan;
  std::optional<casefile::StoredAlignment> alignment;
};

/// On a worker thread. Throws Error.
std::shared_ptr<LoadedCase> loadCase(const std::filesystem::path& folder, TaskMonitor& monitor);

class CaseModel : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  bool isOpen() const { return case_ != nullptr; }
  /// Only while open.
  const LoadedCase& current() const { return *case_; }
  void open(std::shared_ptr<LoadedCase> loaded);
  /// Stores the plan in the case. Throws Error, and keeps the old plan, when it cannot be written.
  void setPlan(const guidance::TreatmentPlan& plan);
  /// Already stored by the alignment step.
  void setAlignment(const casefile::StoredAlignment& alignment);

 signals:
  void opened();
  void planChanged();
  void alignmentChanged();

 private:
  std::shared_ptr<LoadedCase> case_;
};

}  // namespace facenav::ui
