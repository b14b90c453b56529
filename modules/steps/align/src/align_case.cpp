#include "facenav/align/align_case.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "facenav/align/face_model.h"
#include "facenav/align/film_beginning.h"
#include "facenav/align/known_lengths.h"
#include "facenav/align/stored_capture.h"
#include "facenav/casefile/file_group.h"
#include "facenav/casefile/skin_fit_file.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/settings_in_force.h"
#include "facenav/measured_face/projected_dots.h"
#include "facenav/pictures/skin_fit_picture.h"
#include "facenav/prepare/case_pictures.h"
#include "facenav/registration/fit_limits.h"
#include "facenav/session/navigation_state.h"

namespace facenav::steps {
namespace {

/// Ratio of bounds below which pictures with less prior trust are used.
constexpr double kClearlyBetter = 0.85;
// Largest bound (95 %) of an alignment without dots and without a marker: that of a wrong pose. Dense dots
// with a wider bound do not settle the choice either.
constexpr double kMostUnknown_mm = 3.0;

/// An alignment, with its pictures for the case.
struct Aligned {
  AlignmentOutcome outcome;
  capture::CapturePair pictures;
};

/// True if the capture has another picture for the dots, whether or not the dots are seen.
bool hasPattern(const capture::CapturePair& capture) {
  const cv::Mat &dots = capture.pattern.left, &plain = capture.plain.left;
  return !dots.empty() && (dots.size() != plain.size() || cv::norm(dots, plain, cv::NORM_INF) > 0);
}

/// True if the pair shows dots, on the face or anywhere.
bool areDotsSeen(const capture::Recording& recording, const face::FaceDetector& detector) {
  if (!recording.capture || !hasPattern(*recording.capture)) return false;
  const auto face = measured_face::findFace(recording.rig, recording.capture->plain, detector).left;
  return measured_face::showsDots(*recording.capture) ||
         (face && measured_face::showsDots(*recording.capture, face->face));
}

/// Lists the ways for which the recording has pictures. If the projector was off, they are a plain pair.
std::vector<measured_face::AlignedFrom> waysOf(const capture::Recording& recording, bool shows_dots) {
  std::vector<measured_face::AlignedFrom> ways;
  if (shows_dots) ways.push_back(measured_face::AlignedFrom::dots);
  if (recording.capture) ways.push_back(measured_face::AlignedFrom::plain);
  if (recording.frame_count > 1) ways.push_back(measured_face::AlignedFrom::film);
  return ways;
}

std::string inWords(measured_face::AlignedFrom from) {
  switch (from) {
    case measured_face::AlignedFrom::dots:
      return "the pair with dots";
    case measured_face::AlignedFrom::plain:
      return "the plain pair";
    default:
      return "the film";
  }
}

void requirePictures(const capture::Recording& recording, measured_face::AlignedFrom from) {
  const bool has_pair = recording.capture.has_value();
  if (from == measured_face::AlignedFrom::film ? recording.frame_count > 1 : has_pair) return;
  throw Error("not aligned: the recording has no " +
                  std::string(from == measured_face::AlignedFrom::film ? "film" : "capture/ pair"),
              recording.folder.string(), "choose another way (dots, plain, film), or record one");
}

Aligned align(const Registrations& methods, const capture::Recording& recording,
              measured_face::AlignedFrom from, const AlignOrder& order, const AlignmentSetup& setup,
              TaskMonitor& monitor) {
  if (from != measured_face::AlignedFrom::film)
    return {alignFromCapture(recording.rig, *recording.capture, from, setup, monitor), *recording.capture};
  const auto& trackers = methods.head_trackers;
  const auto tracker =
      trackers.create(order.head_tracker.empty() ? trackers.defaultName() : order.head_tracker);
  const auto film = capture::makeSource(recording);
  const auto [first, last] = beginningOf(recording, &setup.detector);
  Aligned aligned{alignFromFilm(*film, first, last, *tracker, setup, monitor), {}};
  aligned.pictures = {aligned.outcome.reference.frame, aligned.outcome.reference.frame};
  return aligned;
}

/// Returns the pair that the case was aligned with, unless it is a single frame of a film: this recording's
/// own film has more information.
std::optional<capture::CapturePair> storedPair(const casefile::CaseStore& store,
                                               const capture::Recording& recording) {
  const auto alignment = store.alignment();
  if (alignment && alignment->from == measured_face::nameOf(measured_face::AlignedFrom::film))
    return std::nullopt;
  return readStoredCapture(store.folder(), recording.rig);
}

double worstBound_mm(const AlignmentOutcome& outcome) {
  double worst = 0;
  for (const auto& [ignored, bound_mm] : outcome.predicted_tre_p95_mm) worst = std::max(worst, bound_mm);
  if (!outcome.predicted_tre_p95_mm.empty()) return worst;
  return outcome.result.errorBound_mm(Point<Mri>(outcome.scalp->middle_mm()));
}

/// Refusal because a camera may have turned sideways since the calibration.
class UnknownTurn : public NotMeasured {
 public:
  using NotMeasured::NotMeasured;
};

/// `was_projector_off`: there are pictures for the dots, and they show none.
void requireKnownCameras(const AlignmentOutcome& outcome, bool was_projector_off) {
  const double bound_mm = worstBound_mm(outcome);
  // An aligner that fits no turn does not use the marker either.
  if (outcome.result.right_turn && (outcome.is_marker_seen || bound_mm <= kMostUnknown_mm)) return;
  std::string words =
      "not aligned: without dots the face alone does not show whether a camera has turned sideways since the "
      "calibration";
  if (outcome.result.right_turn)
    words += formatted(": the coil could lie %.0f mm from where it is shown", bound_mm);
  if (outcome.is_marker_contradicted) throw UnknownTurn(words + "; " + kMarkerContradicted);
  if (isSizeUnknown(*outcome.skin)) throw UnknownTurn(words + "; " + kSizeUnknown);
  words += "; hold the coil still beside the face, its marker to both cameras, and take the pictures again";
  words += was_projector_off ? " (or switch the projector on: its picture shows no dots)"
                             : " (or with a projector's dots)";
  throw UnknownTurn(words);
}

bool isBetter(const AlignmentTry& other, const AlignmentTry& than) {
  return *other.bound_mm < kClearlyBetter * *than.bound_mm;
}

/// Caution where two ways place the head, at one moment, farther apart than both bounds.
std::optional<std::string> contradiction(const CaseAlignment& alignment, const Point<Mri>& at) {
  const AlignmentTry *dots = nullptr, *plain = nullptr;
  for (const AlignmentTry& tried : alignment.tries)
    if (tried.camera_T_mri && tried.from != measured_face::AlignedFrom::film)
      (tried.from == measured_face::AlignedFrom::dots ? dots : plain) = &tried;
  if (!dots || !plain) return std::nullopt;
  const double apart_mm = ((*dots->camera_T_mri * at).mm - (*plain->camera_T_mri * at).mm).norm();
  if (apart_mm <= *dots->bound_mm + *plain->bound_mm) return std::nullopt;
  return "with and without dots the head lies " + fixed(apart_mm, 1) +
         " mm apart: check that it did not move in between, and take the pictures again";
}

std::string inWords(const AlignmentTry& tried) {
  if (!tried.bound_mm) return inWords(tried.from) + " was refused (" + tried.refusal + ")";
  return inWords(tried.from) + " would give 95 % within " + fixed(*tried.bound_mm, 1) + " mm";
}

/// Replaces the MRI by the stored face in the words for a case without an MRI.
std::string inWordsOf(const casefile::CaseStore& store, std::string words) {
  if (store.hasMri()) return words;
  for (const char* mri : {"this is the patient's own MRI", "this MRI", "the MRI", "this scan", "the scan"})
    for (std::size_t at; (at = words.find(mri)) != std::string::npos;)
      words.replace(at, std::string(mri).size(),
                    std::string(mri).rfind("this is", 0) == 0 ? "this is the person whose face is stored"
                                                              : "the stored face");
  return words;
}

/// Log odds from which on a scan is this person's. The same number below zero shows another person's scan.
double leastOwn() { return settingsOf<registration::FitLimits>().least_own; }

/// The ways tried so far.
struct Attempts {
  explicit Attempts(bool is_patient_confirmed) : is_patient_confirmed_(is_patient_confirmed) {}
  std::vector<AlignmentTry> tries;
  bool hasDenseDots() const { return best_ && best_->outcome.has_dense_dots; }
  /// True if dense dots fix the pose so well that no other pictures are needed.
  bool isSettled() const { return hasDenseDots() && *tries[used_].bound_mm <= kMostUnknown_mm; }
  void add(measured_face::AlignedFrom from, const casefile::CaseStore& store,
           const std::function<Aligned()>& align);
  /// Returns the best way. If none is accepted, throws the most informative error.
  Aligned best(const casefile::CaseStore& store, const capture::Recording& recording);

