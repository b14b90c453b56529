#pragma once
// Case: one folder, one patient (FORMATS.md). CaseStore opens, creates and updates it; every file is written
// whole. Privacy: the case id is random, files are 0600 and folders 0700; nothing here writes a patient's
// name but the label that a user asked for.

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "facenav/atlas/atlas_map.h"
#include "facenav/casefile/brain_quality.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/guidance/target.h"
#include "facenav/registration/aligner.h"
#include "facenav/surface/brain_model.h"
#include "facenav/surface/detailed_cortex.h"
#include "facenav/surface/navigation_check.h"
#include "facenav/surface/scalp_surface.h"
#include "facenav/volume/volume.h"

namespace facenav::casefile {

/// alignment.json.
struct StoredAlignment {
  RigidTransform<Camera, Mri> camera_T_mri;
  double rms_mm = 0, max_mm = 0, inlier_fraction = 0;
  int points = 0;
  // Per target at the time of the alignment: standard error, and what 95 of 100 errors stay below (absent in
  // files of older versions).
  std::map<std::string, double> predicted_tre_mm, predicted_tre_p95_mm;
  std::optional<registration::PoseUncertainty> uncertainty;  // nothing: another tool's file, or an older one
  // Size of the live face over the scan's, and its standard error (0: not estimated, or an older file).
  double face_scale = 1.0, face_scale_sigma = 0.0;
  std::vector<std::string> cautions;           // plain words
  SettingValues settings = changedSettings();  // that differed from their defaults

  /// Predicted standard error at the target's cortex point as it is now, whatever its name, mm. Without the
  /// pose's covariance: what was predicted under this name; nothing where that is not known either.
  std::optional<double> predictedError_mm(const guidance::Target& target) const;
};
/// A whole file, 0600.
void writeAlignment(const StoredAlignment& alignment, const std::filesystem::path& path);
/// Throws Error naming file and key; a mirrored or non-rigid pose is refused.
StoredAlignment readAlignment(const std::filesystem::path& path);

/// What prepare produced; brain parts absent where no brain can be modelled.
struct PreparedCase {
  volume::Volume mri;
  volume::Mask head_mask;
  std::optional<volume::Mask> brain_mask;
  surface::ScalpSurface scalp;
  /// Of the scalp as scalp.vtp gives it back; kept for alignments, which build it where it is absent.
  std::shared_ptr<const registration::ScalpField> scalp_field;
  std::optional<surface::BrainModel> brain;
  std::optional<surface::DetailedCortex> cortex;
  std::optional<atlas::AtlasMap> atlas;
  std::optional<surface::NavigationCheck> navigation_check;  // kept as navigation_check.json
  std::vector<std::string> findings;
  std::optional<BrainQuality> brain_quality;
  std::string label;  // asLabel; empty: none, or the replaced case's
};

/// A step's record in case.json.
struct Provenance {
  std::string step, software_version;
  std::map<std::string, std::string> options;
  std::map<std::string, std::string> input_sha256;
  SettingValues settings = changedSettings();  // that differed from their defaults
};

constexpr int kLongestLabel = 120;  // bytes
/// What people call a case, as it is kept: one line, no blanks around it. Throws Error when it is longer than
/// kLongestLabel.
std::string asLabel(const std::string& words);

/// Throws Error where `folder` is a case with targets whose MRI is not `mri` at the same place (another scan,
/// or the same one by the other map of a NIfTI): its targets would point elsewhere.
void requireTargetsStay(const std::filesystem::path& folder, const volume::Volume& mri);

class CaseStore {
 public:
  /// Opens an existing case. Throws Error: no case.json, wrong schema version, missing file.
  static CaseStore open(const std::filesystem::path& folder);
  /// Creates the case whole (temporary folder, renamed). Throws Error if `folder` exists and is no case; a
  /// case that exists is replaced only with `replace`, and then its id, label (unless `prepared` has one),
  /// targets (requireTargetsStay) and sessions are kept; its alignment is not, since it belongs to the old
  /// scalp. A brain mask corrected by hand is lost only with `discard_edits`.
  static CaseStore create(const std::filesystem::path& folder, const PreparedCase& prepared,
                          const std::vector<Provenance>& provenance, bool replace,
                          bool discard_edits = false);

  const std::filesystem::path& folder() const { return folder_; }
  std::string caseId() const;
  /// What people call the case; empty unless somebody asked for it. It may be a patient's name.
  std::string label() const;
  /// Throws Error as asLabel does; an empty one takes the label away.
  void setLabel(const std::string& words) const;
  /// When the model was made, as 20100412T134501Z; empty in cases of before this was kept.
  std::string createdUtc() const;
  std::vector<std::string> findings() const;
  std::optional<BrainQuality> brainQuality() const;  // nothing in cases of before this was kept
  std::vector<Provenance> provenance() const;
  /// Adds a step's record to case.json.
  void addProvenance(const Provenance& step) const;
  volume::Volume mri() const;
  volume::Mask headMask() const;
  std::optional<volume::Mask> brainMask() const;
  surface::ScalpSurface scalp() const;
  /// Where the scalp's distance field is kept for alignments: derived, built again when missing or stale.
  std::filesystem::path scalpField() const;
  std::optional<surface::BrainModel> brain() const;
  /// cortex.vtp; nothing in cases of before this was kept, or after an edit that did not model it anew.
  std::optional<surface::DetailedCortex> cortex() const;
  std::optional<atlas::AtlasMap> atlas() const;  // nothing where the case was made without
  guidance::TreatmentPlan targets() const;       // empty plan where targets.json is absent
  void setTargets(const guidance::TreatmentPlan& plan) const;
  std::optional<StoredAlignment> alignment() const;  // nothing where alignment.json is absent

 private:
  explicit CaseStore(std::filesystem::path folder) : folder_(std::move(folder)) {}
  std::filesystem::path folder_;
};

}  // namespace facenav::casefile
