// Choice of a recording's pictures for an alignment: fake aligner, real pictures of a synthetic face.

#include "facenav/align/align_case.h"
#include "facenav/measured_face/projected_dots.h"

#include <gmock/gmock.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <random>

#include "support/ball_case.h"
#include "support/seen_marker.h"
#include "support/synthetic_face.h"
#include "support/test_data.h"

namespace facenav::steps {
namespace {

using facenav::testing::SyntheticFace;
using ::testing::AllOf;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

/// Standard errors that the fake aligner returns in turn; a negative one refuses: a mirrored head.
struct Answers {
  std::vector<double> sigmas_mm;
  std::vector<double> own_log_odds =
      {};                // in turn, of this person's scan; below 6 refused, 0: too little face. Empty: 20
  double apart_mm = 0;   // difference from answer to answer
  bool has_turn = true;  // gives an estimate of the camera's rotation, which is zero
  std::size_t asked = 0;
  registration::AlignmentStart start = {};  // prior knowledge at the last alignment
};

constexpr double kUnclear = 5.5;  // log odds of a face that is too coarse to tell persons apart
constexpr double kMirrored = 4.5, kEitherWay = 4.0;  // of one that fits the mirror image better, or as well

class FakeAligner : public registration::Aligner {
 public:
  explicit FakeAligner(Answers& answers) : answers_(answers) {}
  registration::AlignmentResult align(const registration::ScalpField&, const PointCloud<Camera>& face,
                                      const registration::AlignmentStart& start,
                                      TaskMonitor&) const override {
    answers_.start = start;
    const double sigma_mm = answers_.sigmas_mm.at(answers_.asked++);
    if (sigma_mm < 0) throw Error("not aligned: the MRI is mirrored");
    registration::AlignmentResult result;
    result.own_log_odds = answers_.own_log_odds.empty() ? 20.0 : answers_.own_log_odds.at(answers_.asked - 1);
    if (result.own_log_odds == kUnclear) {
      if (!start.is_patient_confirmed)
        throw registration::PersonUnclear("not aligned: too coarse to tell this person from others", {},
                                          kUnclear);
      result.rests_on_confirmation = true;
    } else if (result.own_log_odds == kMirrored || result.own_log_odds == kEitherWay)
      throw registration::MayBeMirrored("not aligned: the face cannot be distinguished from its mirror image",
                                        "", result.own_log_odds == kMirrored ? -2.8 : 3.0);
    else if (result.own_log_odds == 0)
      throw registration::NotEnoughFace("not aligned: too little of the face");
    if (result.own_log_odds < 6 && !result.rests_on_confirmation)
      throw registration::NotThisPerson("not aligned: the face does not fit this MRI", "",
                                        result.own_log_odds);
    result.covariance.diagonal().tail<3>().setConstant(sigma_mm * sigma_mm / 3);
    if (answers_.has_turn) result.right_turn = registration::CameraTurn{0.0, 1e-4};
    result.points = int(face.size());
    result.residual_mm.assign(face.size(), 0.0);
    result.is_inlier.assign(face.size(), true);
    result.camera_T_mri = {Eigen::Quaterniond::Identity(),
                           {answers_.apart_mm * double(answers_.asked), 0, 600}};
    return result;
  }

