// All texts about the cameras: states, diagnoses, checks, corrections.

#include "rig_words.h"

#include <cmath>

#include "check_place.h"
#include "facenav/core/number_text.h"
#include "facenav/core/robust_statistics.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/health/pair_diagnosis.h"

namespace facenav::health {
namespace {

constexpr double kAbsurd = 0.1;  // share of a true length that no camera's motion makes of it

}  // namespace

std::string toString(RigState state) {
  switch (state) {
    case RigState::holds:
      return "holds";
    case RigState::moved:
      return "moved";
    case RigState::other_cameras:
      return "other_cameras";
    case RigState::swapped:
      return "swapped";
    case RigState::out_of_step:
      return "out_of_step";
    case RigState::disagree:
      return "cameras_disagree";
    case RigState::away:
      return "away";
    case RigState::unclear:
      return "unclear";
  }
  return "unclear";
}

RigState rigStateNamed(const std::string& word) {
  for (const auto state : {RigState::holds, RigState::moved, RigState::other_cameras, RigState::swapped,
                           RigState::out_of_step, RigState::disagree, RigState::away})
    if (word == toString(state)) return state;
  return RigState::unclear;
}

bool isFault(RigState state) { return state != RigState::unclear && state != RigState::holds; }

bool isOfTheMoment(RigState state) { return state == RigState::out_of_step || state == RigState::disagree; }

bool isWrongGeometry(RigState state) {
  return state == RigState::moved || state == RigState::other_cameras || state == RigState::swapped;
}

RigVerdict PairDiagnosis::verdict() const {
  switch (state) {
    case RigState::out_of_step:
      return {state, "the two cameras' pictures are of different moments",
              "trigger both cameras together, or check cables and driver"};
    case RigState::swapped:
      return {state, "left and right are exchanged", "exchange the cameras or the folders"};
    case RigState::moved:
      return {state, "the cameras have moved since their calibration",
              "calibrate again; if that does not help, trigger both cameras together"};
    case RigState::other_cameras:
      return {state, "the calibration does not belong to these cameras",
              "give the right stereo.yml, or calibrate"};
    case RigState::disagree:
      return camerasDisagree(residual_px);
    default:
      return {state, {}, {}};
  }
}

RigVerdict camerasDisagree(double off_px) {
  return {RigState::disagree,
          formatted("the pictures do not fit the calibration (%.2f px across the epipolar lines): "
                    "a camera has moved since, or they were taken at two moments",
                    off_px),
          "trigger both cameras together; if they are, calibrate again"};
}

RigVerdict RigEstimate::verdict() const {
  if (!hasMoved()) return {state, {}, {}};
  return {
      state,
      formatted("the cameras have moved since their calibration (%.2f px across the epipolar lines, points "
                "off by %.1f mm)",
                epipolar_px, displaced_mm),
      "calibrate again"};
}

RigVerdict markerContradicts() {
  return {RigState::moved,
          "the coil's marker is not measured at its printed size: a camera has turned since the calibration, "
          "or coil.json names another size",
          "measure the print, or calibrate again"};
}

RigVerdict movedOnMount(double turn_deg) {
  return {RigState::moved,
          "a camera has moved on its mount since the alignment (" + fixed(turn_deg, 2) + " deg)",
          "fix the cameras, then calibrate and align again"};
}

RigVerdict placesDisagree() {
  return {
      RigState::disagree,
      "the two cameras place the face differently: one has moved on its mount since the alignment, or they "
      "expose at different moments",
      "trigger both cameras together; if they are, calibrate again"};
}

std::string inWords(const CorrectedMotion& motion) {
  return "a camera has moved on its mount since the alignment (" + fixed(motion.turn_deg, 2) +
         " deg): corrected by the face, fix the cameras and calibrate again when the patient has left";
}

bool MeasuredLength::contradicts() const { return std::abs(measured_mm - true_mm) > kSignificant * sigma_mm; }

std::string MeasuredLength::words() const {
  const double ratio = measured_mm / true_mm;
  if (!(ratio > kAbsurd && ratio < 1 / kAbsurd))  // rays that hardly meet
    return formatted("%s: cannot be measured with this calibration, %.2f mm true", what.c_str(), true_mm);
  const double off_mm = measured_mm - true_mm;
  return formatted(
      "%s: %.2f mm measured, %.2f mm true: %+.2f mm, %+.2f %% (+-%.2f mm if the calibration holds)",
      what.c_str(), measured_mm, true_mm, off_mm, 100 * off_mm / true_mm, sigma_mm);
}

std::string SquareDoubt::words() const {
  if (is_same_everywhere)
    return formatted(
        "the rows fit, but the length does not, and by the same %+.1f %% at every distance: the squares "
        "measure %.2f mm, not %.2f mm; measure one and give its size again",
        100 * (fitting_mm / given_mm - 1), fitting_mm, given_mm);
  return formatted(
      "the rows fit, but the length does not: check the size of a square first (%.2f mm is given, %.2f mm "
      "would fit); if it is right, a camera has turned sideways: calibrate again",
      given_mm, fitting_mm);
}

bool CheckMotion::isEnough() const {
  const auto rules = settingsOf<RigCheckRules>();
  return moved_mm >= rules.least_moved_mm || turned_deg >= rules.least_turned_deg;
}

std::string CheckMotion::words() const {
  if (isEnough())
    return formatted("it moved %.0f mm and turned %.0f deg between the measurements", moved_mm, turned_deg);
  return formatted("it moved only %.0f mm between the measurements: move it by %.0f mm and measure again",
                   moved_mm, settingsOf<RigCheckRules>().least_moved_mm);
}

std::vector<std::string> RigVerification::findings() const {
  std::vector<std::string> lines;
  lines.push_back(formatted("%d frames; board in %d, marker in %d", frames, board_frames, marker_frames));
  for (const auto& length : lengths) lines.push_back(length.words());
  if (!lengths.empty()) lines.push_back(motion.words());
  if (board_frames + marker_frames > 0)
    lines.push_back(
        formatted("distance of a point from its row in the other picture: %.2f px", row_error_px));
  if (board_frames > 0)
    lines.push_back(formatted("each camera's own picture of the board: left %.2f px, right %.2f px",
                              left_lens_px, right_lens_px));
  return lines;
}

namespace {

std::string holdsWords(const RigVerification& all) {
  std::string words = "the calibration holds";
  for (const auto& length : all.lengths) {
    const double off_mm = length.measured_mm - length.true_mm;
    words += formatted("%s the %s measures %.2f mm, %.2f mm true (%+.2f mm, %+.2f %%)",
                       &length == &all.lengths.front() ? ":" : ",", length.what.c_str(), length.measured_mm,
                       length.true_mm, off_mm, 100 * off_mm / length.true_mm);
  }
  return all.lengths.empty() ? words : words + "; " + all.motion.words();
}

std::string otherLensWords(const RigVerification& all) {
  const std::string cause = "another camera, or its focus or zoom was changed; calibrate again";
  if (std::max(all.left_lens_px, all.right_lens_px) < kOtherLensRms_px)
    return formatted("one picture is larger by %.1f %% than the calibration says: ",
                     100 * std::abs(all.scale_change)) +
           cause;
  return formatted("the %s camera's pictures do not fit its lens (%.2f px): ",
                   all.left_lens_px > all.right_lens_px ? "left" : "right",
                   std::max(all.left_lens_px, all.right_lens_px)) +
         cause;
}

}  // namespace

std::string RigVerification::words() const {
  switch (state) {
    case RigState::holds:
      return holdsWords(*this);
    case RigState::swapped:
      return "left and right are exchanged: swap the two cameras";
    case RigState::other_cameras:
      return otherLensWords(*this);
    case RigState::unclear:
      return "neither board nor marker was seen well enough: hold one still before both cameras and check "
             "again";
    case RigState::moved:
      break;
  }
  if (square_doubt) return square_doubt->words();
  std::string words = "the cameras have moved against each other since their calibration (";
  if (turn_deg > 0) words += formatted("the right one turned by about %.2f deg, ", turn_deg);
  if (shift_mm > 0) words += formatted("moved by about %.1f mm, ", shift_mm);
  for (const auto& length : lengths)
    if (length.contradicts())
      words += formatted("%s measured %.2f mm instead of %.2f mm, ", length.what.c_str(), length.measured_mm,
                         length.true_mm);
  words += formatted("rows %.2f px apart)", row_error_px);
  // A print of another size changes a marker's length like a turned camera.
  return words + (board_frames == 0 && marker_frames > 0
                      ? ", or the coil's marker has another size than its file says: measure the print, or "
                        "calibrate again"
                      : ": calibrate again");
}

}  // namespace facenav::health
