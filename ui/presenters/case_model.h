#pragma once
// CaseModel: the one open case, loaded whole and shared read-only by the three workspaces.

#include <QObject>
#include <filesystem>
#include <memory>
#include <optional>

#include "facenav/casefile/case_store.h"
#include "facenav/casefile/sign_off.h"
#include "facenav/core/task_monitor.h"

namespace facenav::ui {

struct LoadedCase {
  casefile::CaseStore store;
  QString id, label;  // label: what people call it, or empty
  std::shared_ptr<const volume::Volume> mri;
  std::shared_ptr<const volume::Mask> head_mask, brain_mask;  // brain may be null
  std::shared_ptr<const volume::Mask> draft;  // a correction of the brain that is not saved, as it stands now
  std::shared_ptr<const surface::ScalpSurface> scalp;
  std::shared_ptr<const surface::BrainModel> brain;  // may be null
  std::vector<std::string> findings;
  guidance::TreatmentPlan plan;
  std::optional<atlas::AtlasMap> atlas;             // nothing: no MNI coordinates
  std::map<std::string, std::string> shown_sha256;  // of the files that a sign-off vouches for, as loaded
  casefile::SignOffStatus sign_off;

  /// What a person must judge: the correction under way, else the mask in force. May be null.
  const std::shared_ptr<const volume::Mask>& shownBrain() const { return draft ? draft : brain_mask; }
};
/// A clinician's word that a case may be treated without a valid sign-off; recorded in the case.
struct Override {
  QString by, reason;
};

/// On a worker thread. Throws Error.
std::shared_ptr<LoadedCase> loadCase(const std::filesystem::path& folder, TaskMonitor& monitor);

/// "20 Nov" from 20101120T134501Z, in local time; with the year when it is not this one's.
QString dayInWords(const std::string& utc);
/// "checked 20 Nov by XY", "not signed off", "sign-off of XY void: brain_mask.nii.gz changed", "..: a
/// correction of the brain is not saved".
QString signOffWords(const casefile::SignOffStatus& status);

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
  /// Already stored.
  void setLabel(const QString& label);
  void setSignOff(const casefile::SignOffStatus& status);
  /// A corrected brain, already stored; `shown`: hashes of the case's files now.
  void setBrain(std::shared_ptr<const volume::Mask> mask, std::shared_ptr<const surface::BrainModel> brain,
                const std::map<std::string, std::string>& shown, const casefile::SignOffStatus& status);
  /// A correction of the brain that is not saved, or null. No sign-off holds beside it.
  void setDraft(std::shared_ptr<const volume::Mask> draft);
  /// Until the case is opened again. Already recorded in the case.
  void setOverride(const Override& given);
  const std::optional<Override>& override() const { return override_; }
  /// A valid sign-off, or an override.
  bool mayBeTreated() const { return isOpen() && (case_->sign_off.holds() || override_); }

 signals:
  void opened();
  void planChanged();
  void labelChanged();
  void brainChanged();
  /// An unsaved correction of the brain has begun or is gone.
  void draftChanged();
  /// Sign-off or override.
  void signOffChanged();

 private:
  std::shared_ptr<LoadedCase> case_;
  std::optional<Override> override_;
};

}  // namespace facenav::ui