 private:
  Answers& answers_;
};

/// Portrait in a dark room with light dots, like a face under a projector.
SyntheticFace dottedFace() {
  cv::Mat portrait = cv::imread(SyntheticFace::portraitPath(), cv::IMREAD_GRAYSCALE);
  portrait *= 0.3;
  std::mt19937 random(4);
  for (int i = 0; i < int(portrait.total() / 6); ++i)
    portrait.at<std::uint8_t>(int(random() % unsigned(portrait.rows)),
                              int(random() % unsigned(portrait.cols))) = 255;
  return SyntheticFace(portrait, {195, 100}, {259, 104});
}

/// Darkens the picture and adds the few dots of a coarse pattern.
cv::Mat sparselyDotted(const cv::Mat& plain) {
  constexpr int kApart_px = 44;
  cv::Mat dotted = 0.3 * plain;
  for (int y = kApart_px / 2; y < dotted.rows; y += kApart_px)
    for (int x = kApart_px / 2; x < dotted.cols; x += kApart_px)
      cv::circle(dotted, {x, y}, 2, cv::Scalar(255), cv::FILLED);
  return dotted;
}

class AlignRecording : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(SyntheticFace::portraitPath())) GTEST_SKIP() << "no portrait (python3-skimage)";
    methods_.aligners.add("fake", "", [this] { return std::make_unique<FakeAligner>(answers_); });
    detector_ = face::makeFaceDetector();
    methods_.head_trackers.add("model", "",
                               [this] { return head_tracking::makeModelHeadTracker(detector_); });
    methods_.face_detector = [this] { return detector_; };
    store_ = casefile::CaseStore::create(folder_.path() / "case", facenav::testing::ballCase(), {}, false);
    recording_.rig = rig_;
  }

  capture::CapturePair pairWith(const SyntheticFace& pattern) const {
    static const SyntheticFace face = SyntheticFace::astronaut();
    return {pattern.render(rig_, {}), face.render(rig_, {})};
  }
  capture::CapturePair dotted() const { return pairWith(dottedFace()); }
  capture::CapturePair plain() const {
    const auto pair = pairWith(SyntheticFace::astronaut());
    return {pair.plain, pair.plain};
  }

  /// A film of the face as it turns a little.
  capture::Recording film(int frames) const {
    const SyntheticFace face = SyntheticFace::astronaut();
    capture::RecordingWriter writer(folder_.path() / "film", rig_);
    for (int i = 0; i < frames; ++i) {
      facenav::testing::SyntheticView view;
      view.seed = std::uint64_t(i + 1);
      view.time_s = i / 30.0;
      view.motion = Eigen::Translation3d(0, 0, 640) *
                    Eigen::AngleAxisd(0.02 * std::sin(0.5 * i), Eigen::Vector3d::UnitY()) *
                    Eigen::Translation3d(0, 0, -640);
      auto frame = face.render(rig_, view);
      frame.number = i;
      frame.captured = Timestamp{i / 30.0};
      writer.add(frame);
    }
    writer.close();
    return capture::openRecording(folder_.path() / "film");
  }

  CaseAlignment align(const capture::Recording& recording,
                      std::optional<measured_face::AlignedFrom> from = {}) {
    TaskMonitor monitor;
    AlignOrder order{"fake"};
    order.from = from;
    order.tries_all = true;
    order.may_be_unsure = may_be_unsure_;
    order.is_patient_confirmed = is_patient_confirmed_;
    order.stored_pair_stands_in = stored_pair_stands_in_;
    return alignRecording(methods_, *store_, recording, order, monitor);
  }
  std::string refusal(const capture::Recording& recording) {
    try {
      align(recording);
    } catch (const Error& error) {
      return error.what();
    }
    return {};
  }

  /// Shows a marker of 60 mm at rest in all pictures.
  void showMarker() {
    methods_.coil_trackers.add("seen", "",
                               [this] { return std::make_unique<facenav::testing::SeenMarker>(rig_); });
  }

  facenav::testing::TemporaryFolder folder_;
  Registrations methods_;
  std::shared_ptr<const face::FaceDetector> detector_;
  std::optional<casefile::CaseStore> store_;
  Answers answers_;
  bool may_be_unsure_ = false, is_patient_confirmed_ = false, stored_pair_stands_in_ = false;
  const cameras::StereoRig rig_ = facenav::testing::faceRig();
  capture::Recording recording_;
};

TEST_F(AlignRecording, AsksAPersonWhereTheFaceIsTooCoarseAndStoresTheAnswer) {
  recording_.capture = plain();
  may_be_unsure_ = true;
  answers_ = {std::vector<double>(8, 0.3), std::vector<double>(8, kUnclear)};
  EXPECT_THROW(align(recording_), registration::PersonUnclear);
  EXPECT_FALSE(store_->alignment()) << "nothing is stored before a person answers";
  is_patient_confirmed_ = true;
  EXPECT_TRUE(align(recording_).outcome.result.rests_on_confirmation);
  ASSERT_TRUE(store_->alignment());
  EXPECT_TRUE(store_->alignment()->rests_on_confirmation);
}

