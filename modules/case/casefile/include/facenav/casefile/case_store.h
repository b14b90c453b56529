#pragma once
// Case: one folder, one patient (resources/doc/formats.md). CaseStore opens, creates and updates it; every
// file is written whole. Privacy: the case id is random, files are 0600 and folders 0700. The only field that
// may contain a patient's name is the label, which a user must ask for.

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

/// Content of alignment.json.
struct StoredAlignment {
  RigidTransform<Camera, Mri> camera_T_mri;
  double rms_mm = 0, max_mm = 0, inlier_fraction = 0;
  int points = 0;
  // Predictions at the alignment, by target: standard error, and 95th percentile of the error (absent in
  // older files).
  std::map<std::string, double> predicted_tre_mm, predicted_tre_p95_mm;
  std::optional<registration::PoseUncertainty> uncertainty;  // absent in older files and other tools' files
  std::optional<registration::FaceScale> face_scale;         // nothing: not estimated, or an older file
  /// Relative standard error of the size of the face as measured, caused by a possible sideways turn of a
  /// camera since the calibration. Nothing: not estimated, or an older file.
  std::optional<double> face_size_error;
  std::vector<std::string> cautions;           // in plain words
  bool rests_on_confirmation = false;          // a person confirmed that the case is this patient's
  std::optional<std::string> from;             // what the face was measured on: "dots", "plain", "film"
  std::optional<std::string> matcher;          // set if the face was not measured with the default matcher
  SettingValues settings = changedSettings();  // settings that differ from their defaults

  /// Predicted standard error at the target's current cortex point, mm; the target's name does not matter.
  /// Without the pose's covariance, the value stored under this name. Nothing if neither is known.
  std::optional<double> predictedError_mm(const guidance::Target& target) const;
};
/// Writes the whole file, 0600.
void writeAlignment(const StoredAlignment& alignment, const std::filesystem::path& path);
/// Reads an alignment. Throws Error naming file and key, also for a mirrored or non-rigid pose.
StoredAlignment readAlignment(const std::filesystem::path& path);
/// Makes the case unaligned after a person found its alignment wrong. Renames the file and its pictures to
/// alignment_judged_wrong.json and alignment_capture_judged_wrong. Does nothing without an alignment.
void setAlignmentAside(const std::filesystem::path& case_folder);

/// Result of prepare. Brain parts are absent where no brain can be modelled.
struct PreparedCase {
  volume::Volume mri;
  volume::Mask head_mask;
  std::optional<volume::Mask> brain_mask;
  surface::ScalpSurface scalp;
  /// Distance field of the scalp as read back from scalp.vtp. Stored for alignments, which compute it if
  /// absent.
  std::shared_ptr<const registration::ScalpField> scalp_field;
  std::optional<surface::BrainModel> brain;
  std::optional<surface::DetailedCortex> cortex;
  std::optional<atlas::AtlasMap> atlas;
  std::optional<surface::NavigationCheck> navigation_check;  // stored as navigation_check.json
  std::vector<std::string> findings;
  std::optional<BrainQuality> brain_quality;
  std::string contrast;  // type of the scan ("T1", "CT", ..); empty: unknown. Not stored.
  std::string label;     // as returned by asLabel; empty: none, or that of the replaced case
};

/// Content of a case without an MRI: the face as cameras measured it, in place of the MRI's skin. The frame
/// Mri is then the face's: axes of the head (RAS), origin between the temples, mm.
struct FaceCase {
  surface::ScalpSurface face;
  std::vector<std::string> findings;
  std::string label = {};    // as returned by asLabel; empty: none
  std::string case_id = {};  // empty: a new one
};

/// Record of a step in case.json.
struct Provenance {
  std::string step, software_version;
  std::map<std::string, std::string> options;
  std::map<std::string, std::string> input_sha256;
  SettingValues settings = changedSettings();  // settings that differ from their defaults
};

constexpr int kLongestLabel = 120;  // bytes
/// Returns the label as it is stored: one line, trimmed. Throws Error when it is longer than kLongestLabel.
std::string asLabel(const std::string& words);

/// Protects targets and sessions from a change of the MRI. Throws Error if `folder` is a case with targets or
/// sessions whose MRI is not `mri` at the same position (another scan, the same NIfTI read by its other
/// transform, or a face without an MRI).
void requireTargetsStay(const std::filesystem::path& folder, const volume::Volume& mri);

class CaseStore {
 public:
  /// Opens an existing case. Throws Error: no case.json, wrong schema version, missing file.
  static CaseStore open(const std::filesystem::path& folder);
  /// Opens a case that will be replaced: its files may be missing or damaged. Throws Error if it is no case.
  static CaseStore openToReplace(const std::filesystem::path& folder);
  /// Creates the whole case (in a temporary folder, then renamed). Throws Error if `folder` exists and is no
  /// case. An existing case is replaced only with `replace`: its id, label (unless `prepared` has one),
  /// targets and sessions (requireTargetsStay) and threshold searches are kept. Its alignment is dropped,
  /// since it belongs to the old scalp. A brain mask corrected by hand is dropped only with `discard_edits`.
  static CaseStore create(const std::filesystem::path& folder, const PreparedCase& prepared,
                          const std::vector<Provenance>& provenance, bool replace,
                          bool discard_edits = false);

  /// Creates a case without an MRI. Throws Error as create does, and also where `folder` is a case with an
  /// MRI. A replaced case keeps its id and label only: its targets and sessions belong to another face
  /// measurement.
  static CaseStore createFromFace(const std::filesystem::path& folder, const FaceCase& face,
                                  const std::vector<Provenance>& provenance, bool replace);

  const std::filesystem::path& folder() const { return folder_; }
  /// True unless the case contains a measured face instead of an MRI; without an MRI, mri(), headMask() and
  /// whatever needs them throw Error.
  bool hasMri() const;
  std::string caseId() const;
  /// Label of the case; empty unless someone set it. It may be a patient's name.
  std::string label() const;
  /// Sets the label; an empty one removes it. Throws Error as asLabel does.
  void setLabel(const std::string& words) const;
  /// Time when the model was made, as 20100412T134501Z; empty in older cases.
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
  /// File of the scalp's distance field, which speeds up alignments. It is computed again when missing or
  /// stale.
  std::filesystem::path scalpField() const;
  std::optional<surface::BrainModel> brain() const;
  /// Content of cortex.vtp; absent in older cases, or after an edit that did not model the cortex again.
  std::optional<surface::DetailedCortex> cortex() const;
  std::optional<atlas::AtlasMap> atlas() const;  // absent if the case was made without an atlas
  guidance::TreatmentPlan targets() const;       // empty plan if targets.json is absent
  void setTargets(const guidance::TreatmentPlan& plan) const;
  std::optional<StoredAlignment> alignment() const;  // absent if there is no alignment.json

 private:
  explicit CaseStore(std::filesystem::path folder) : folder_(std::move(folder)) {}
  std::filesystem::path folder_;
};

}  // namespace facenav::casefile