 private:
  void take(Aligned aligned);
  void weigh(const Error& undecided, double own_log_odds);
  std::optional<std::string> doubt() const;
  std::optional<Aligned> best_;
  std::size_t used_ = 0;
  bool is_patient_confirmed_;
  std::optional<Error> error_;
  std::optional<Error> mirrored_;                       // of a way whose face may fit the mirror image better
  bool is_turn_unknown_ = false;                        // error_ says so
  bool has_head_moved_ = false;                         // likewise: with a still head the dots would do
  std::optional<registration::PersonUnclear> unclear_;  // of the way that speaks for this person most
  std::optional<Error> undecided_;  // of the way with the least log odds of this person's scan
  double least_own_ = 0.0;          // those log odds
};

void Attempts::take(Aligned aligned) {
  AlignmentTry& now = tries.back();
  now.bound_mm = worstBound_mm(aligned.outcome);
  now.camera_T_mri = aligned.outcome.result.camera_T_mri;
  if (best_ && !isBetter(now, tries[used_])) return;
  used_ = tries.size() - 1;
  best_ = std::move(aligned);
}

void Attempts::add(measured_face::AlignedFrom from, const casefile::CaseStore& store,
                   const std::function<Aligned()>& align) {
  tries.push_back({from, {}, {}});
  AlignmentTry& now = tries.back();
  try {
    take(align());
  } catch (const Cancelled&) {
    throw;
  } catch (const HeadMoved& error) {
    error_ = error, has_head_moved_ = true;
    now.refusal = error.what();
  } catch (const UnknownTurn& error) {  // contains advice for use with or without a projector
    if (!has_head_moved_) error_ = error, is_turn_unknown_ = true;
    now.refusal = error.what();
  } catch (const NotMeasured& error) {
    if (!error_) error_ = error;
    now.refusal = error.what();
  } catch (const registration::Mirrored& error) {
    throw Error(inWordsOf(store, error.what()));
  } catch (const registration::MayBeMirrored& error) {
    if (!error_) error_ = error;
    now.refusal = error.what();
    if (error.mirror_log_odds < 0) mirrored_ = error;
  } catch (const registration::NotEnoughFace& error) {
    if (!error_) error_ = error;
    now.refusal = error.what();
  } catch (const registration::PersonUnclear& error) {
    if (!is_turn_unknown_) error_ = error;
    if (!unclear_ || error.own_log_odds > unclear_->own_log_odds) unclear_ = error;
    now.refusal = error.what();
    weigh(error, error.own_log_odds);
  } catch (const registration::NotThisPerson& error) {
    now.refusal = error.what();
    if (!best_ && error.own_log_odds < -leastOwn()) throw Error(inWordsOf(store, now.refusal));
    if (!is_turn_unknown_) error_ = error;
    weigh(error, error.own_log_odds);
  } catch (const Error& error) {
    const std::string words = inWordsOf(store, error.what());
    if (!best_ && words != error.what()) throw Error(words);
    // Another head or moved cameras: no other pictures may be accepted instead.
    if (!best_) throw;
    now.refusal = error.what();
  }
}

void Attempts::weigh(const Error& undecided, double own_log_odds) {
  if (!undecided_ || own_log_odds < least_own_) undecided_ = undecided, least_own_ = own_log_odds;
}

/// Words of a way that leaves open whether the scan is this person's, although the best one is accepted. A
/// coarse face may fit another head, or its own mirror image, by chance in one of several ways.
std::optional<std::string> Attempts::doubt() const {
  if (best_->outcome.result.rests_on_confirmation) return std::nullopt;  // a person has decided already
  if (mirrored_) return mirrored_->what();
  const double mean_log_odds = 0.5 * (best_->outcome.result.own_log_odds + least_own_);
  if (undecided_ && mean_log_odds < leastOwn()) return undecided_->what();
  // Where no coil can be on target, other persons' faces, and mirrored ones, fit as well.
  const double bound_mm = *tries[used_].bound_mm;
  if (bound_mm > session::kMostErrorBound_mm)
    return registration::PersonUnclear(
               "not aligned: " +
                   formatted("the face fits this MRI, but only to %.1f mm, where other persons' "
                             "faces may fit as well",
                             bound_mm),
               "bring the cameras nearer, project dots, and keep hair and hands off the face; or check name "
               "and date "
               "of birth, and confirm that this is the patient's own MRI")
        .what();
  return std::nullopt;
}

Aligned Attempts::best(const casefile::CaseStore& store, const capture::Recording& recording) {
  // All ways show one head. If one way speaks against this person, the best one must speak for it more
  // strongly.
  const double least = is_patient_confirmed_ ? 0.0 : leastOwn(), against = std::min(0.0, least_own_);
  const bool is_this_person = best_ && (against >= 0 || best_->outcome.result.own_log_odds + against > least);
  if (is_this_person) {
    const auto words = doubt();
    if (words && !is_patient_confirmed_) throw registration::PersonUnclear(inWordsOf(store, *words));
    if (words) {
      auto& result = best_->outcome.result;
      result.rests_on_confirmation = true;
      result.cautions.push_back(
          inWordsOf(store,
                    "the face was measured too coarsely to tell this person from others: a person confirmed "
                    "that this is the patient's own MRI"));
    }
    return std::move(*best_);
  }
  if (unclear_ && !is_turn_unknown_ && unclear_->own_log_odds + against > 0)
    throw registration::PersonUnclear(inWordsOf(store, unclear_->what()));
  if (error_) throw Error(inWordsOf(store, error_->what()));
  throw Error("not aligned: the recording has no pictures of the face", recording.folder.string(),
              "record a still pair (facenav record --capture) or a film of the face");
}

}  // namespace

void storeAlignment(const casefile::CaseStore& store, const cameras::StereoRig& rig,
                    const capture::CapturePair& capture, const AlignmentOutcome& outcome) {
  casefile::FileGroup group(store.folder());
  writeStoredCapture(group, rig, capture);
  if (store.hasMri() && outcome.from != measured_face::AlignedFrom::dots)
    keepFace(rig, outcome, group.staging());
  casefile::writeSkinFit(outcome.result, outcome.face.cloud, group.staging() / "skin_fit.vtp");
  writePrivatePng(pictures::drawSkinFit(capture.plain.left, outcome.face, outcome.result),
                  group.staging() / "skin_fit.png");
  casefile::writeAlignment(outcome.stored(), group.staging() / "alignment.json");
  group.commit("alignment.json");
}

CaseAlignment alignRecording(const Registrations& methods, const casefile::CaseStore& store,
                             const capture::Recording& given, const AlignOrder& order, TaskMonitor& monitor) {
  capture::Recording recording = given;
  bool was_confirmed = false;  // of the person in the stored pair, not of the one in a new film
  if (!recording.capture && order.stored_pair_stands_in) {
    recording.capture = storedPair(store, recording);
    was_confirmed = recording.capture && store.alignment()->rests_on_confirmation;
  }
  const auto detector = methods.face_detector();
  const auto aligner = methods.aligners.create(order.aligner);
  const auto scalp = store.scalp();
  const auto targets = store.targets().targets;
  std::unique_ptr<coil_tracking::CoilTracker> coil_tracker;  // a program may have none
  if (!methods.coil_trackers.entries().empty())
    coil_tracker = methods.coil_trackers.create(methods.coil_trackers.defaultName());
  AlignmentSetup setup{scalp,
                       *aligner,
                       *detector,
                       targets,
                       store.scalpField(),
                       order.matcher,
                       order.coil ? *order.coil : coilNamedIn({recording.folder, store.folder()}),
                       coil_tracker.get()};
  if (order.from) requirePictures(recording, *order.from);
  const bool shows_dots = areDotsSeen(recording, *detector);
  const bool was_projector_off = !shows_dots && recording.capture && hasPattern(*recording.capture);
  Attempts attempts(order.is_patient_confirmed);
  bool was_marker_sought = false;
  for (const measured_face::AlignedFrom from :
       order.from ? std::vector{*order.from} : waysOf(recording, shows_dots)) {
    if (attempts.isSettled() && (!order.tries_all || from == measured_face::AlignedFrom::film)) break;
    const bool has_dots = from == measured_face::AlignedFrom::dots && shows_dots;
    setup.is_patient_confirmed =
        order.is_patient_confirmed || (was_confirmed && from != measured_face::AlignedFrom::film);
    if (!has_dots && coil_tracker && !std::exchange(was_marker_sought, true))
      setup.marker = restingMarkerIn(recording, setup.coil, *coil_tracker);
    attempts.add(from, store, [&] {
      Aligned aligned = align(methods, recording, from, order, setup, monitor);
      if (!has_dots && !order.may_be_unsure) requireKnownCameras(aligned.outcome, was_projector_off);
      return aligned;
    });
  }
  Aligned best = attempts.best(store, recording);
  CaseAlignment result{std::move(best.outcome), std::move(attempts.tries)};
  const Point<Mri> at =
      targets.empty() ? Point<Mri>(result.outcome.scalp->middle_mm()) : targets.front().cortex_point;
  if (result.outcome.from != measured_face::AlignedFrom::dots && !result.outcome.is_marker_seen &&
      !result.outcome.result.right_turn)
    result.outcome.result.cautions.push_back(kWithoutDotsCaution);
  if (const auto words = contradiction(result, at)) result.outcome.result.cautions.push_back(*words);
  storeAlignment(store, recording.rig, best.pictures, result.outcome);
  return result;
}

std::string inWords(const CaseAlignment& alignment) {
  std::string words;
  for (const AlignmentTry& tried : alignment.tries)
    if (tried.from == alignment.outcome.from)
      words = "used " + inWords(tried.from) + ": " + "95 % within " + fixed(*tried.bound_mm, 1) + " mm";
  for (const AlignmentTry& tried : alignment.tries)
    if (tried.from != alignment.outcome.from) words += "; " + inWords(tried);
  return words;
}

}  // namespace facenav::steps