TEST_F(AlignRecording, AsksAPersonWhereNoCoilCanBeOnTarget) {
  recording_.capture = plain();
  may_be_unsure_ = true;
  const double coarse_mm = 4.0, fine_mm = 0.3;
  answers_ = {{coarse_mm}, {10.0}};
  try {
    align(recording_);
    FAIL() << "accepted";
  } catch (const registration::PersonUnclear& error) {
    EXPECT_THAT(error.what(),
                ::testing::HasSubstr("other persons' faces may fit as well; bring the cameras"));
  }
  answers_ = {{fine_mm}, {10.0}};
  EXPECT_FALSE(align(recording_).outcome.result.rests_on_confirmation);
  is_patient_confirmed_ = true;
  answers_ = {{coarse_mm}, {10.0}};
  const auto result = align(recording_).outcome.result;
  EXPECT_TRUE(result.rests_on_confirmation);
  EXPECT_THAT(result.cautions,
              ::testing::Contains(HasSubstr("a person confirmed that this is the patient's own MRI")));
}

TEST_F(AlignRecording, AConfirmationHoldsForTheSamePicturesOnly) {
  recording_.capture = plain();
  may_be_unsure_ = is_patient_confirmed_ = true;
  answers_ = {std::vector<double>(8, 0.3), std::vector<double>(8, kUnclear)};
  align(recording_);
  is_patient_confirmed_ = false;
  EXPECT_THROW(align(recording_), registration::PersonUnclear) << "new pictures, another person perhaps";
  stored_pair_stands_in_ = true;
  recording_.capture.reset();
  EXPECT_TRUE(align(recording_).outcome.result.rests_on_confirmation);
}

TEST_F(AlignRecording, AConfirmationOfTheStoredPairIsNoneOfTheFilm) {
  recording_.capture = plain();
  may_be_unsure_ = is_patient_confirmed_ = true;
  answers_ = {std::vector<double>(12, 0.3), std::vector<double>(12, kUnclear)};
  align(recording_);
  is_patient_confirmed_ = false, stored_pair_stands_in_ = true;
  const auto aligned = align(film(20));
  EXPECT_EQ(aligned.outcome.from, measured_face::AlignedFrom::plain);
  ASSERT_EQ(aligned.tries.size(), 2u);
  EXPECT_EQ(aligned.tries.back().from, measured_face::AlignedFrom::film);
  EXPECT_THAT(aligned.tries.back().refusal, ::testing::HasSubstr("too coarse"));
}

TEST_F(AlignRecording, AConfirmationThatWasNotNeededIsNotStored) {
  recording_.capture = plain();
  may_be_unsure_ = is_patient_confirmed_ = true;
  answers_ = {{0.3}, {20.0}};
  align(recording_);
  EXPECT_FALSE(store_->alignment().value().rests_on_confirmation);
}

TEST_F(AlignRecording, OfDotsAndPlainSkinUsesWhatPromisesLessErrorAndSaysWhatTheOtherWouldGive) {
  recording_.capture = dotted();
  ASSERT_TRUE(measured_face::showsDots(*recording_.capture));
  answers_.sigmas_mm = {0.3, 0.6, 0.9, 0.4};
  const auto by_dots = align(recording_);
  EXPECT_EQ(by_dots.outcome.from, measured_face::AlignedFrom::dots);
  ASSERT_EQ(by_dots.tries.size(), 2u);
  EXPECT_THAT(inWords(by_dots), ::testing::AllOf(HasSubstr("used the pair with dots: 95 % within 0.5 mm"),
                                                 HasSubstr("the plain pair would give 95 % within 1.0 mm")));
  EXPECT_EQ(store_->alignment()->from, "dots");
  EXPECT_EQ(align(recording_).outcome.from, measured_face::AlignedFrom::plain);
  EXPECT_EQ(store_->alignment()->from, "plain");
}

TEST_F(AlignRecording, SaysWhereDotsAndPlainSkinContradictEachOther) {
  recording_.capture = dotted();
  answers_.sigmas_mm = {0.3, 0.3, 0.3, 0.3};
  answers_.apart_mm = 0.5;
  EXPECT_TRUE(align(recording_).outcome.result.cautions.empty()) << "as their bounds allow";
  answers_.apart_mm = 5;
  align(recording_);
  ASSERT_EQ(store_->alignment()->cautions.size(), 1u);
  EXPECT_THAT(store_->alignment()->cautions.front(), HasSubstr("5.0 mm apart"));
}

