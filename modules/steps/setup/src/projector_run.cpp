#include "facenav/setup/projector_run.h"

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"

namespace facenav::steps {
namespace {

// Delay until a shown picture is used: screens and projectors show it up to 100 ms late, and the exposure
// must lie wholly after it.
constexpr double kProjectorSettle_s = 0.2;
constexpr double kLongestSilence_s = 3.0;  // longest time without a pair from the cameras
// Largest median error of points held out from the fit; above it, the scene moved. A still face has less than
// 0.5 px in the virtual room; a movement of 1 mm at 600 mm gives two pixels of a projector of 1280 px.
constexpr double kMovedScene_px = 2.0;

}  // namespace

ProjectorRun::ProjectorRun(const cameras::StereoRig& rig, const stereo::ProjectorCode& code)
    : rig_(rig), code_(code), pictures_(codePictures(code)), next_(pictures_.size()) {
  words_ = "point the projector at a face, or at a wall with something before it, and hold still";
}

void ProjectorRun::startScene() {
  left_.clear();
  right_.clear();
  shown_s_.reset();
  next_ = 0;
  words_ = "nothing may move now";
}

void ProjectorRun::shown(double at_s) {
  if (!shown_s_) shown_s_ = at_s;
}

void ProjectorRun::add(const cameras::StereoFrame& frame) {
  if (!isShowing() || !shown_s_ || frame.captured.s < *shown_s_ + kProjectorSettle_s) return;
  left_.push_back(frame.left.clone());
  right_.push_back(frame.right.clone());
  shown_s_.reset();
  if (++next_ == pictures_.size()) finishScene();
}

void ProjectorRun::wait(double now_s) {
  if (!isShowing() || !shown_s_ || now_s < *shown_s_ + kLongestSilence_s) return;
  next_ = pictures_.size();
  words_ = "the cameras give no picture: check their cables, open them again, and take the scene again";
}

double ProjectorRun::progress() const { return double(next_) / double(pictures_.size()); }

void ProjectorRun::finishScene() {
  const auto left = stereo::decode(left_, code_), right = stereo::decode(right_, code_);
  for (const auto* seen : {&left, &right})
    if (const auto advice = seen->advice(); !advice.empty()) {
      words_ = advice.front();
      return;
    }
  useScene(stereo::matchCodes(rig_, left, right));
}

void ProjectorRun::useScene(const std::vector<stereo::LitPlace>& found) {
  const std::size_t before = places_.size();
  places_.insert(places_.end(), found.begin(), found.end());
  try {
    const auto fitted = stereo::calibrateProjector(places_, code_);
    if (fitted.held_out_px > kMovedScene_px) throw stereo::ProjectorMisfit();
    result_ = fitted;
    words_ = formatted("calibrated: %.2f px, from %.0f to %.0f mm; another scene makes it better",
                       result_->rms_px, result_->nearest_mm, result_->farthest_mm);
  } catch (const stereo::ProjectorMisfit& misfit) {
    places_.resize(before);  // with them, no further scene would fit
    words_ = misfit.what();
  } catch (const Error& error) {
    words_ = error.what();
  }
}

}  // namespace facenav::steps
