#pragma once
// CaseModel: the one open case, loaded whole and shared read-only by the three workspaces.

#include <QObject>
#include <filesystem>
#include <memory>
#include <optional>

#include "facenav/casefile/case_coil.h"
#include "facenav/casefile/case_store.h"
#include "facenav/casefile/sign_off.h"
#include "facenav/core/task_monitor.h"

namespace facenav::ui {

struct LoadedCase {
  casefile::CaseStore store;
  QString id, label;  // label: empty if there is none
  std::shared_ptr<const volume::Volume> mri;
  std::shared_ptr<const volume::Mask> head_mask, brain_mask;  // brain may be null
  // The unsaved correction of the brain, in its current state.
  std::shared_ptr<const volume::Mask> draft;
  std::shared_ptr<const surface::ScalpSurface> scalp;
  std::shared_ptr<const surface::BrainModel> brain;  // may be null
  std::vector<std::string> findings;
  guidance::TreatmentPlan plan;
  std::optional<atlas::AtlasMap> atlas;             // absent: no MNI coordinates
  casefile::CaseCoil coil;                          // the coil that targets are planned for
  std::map<std::string, std::string> shown_sha256;  // hashes at loading of the files that a sign-off covers
  casefile::SignOffStatus sign_off;

  /// The mask to judge: the unsaved correction, else the mask in force. May be null.
  const std::shared_ptr<const volume::Mask>& shownBrain() const { return draft ? draft : brain_mask; }
};
/// A clinician allows treatment without a valid sign-off; recorded in the case.
struct Override {
  QString by, reason;
};

/// Loads a case; call it on a worker thread. Throws Error.
std::shared_ptr<LoadedCase> loadCase(const std::filesystem::path& folder, TaskMonitor& monitor);

/// "20 Nov" from 20101120T134501Z, in local time; with the year if it is not the current one.
QString dayInWords(const std::string& utc);
/// "checked 20 Nov by XY", "not signed off", "sign-off of XY void: brain_mask.nii.gz changed", "..: a
/// correction of the brain is not saved".
QString signOffWords(const casefile::SignOffStatus& status);

class CaseModel : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  bool isOpen() const { return case_ != nullptr; }
  /// Valid only while a case is open.
  const LoadedCase& current() const { return *case_; }
  void open(std::shared_ptr<LoadedCase> loaded);
  /// Stores the plan in the case. Throws Error if it cannot be written, and keeps the old plan.
  void setPlan(const guidance::TreatmentPlan& plan);
  /// Stores a copy of the coil's file in the case and uses it for the plan. Throws Error, and keeps the old
  /// coil.
  void setCoil(const std::filesystem::path& coil_json);
  /// Shows a label that is already stored.
  void setLabel(const QString& label);
  void setSignOff(const casefile::SignOffStatus& status);
  /// Sets a corrected brain that is already stored. `shown`: current hashes of the case's files.
  void setBrain(std::shared_ptr<const volume::Mask> mask, std::shared_ptr<const surface::BrainModel> brain,
                const std::map<std::string, std::string>& shown, const casefile::SignOffStatus& status);
  /// Sets the unsaved correction of the brain, or null. While there is one, no sign-off is valid.
  void setDraft(std::shared_ptr<const volume::Mask> draft);
  /// Sets an override that is already recorded in the case. Valid until the case is opened again.
  void setOverride(const Override& given);
  const std::optional<Override>& override() const { return override_; }
  /// True with a valid sign-off or an override.
  bool mayBeTreated() const { return isOpen() && (case_->sign_off.holds() || override_); }

 signals:
  void opened();
  void planChanged();
  void labelChanged();
  void brainChanged();
  /// An unsaved correction of the brain began or ended.
  void draftChanged();
  /// The sign-off or the override changed.
  void signOffChanged();

 private:
  std::shared_ptr<LoadedCase> case_;
  std::optional<Override> override_;
};

}  // namespace facenav::ui