TEST_F(AlignRecording, APlainPairIsEnough) {
  recording_.capture = plain();
  answers_.sigmas_mm = {0.5};
  const auto aligned = align(recording_);
  EXPECT_EQ(aligned.outcome.from, measured_face::AlignedFrom::plain);
  EXPECT_GT(aligned.outcome.result.points, 5000);
  EXPECT_EQ(aligned.outcome.reference.surface.size(), aligned.outcome.reference.surface_left_px.size());
}

TEST_F(AlignRecording, BesideSparseDotsThePlainPairIsTried) {
  recording_.capture = plain();
  cameras::StereoFrame& pattern = recording_.capture->pattern;
  pattern.left = sparselyDotted(pattern.left);
  pattern.right = sparselyDotted(pattern.right);
  ASSERT_TRUE(measured_face::showsDots(*recording_.capture));
  ASSERT_TRUE(measured_face::areDotsSparse(*recording_.capture));
  answers_.sigmas_mm = {0.9, 0.3};
  showMarker();
  TaskMonitor monitor;
  const auto aligned = alignRecording(methods_, *store_, recording_, {"fake"}, monitor);
  EXPECT_EQ(aligned.outcome.from, measured_face::AlignedFrom::plain);
  EXPECT_EQ(aligned.tries.size(), 2u);
}

TEST_F(AlignRecording, DotsThatStandAreEnough) {
  TaskMonitor monitor;
  recording_.capture = dotted();
  answers_.sigmas_mm = {0.6, 0.1};
  EXPECT_EQ(alignRecording(methods_, *store_, recording_, {"fake"}, monitor).outcome.from,
            measured_face::AlignedFrom::dots);
  EXPECT_EQ(answers_.asked, 1u);
}

TEST_F(AlignRecording, DotsWithAWideBoundAreComparedWithThePlainPairByTheirBounds) {
  TaskMonitor monitor;
  recording_.capture = dotted();
  showMarker();
  answers_.sigmas_mm = {3.0, 0.5, 3.0, 2.9};
  EXPECT_EQ(alignRecording(methods_, *store_, recording_, {"fake"}, monitor).outcome.from,
            measured_face::AlignedFrom::plain);
  EXPECT_EQ(alignRecording(methods_, *store_, recording_, {"fake"}, monitor).outcome.from,
            measured_face::AlignedFrom::dots)
      << "not clearly better";
  EXPECT_EQ(answers_.asked, 4u);
}

TEST_F(AlignRecording, WhatOnePairCannotShowAnotherShows) {
  TaskMonitor monitor;
  recording_.capture = dotted();
  showMarker();
  answers_.sigmas_mm = {0.5, 0.5, 0.5};
  answers_.own_log_odds = {2, 2, 30};  // a refused face is fitted once more without the landmarks
  const auto aligned = alignRecording(methods_, *store_, recording_, {"fake"}, monitor);
  EXPECT_EQ(aligned.outcome.from, measured_face::AlignedFrom::plain);
  EXPECT_THAT(aligned.tries.front().refusal, HasSubstr("does not fit"));
}

TEST_F(AlignRecording, WhereOnePairIsUndecidedAndAnotherHardlySureAPersonIsAsked) {
  TaskMonitor monitor;
  recording_.capture = dotted();
  showMarker();
  answers_.sigmas_mm.assign(6, 0.5);
  answers_.own_log_odds = {2, 2, 7, 2, 2, 7};
  EXPECT_THROW(alignRecording(methods_, *store_, recording_, {"fake"}, monitor), registration::PersonUnclear);
  EXPECT_FALSE(store_->alignment());
  AlignOrder confirmed{"fake"};
  confirmed.is_patient_confirmed = true;
  const auto aligned = alignRecording(methods_, *store_, recording_, confirmed, monitor);
  EXPECT_TRUE(aligned.outcome.result.rests_on_confirmation);
  EXPECT_TRUE(store_->alignment()->rests_on_confirmation);
}

