#include "camera_doubts.h"

#include "facenav/health/pair_diagnosis.h"
#include "facenav/health/rig_error.h"
#include "facenav/measured_face/projected_dots.h"
#include "facenav/registration/aligner.h"

namespace facenav::steps {

std::exception_ptr failureOf(const std::function<void()>& task) {
  try {
    task();
    return nullptr;
  } catch (const health::RigError&) {
    throw;
  } catch (const Cancelled&) {
    throw;
  } catch (const Error&) {
    return std::current_exception();
  }
}

std::string wordsOf(const std::exception_ptr& failure) {
  try {
    std::rethrow_exception(failure);
  } catch (const Error& error) {
    return error.what();
  }
}

[[noreturn]] void refuseAlignment(const cameras::StereoRig& rig, const capture::CapturePair& capture,
                                  measured_face::AlignedFrom from, const std::exception_ptr& failure,
                                  bool is_measured, const std::string& matcher,
                                  const std::optional<face::FaceLandmarks>& face) {
  try {
    std::rethrow_exception(failure);
  } catch (const registration::PersonUnclear&) {
    throw;  // the face fits: nothing about the cameras is to be explained
  } catch (const Error&) {
  }
  const auto diagnosis =
      health::diagnosePair(rig, capture.plain, face ? face::outlineOf(*face) : std::vector<cv::Point>());
  // Stripes and wallpaper match in wrong places too, as if they were of two moments: only the face explains.
  const bool is_told = diagnosis.is_of_face || diagnosis.state != health::RigState::out_of_step;
  if (diagnosis.isFault() && is_told) throw health::RigError(diagnosis.verdict(), "not aligned: ");
  if (from != measured_face::AlignedFrom::dots || measured_face::showsDots(capture) ||
      (face && measured_face::showsDots(capture, face->face))) {
    if (is_measured) std::rethrow_exception(failure);
    throw NotMeasured(wordsOf(failure));
  }
  std::string reason = wordsOf(failure);
  const std::string prefix = "not aligned: ";
  if (reason.rfind(prefix, 0) == 0) reason.erase(0, prefix.size());
  const bool is_default = matcher == stereo::kDefaultMatcher;
  throw Error(prefix + "the capture's picture for the dots shows none, or too few (switch the projector on" +
              (is_default ? "" : ": the matcher '" + matcher + "' needs them") +
              "); without them: " + reason);
}

}  // namespace facenav::steps
