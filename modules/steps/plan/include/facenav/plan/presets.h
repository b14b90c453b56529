#pragma once
// Common target locations by name: of the cortex in MNI coordinates, and of the scalp by the 10-20 system and
// Beam's method. `facenav plan --list-presets` and the window show the same list.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "facenav/guidance/beam_f3.h"
#include "facenav/guidance/eeg_sites.h"
#include "facenav/plan/plan_edits.h"

namespace facenav::steps {

struct Preset {
  std::string name;               // "m1-hand-left", "eeg:C3"
  std::string words, source;      // "hand area of the left M1, MNI -37 -21 58"
  std::optional<Point<Mni>> mni;  // absent: a location on the scalp
};
/// All presets, EEG sites last.
const std::vector<Preset>& presets();
/// Finds a preset. Throws Error that lists the names. "eeg:" names are as in guidance::EegSites::find.
const Preset& presetNamed(const std::string& name);

/// Measures of one head, made at the first call that needs them.
class HeadMeasures {
 public:
  HeadMeasures(std::shared_ptr<const surface::ScalpSurface> scalp, const surface::ScalpLandmarks& landmarks)
      : scalp_(std::move(scalp)), landmarks_(landmarks) {}

  const surface::ScalpLandmarks& landmarks() const { return landmarks_; }
  const surface::ScalpPaths& paths() const;
  /// EEG sites with their errors. Throws Error as placeEegSites does.
  const guidance::EegSites& eegSites() const;
  /// F3 by Beam's method; on the right side F4.
  const guidance::BeamF3& beamF3(guidance::Side side = guidance::Side::left) const;

 private:
  std::shared_ptr<const surface::ScalpSurface> scalp_;
  surface::ScalpLandmarks landmarks_;
  mutable std::optional<surface::ScalpPaths> paths_;
  mutable std::optional<guidance::EegSites> sites_;
  mutable std::optional<guidance::BeamF3> beam_[2];  // left, right
};

/// Location of a preset on this head.
struct PresetPlace {
  std::optional<Point<Mri>> cortex, scalp;  // one of them
  std::string words;                        // note for the user: "F3 +- 5 mm from the landmarks' errors"
};
/// Locates a preset. Throws Error: the case has no atlas, an unknown landmark.
PresetPlace placeOf(const Preset& preset, const atlas::AtlasMap* atlas, const HeadMeasures& measures);

}  // namespace facenav::steps