TEST_F(AlignRecording, APersonIsAskedWhereBothPairsTogetherSpeakForThePatient) {
  TaskMonitor monitor;
  recording_.capture = dotted();
  showMarker();
  answers_.sigmas_mm.assign(8, 0.5);
  answers_.own_log_odds = {kUnclear, kUnclear, -4, -4, kUnclear, kUnclear, -5.9, -5.9};
  EXPECT_THROW(alignRecording(methods_, *store_, recording_, {"fake"}, monitor), registration::PersonUnclear);
  EXPECT_THAT(refusal(recording_), HasSubstr("does not fit this MRI"));  // 5.5 - 5.9 speaks against
  EXPECT_FALSE(store_->alignment());
}

TEST_F(AlignRecording, WhereOnePairShowsTooLittleAnotherIsTried) {
  TaskMonitor monitor;
  recording_.capture = dotted();
  showMarker();
  answers_.sigmas_mm = {0.5, 0.5, 0.5};
  answers_.own_log_odds = {0, 0, 30};
  const auto aligned = alignRecording(methods_, *store_, recording_, {"fake"}, monitor);
  EXPECT_EQ(aligned.outcome.from, measured_face::AlignedFrom::plain);
}

TEST_F(AlignRecording, WhatOnePairSaysAgainstThePersonAnotherMustOutweigh) {
  recording_.capture = dotted();
  showMarker();
  answers_.sigmas_mm = {0.5, 0.5, 0.5, 3.0, 0.5, 0.5, 0.5, 0.5};
  answers_.own_log_odds = {-4, -4, 9, 9, -4, -4, -20, -20};
  EXPECT_THAT(refusal(recording_), HasSubstr("does not fit this MRI"));  // 9 - 4 is too little
  EXPECT_THAT(refusal(recording_), HasSubstr("does not fit this MRI")) << "in the other order";
  EXPECT_EQ(answers_.asked, 6u);
  EXPECT_THAT(refusal(recording_), HasSubstr("does not fit this MRI"))
      << "clearly another: nothing else is tried";
  EXPECT_EQ(answers_.asked, 8u);
  EXPECT_FALSE(store_->alignment());
}

TEST_F(AlignRecording, AFaceThatFitsTheMirrorImageBetterIsNotAlignedByOtherPicturesAlone) {
  TaskMonitor monitor;
  recording_.capture = dotted();
  showMarker();
  answers_.sigmas_mm.assign(9, 0.5);
  answers_.own_log_odds = {kMirrored, kMirrored, 30, kMirrored, kMirrored, 30, kEitherWay, kEitherWay, 30};
  EXPECT_THAT(refusal(recording_), HasSubstr("cannot be distinguished from its mirror image"));
  EXPECT_FALSE(store_->alignment());
  AlignOrder confirmed{"fake"};
  confirmed.is_patient_confirmed = true;
  EXPECT_TRUE(
      alignRecording(methods_, *store_, recording_, confirmed, monitor).outcome.result.rests_on_confirmation);
  EXPECT_EQ(alignRecording(methods_, *store_, recording_, {"fake"}, monitor).outcome.from,
            measured_face::AlignedFrom::plain)
      << "undecided is not against it";
}

TEST_F(AlignRecording, WithoutDotsTheCamerasMustBeKnownOtherwise) {
  recording_.capture = plain();
  answers_.sigmas_mm = {3.0, 0.5, 0.5, 0.5, 0.5, 0.5};
  EXPECT_THAT(refusal(recording_), AllOf(HasSubstr("the coil could lie 5 mm from where it is shown"),
                                         HasSubstr("hold the coil still beside the face")));
  answers_.has_turn = false;
  EXPECT_THAT(refusal(recording_), HasSubstr("hold the coil still beside the face"));
  EXPECT_FALSE(store_->alignment());
  EXPECT_THROW(align(recording_, measured_face::AlignedFrom::plain), Error)
      << "asked for, but not for trials";
  may_be_unsure_ = true;
  EXPECT_EQ(align(recording_).outcome.from, measured_face::AlignedFrom::plain);
  EXPECT_THAT(store_->alignment()->cautions, ::testing::Contains(std::string(kWithoutDotsCaution)));
  may_be_unsure_ = false;
  showMarker();
  EXPECT_THAT(refusal(recording_), HasSubstr("whether a camera has turned"))
      << "an aligner that fits no turn does not use the marker";
  answers_.has_turn = true;
  EXPECT_TRUE(align(recording_).outcome.is_marker_seen);
  EXPECT_TRUE(store_->alignment()->cautions.empty());
}

