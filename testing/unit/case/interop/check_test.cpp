#include "facenav/interop/check.h"

#include <gmock/gmock.h>

#include "support/refusal.h"
#include "two_forms.h"

namespace facenav::interop {
namespace {

using facenav::testing::refusalOf;
using ::testing::HasSubstr;
using namespace interop::testing;

Eigen::Matrix4d soundMatrix() { return truth().at("M1 hand L").matrix(); }

std::string refusalOfPose(const Eigen::Matrix4d& pose) {
  return refusalOf([&] { soundPose(pose, nullptr); });
}

TEST(SoundPose, RefusesWhatIsNoPoseAndSaysWhy) {
  Eigen::Matrix4d pose = soundMatrix();
  pose(1, 3) = std::nan("");
  EXPECT_THAT(refusalOfPose(pose), HasSubstr("no finite number"));
  pose = soundMatrix();
  pose.topLeftCorner<3, 3>() *= -1;
  EXPECT_THAT(refusalOfPose(pose), HasSubstr("left-handed (determinant -1.00)"));
  pose = soundMatrix();
  pose.col(1) *= 1.05;
  EXPECT_THAT(refusalOfPose(pose), HasSubstr("y axis has the length 1.050"));
  pose = soundMatrix();
  pose.block<3, 1>(0, 0) = expRotation({0, 0.05, 0.05}) * pose.block<3, 1>(0, 0);
  EXPECT_THAT(refusalOfPose(pose), HasSubstr("deg from right angles"));
  pose = soundMatrix();
  pose(3, 0) = 0.5;
  EXPECT_THAT(refusalOfPose(pose), HasSubstr("last row"));
  pose = soundMatrix();
  pose.topLeftCorner<3, 3>().setZero();
  EXPECT_THAT(refusalOfPose(pose), HasSubstr("length 0.000"));
}

TEST(SoundPose, MendsRoundingAndSaysSoAboveIt) {
  Eigen::Matrix4d pose = soundMatrix();
  std::string said;
  pose(0, 0) += 5e-5;  // the fifth decimal
  soundPose(pose, &said);
  EXPECT_EQ(said, "");
  pose(0, 0) += 5e-3;
  const auto mended = soundPose(pose, &said);
  EXPECT_THAT(said, HasSubstr("made unit and orthogonal"));
  EXPECT_NEAR(mended.rotation().determinant(), 1.0, 1e-12);
}

Item targetAt(const Eigen::Vector3d& place) {
  Item item;
  item.name = "M1";
  item.pose = soundMatrix();
  item.pose->topRightCorner<3, 1>() = place;
  return item;
}

OtherFile fileWith(const Item& item) {
  OtherFile file;
  file.words = "made";
  file.items = {item};
  return file;
}

TEST(Check, RefusesACoilOutOfReachOfTheHead) {
  const auto head = madeHead();
  auto file = fileWith(targetAt(head.centre_mm + Eigen::Vector3d(0, 0, 430)));
  check(file, head, {});
  EXPECT_THAT(file.items[0].refusal, HasSubstr("430 mm from the middle of the head"));
  EXPECT_FALSE(file.items[0].mri_T_coil);
}

TEST(Check, RefusesTemplateSpacesAlsoWhenAskedNotTo) {
  for (const Space space : {Space::mni, Space::talairach, Space::other_template}) {
    auto file = fileWith(targetAt({0, 0, 90}));
    file.space = space;
    Answers answers;
    answers.space = Space::ras;
    check(file, madeHead(), answers);
    EXPECT_THAT(file.items[0].refusal, HasSubstr("a template's"));
  }
}

TEST(Check, AsksForASpaceThatTheFileDoesNotState) {
  auto file = fileWith(targetAt({30, 20, 90}));
  file.space = Space::unknown;
  file.space_words = "World";
  check(file, madeHead(), {});
  EXPECT_THAT(file.items[0].refusal, HasSubstr("--space lps or --space ras"));
  auto answered = fileWith(targetAt({30, 20, 90}));
  answered.space = Space::unknown;
  Answers answers;
  answers.space = Space::lps;
  check(answered, madeHead(), answers);
  EXPECT_EQ(answered.items[0].refusal, "");
  EXPECT_NEAR((answered.items[0].mri_T_coil->translation_mm() - Eigen::Vector3d(-30, -20, 90)).norm(), 0,
              1e-9);
}

/// A head whose middle is 40 mm behind the origin: RAS and LPS lie 80 mm apart.
CaseHead headBehindTheOrigin() {
  auto head = madeHead();
  head.centre_mm = {0, -40, 0};
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d v(std::sin(i * 1.7), std::cos(i * 2.3), std::sin(i * 0.9 + 1));
    head.skin_mm.push_back(head.centre_mm + 90.0 * v.normalized());
  }
  return head;
}

TEST(Check, NoticesLpsUnderTheNameOfRas) {
  const auto head = headBehindTheOrigin();
  const Eigen::Vector3d on_skin = head.centre_mm + Eigen::Vector3d(0, -90, 0);
  auto right = fileWith(targetAt(on_skin));
  check(right, head, {});
  EXPECT_EQ(right.items[0].refusal, "");
  auto wrong = fileWith(targetAt({-on_skin.x(), -on_skin.y(), on_skin.z()}));
  check(wrong, head, {});
  EXPECT_THAT(wrong.items[0].refusal, HasSubstr("--space ras or --space lps"));
  EXPECT_THAT(wrong.items[0].refusal, HasSubstr("as RAS its poses lie"));
}

TEST(Check, RefusesLengthsInMetresOrCentimetres) {
  const auto head = headBehindTheOrigin();
  const Eigen::Vector3d on_skin = head.centre_mm + Eigen::Vector3d(0, -60, 67);
  for (const auto& [unit_mm, name] :
       {std::pair{1000.0, "if its lengths are metres"}, std::pair{10.0, "if its lengths are centimetres"}}) {
    auto file = fileWith(targetAt(on_skin / unit_mm));
    check(file, head, {});
    EXPECT_THAT(file.items[0].refusal, HasSubstr(name));
    EXPECT_FALSE(file.items[0].mri_T_coil);
  }
}

TEST(Check, NotesACoilThatStandsOnEdge) {
  const auto head = headBehindTheOrigin();
  const Eigen::Vector3d into_head = soundMatrix().block<3, 1>(0, 2);
  auto file = fileWith(targetAt(head.centre_mm - 92 * into_head));
  const Eigen::Matrix4d sound = *file.items[0].pose;
  Eigen::Matrix4d exchanged = sound;  // z, x, y in place of x, y, z
  for (int axis = 0; axis < 3; ++axis) exchanged.col(axis) = sound.col((axis + 2) % 3);
  check(file, head, {});
  const bool is_noted = !file.items[0].notes.empty();
  file = fileWith(targetAt({0, 0, 0}));
  file.items[0].pose = exchanged;
  check(file, head, {});
  ASSERT_FALSE(file.items[0].notes.empty());
  EXPECT_THAT(file.items[0].notes.back(), HasSubstr("stands on edge"));
  EXPECT_FALSE(is_noted);
}

TEST(Check, TurnsTheHandleWhenAsked) {
  auto file = fileWith(targetAt({-50, -20, 90}));
  Answers answers;
  answers.flips_handle = true;
  check(file, madeHead(), answers);
  const Eigen::Matrix3d turned = file.items[0].mri_T_coil->rotation();
  const Eigen::Matrix3d before = soundMatrix().topLeftCorner<3, 3>();
  EXPECT_NEAR((turned.col(1) + before.col(1)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((turned.col(2) - before.col(2)).norm(), 0.0, 1e-9);
}

TEST(Check, NamesAnotherT1InMillimetres) {
  const auto head = madeHead();
  T1 other = head.t1;
  other.grid.size[0] += 3;
  auto file = fileWith(targetAt({-50, -20, 90}));
  check(file, head, {}, other);
  EXPECT_THAT(file.items[0].refusal, HasSubstr("its T1 is another one"));
  EXPECT_THAT(file.items[0].refusal, HasSubstr(" mm apart"));
}

TEST(Check, MovesPosesFromAnotherHeaderOfTheSameVoxels) {
  const auto head = madeHead();
  T1 other = head.t1;
  const Eigen::Affine3d moved(Eigen::Translation3d(0, 0, 12));
  other.grid.mri_from_voxel = moved * other.grid.mri_from_voxel;
  auto file = fileWith(targetAt({-50, -20, 102}));
  check(file, head, {}, other);
  ASSERT_TRUE(file.items[0].mri_T_coil) << file.items[0].refusal;
  EXPECT_NEAR(file.items[0].mri_T_coil->translation_mm().z(), 90.0, 1e-6);
  EXPECT_THAT(file.notes, ::testing::Contains(HasSubstr("12 mm apart")));
}

TEST(Check, TakesTheFormThatTheFileNames) {
  const facenav::testing::TemporaryFolder folder;
  const auto head = headOf(writeTwoForms(folder.path() / "t1.nii"));
  const Eigen::Vector3d voxel(20, 25, 40);
  for (const Form form : {Form::sform, Form::qform}) {
    auto file = fileWith(targetAt(head.t1.map(form) * voxel));
    file.form = form;
    check(file, head, {});
    ASSERT_TRUE(file.items[0].mri_T_coil) << file.items[0].refusal;
    const Eigen::Vector3d expected = head.t1.grid.mri_from_voxel * voxel;
    EXPECT_NEAR((file.items[0].mri_T_coil->translation_mm() - expected).norm(), 0.0, 1e-4);
  }
}

TEST(Check, AsksForTheFormWhereItMattersAndTheFileDoesNotSay) {
  const facenav::testing::TemporaryFolder folder;
  const auto head = headOf(writeTwoForms(folder.path() / "t1.nii"));
  auto file = fileWith(targetAt(head.centre_mm + Eigen::Vector3d(0, 0, 90)));
  file.is_form_doubtful = true;
  check(file, head, {});
  EXPECT_THAT(file.items[0].refusal, HasSubstr("--form sform or --form qform"));
  auto prepared = madeHead();  // its own copy has one form, its T1 had two
  prepared.used_of_two = Form::sform;
  auto q = fileWith(targetAt({-50, -20, 90}));
  q.form = Form::qform;
  check(q, prepared, {});
  EXPECT_THAT(q.items[0].refusal, HasSubstr("--t1"));
}

}  // namespace
}  // namespace facenav::interop
