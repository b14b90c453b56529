#pragma once
// Case: one folder, one patient (resources/doc/formats.md). CaseStore opens, creates and updates it; every
// file is written whole. Privacy: the case id is random, files are 0600 and folders 0700. The only field that
// may hold a patient's name is the label, which a user must ask for.

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
  // Per target, as predicted at the alignment: standard error, and the 95th percentile of the error (absent
  // in older files).
  std::map<std::string, double> predicted_tre_mm, predicted_tre_p95_mm;
  std::optional<registration::PoseUncertainty> uncertainty;  // absent in older files and other tools' files
  std::optional<registration::FaceScale> face_scale;         // nothing: not estimated, or an older file
  /// Standard error of the size of the face as the cameras measured it, as a share of it: what a camera that
  /// turned sideways since the calibration may have done to it. Nothing: not estimated, or an older file.
  std::optional<double> face_size_error;
  std::vector<std::string> cautions;           // in plain words
  std::optional<std::string> from;             // what the face was measured on: "dots", "plain", "film"
  std::optional<std::string> matcher;          // that measured the face, if it was not the default one
  SettingValues settings = changedSettings();  // those that differed from their defaults

  /// Predicted standard error at the target's current cortex point, mm; the target's name does not matter.
  /// Without the pose's covariance: the value stored under this name. Nothing if neither is known.
  std::optional<double> predictedError_mm(const guidance::Target& target) const;
};
/// Writes the whole file, 0600.
void writeAlignment(const StoredAlignment& alignment, const std::filesystem::path& path);
/// Throws Error naming file and key. A mirrored or non-rigid pose is refused.
StoredAlignment readAlignment(const std::filesystem::path& path);
/// A person found the case's alignment wrong: from now on the case is not aligned. Its file and its pictures
/// stay, as alignment_judged_wrong.json and alignment_capture_judged_wrong. Does nothing where it is not.
void setAlignmentAside(const std::filesystem::path& case_folder);

/// What prepare produced. Brain parts are absent where no brain can be modelled.
struct PreparedCase {
  volume::Volume mri;
  volume::Mask head_mask;
  std::optional<volume::Mask> brain_mask;
  surface::ScalpSurface scalp;
  /// Distance field of the scalp as read back from scalp.vtp. Kept for alignments, which compute it if it is
  /// absent.
  std::shared_ptr<const registration::ScalpField> scalp_field;
  std::optional<surface::BrainModel> brain;
  std::optional<surface::DetailedCortex> cortex;
  std::optional<atlas::AtlasMap> atlas;
  std::optional<surface::NavigationCheck> navigation_check;  // kept as navigation_check.json
  std::vector<std::string> findings;
  std::optional<BrainQuality> brain_quality;
  std::string contrast;  // what the scan looks like ("T1", "CT", ..); empty: not told. Not kept.
  std::string label;     // as asLabel gives it; empty: none, or that of the replaced case
};

/// What a case without an MRI is made of: the face as cameras measured it, in place of the MRI's skin. The
/// frame Mri is then the face's: axes of the head (RAS), origin between the temples, mm.
struct FaceCase {
  surface::ScalpSurface face;
  std::vector<std::string> findings;
  std::string label = {};    // as asLabel gives it; empty: none
  std::string case_id = {};  // empty: a new one
};

/// A step's record in case.json.
struct Provenance {
  std::string step, software_version;
  std::map<std::string, std::string> options;
  std::map<std::string, std::string> input_sha256;
  SettingValues settings = changedSettings();  // that differed from their defaults
};

constexpr int kLongestLabel = 120;  // bytes
/// A case's label as it is kept: one line, trimmed. Throws Error when it is longer than kLongestLabel.
std::string asLabel(const std::string& words);

/// Throws Error where `folder` is a case with targets or sessions and its MRI is not `mri` at the same place
/// (another scan, the same NIfTI read by its other transform, or a face without an MRI): its targets and the
/// poses of its sessions would point elsewhere.
void requireTargetsStay(const std::filesystem::path& folder, const volume::Volume& mri);

class CaseStore {
 public:
  /// Opens an existing case. Throws Error: no case.json, wrong schema version, missing file.
  static CaseStore open(const std::filesystem::path& folder);
  /// A case that is to be replaced: its files may be missing or damaged. Throws Error if it is no case.
  static CaseStore openToReplace(const std::filesystem::path& folder);
  /// Creates the whole case (in a temporary folder, then renamed). Throws Error if `folder` exists and is no
  /// case. An existing case is replaced only with `replace`: its id, label (unless `prepared` has one),
  /// targets and sessions (requireTargetsStay) and threshold searches are kept. Its alignment is dropped,
  /// since it belongs to the old scalp. A brain mask corrected by hand is dropped only with `discard_edits`.
  static CaseStore create(const std::filesystem::path& folder, const PreparedCase& prepared,
                          const std::vector<Provenance>& provenance, bool replace,
                          bool discard_edits = false);

  /// The same for a case without an MRI. Throws Error also where `folder` is a case with one. A case that is
  /// replaced keeps its id and label, and nothing else: its targets and sessions are those of another face
  /// measurement.
  static CaseStore createFromFace(const std::filesystem::path& folder, const FaceCase& face,
                                  const std::vector<Provenance>& provenance, bool replace);

  const std::filesystem::path& folder() const { return folder_; }
  /// False: the case holds the face as cameras measured it, and no MRI; mri(), headMask() and whatever needs
  /// them throw Error.
  bool hasMri() const;
  std::string caseId() const;
  /// Label of the case; empty unless someone set it. It may be a patient's name.
  std::string label() const;
  /// Throws Error as asLabel does. Empty removes the label.
  void setLabel(const std::string& words) const;
  /// When the model was made, as 20100412T134501Z; empty in older cases.
  std::string createdUtc() const;
  std::vector<std::string> findings() const;
  std::optional<BrainQuality> brainQuality() const;  // absent in older cases
  std::vector<Provenance> provenance() const;
  /// Adds a step's record to case.json.
  void addProvenance(const Provenance& step) const;
  volume::Volume mri() const;
  volume::Mask headMask() const;
  std::optional<volume::Mask> brainMask() const;
  surface::ScalpSurface scalp() const;
  /// Where the scalp's distance field is kept for alignments. It is derived, and is computed again when
  /// missing or stale.
  std::filesystem::path scalpField() const;
  std::optional<surface::BrainModel> brain() const;
  /// cortex.vtp; absent in older cases, or after an edit that did not model the cortex again.
  std::optional<surface::DetailedCortex> cortex() const;
  std::optional<atlas::AtlasMap> atlas() const;  // absent if the case was made without one
  guidance::TreatmentPlan targets() const;       // empty plan if targets.json is absent
  void setTargets(const guidance::TreatmentPlan& plan) const;
  std::optional<StoredAlignment> alignment() const;  // absent if there is no alignment.json

 private:
  explicit CaseStore(std::filesystem::path folder) : folder_(std::move(folder)) {}
  std::filesystem::path folder_;
};

}  // namespace facenav::casefile