TEST_F(AlignRecording, PicturesOfAProjectorThatWasOffAreAPlainPair) {
  recording_.capture = plain();
  facenav::testing::SyntheticView other;
  other.seed = 5;
  recording_.capture->pattern = SyntheticFace::astronaut().render(rig_, other);
  answers_.sigmas_mm = {3.0, 3.0, 0.5};
  EXPECT_THAT(refusal(recording_), HasSubstr("switch the projector on: its picture shows no dots"));
  EXPECT_THROW(align(recording_, measured_face::AlignedFrom::dots), Error) << "asked for as dots";
  showMarker();
  const auto aligned = align(recording_);
  EXPECT_EQ(aligned.outcome.from, measured_face::AlignedFrom::plain);
  EXPECT_EQ(aligned.tries.size(), 1u);
}

TEST_F(AlignRecording, WhatTheDotsRefuseNoOtherPictureMayAccept) {
  recording_.capture = dotted();
  answers_.sigmas_mm = {-1, -1, 0.1};  // once more without the landmarks, then it is final
  EXPECT_THROW(align(recording_), Error);
  EXPECT_EQ(answers_.asked, 2u);
  EXPECT_FALSE(store_->alignment());
}

TEST_F(AlignRecording, AFilmStandsInWhereThereIsNoPairAndKeepsItsFirstFrame) {
  const auto recording = film(8);
  answers_.sigmas_mm = {0.4};
  const auto aligned = align(recording);
  EXPECT_EQ(aligned.outcome.from, measured_face::AlignedFrom::film);
  EXPECT_GT(aligned.outcome.fused_frames, 4);
  EXPECT_EQ(aligned.outcome.reference.frame.number, 0);
  EXPECT_EQ(store_->alignment()->from, "film");
}

TEST_F(AlignRecording, AMeasuredFaceBringsItsOwnErrors) {
  recording_.capture = plain();
  showMarker();
  answers_.sigmas_mm.assign(8, 0.5);
  auto face = facenav::testing::ballCase().scalp;
  const auto alignTo = [&](const std::optional<surface::FaceMeasurement>& measurement, const char* name) {
    face.measurement = measurement;
    store_ = casefile::CaseStore::createFromFace(folder_.path() / name, {face, {}}, {}, false);
    align(recording_);
    return answers_.start;
  };
  const auto exact = alignTo(std::nullopt, "exact");
  const auto measured = alignTo(surface::FaceMeasurement{9000, 0.6, 0.3, 0.4, 0.004}, "measured");
  const auto added = [](double with, double without) { return std::sqrt(with * with - without * without); };
  EXPECT_NEAR(added(measured.shared_depth_sigma_mm, exact.shared_depth_sigma_mm), 0.4, 1e-6);
  EXPECT_NEAR(added(measured.sight.sigma_mm, exact.sight.sigma_mm), 0.3, 1e-6);
  // A size error of 0.4 % equals that of a camera that turned by 0.004 * baseline / distance.
  EXPECT_NEAR(added(measured.known_turn->sigma_rad, exact.known_turn->sigma_rad), 0.004 * 120 / 600, 1e-4);
  answers_.sigmas_mm.assign(8, 3.0);
  try {
    alignTo(surface::FaceMeasurement{9000, 0.6, 0.3, 0.4}, "of unknown size");
    FAIL() << "the marker does not tell how the cameras stood when the face was measured";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("the stored face was measured without the coil's marker"));
  }
  EXPECT_FALSE(answers_.start.known_turn);
}

TEST_F(AlignRecording, AWayThatIsAskedForNeedsItsPictures) {
  EXPECT_THROW(align(recording_, measured_face::AlignedFrom::plain), Error);
  EXPECT_THROW(align(recording_, measured_face::AlignedFrom::film), Error);
}

}  // namespace
}  // namespace facenav::steps
