// A robot walks through each user's main job (jobs.h), at 1366 x 768 with the pictures kept in
// testing/walk/pictures, and at other sizes and text sizes without them. It fails on a cut text, on a part
// outside the window or over another, on a button that leaves the mouse, and on a changed picture.
//
// After a wanted change of the window, the pictures are made anew by
//   xvfb-run -a -s '-screen 0 1920x1200x24 -noreset' ninja -C build/release walk_pictures
// Look at what git shows as changed before it is committed. FACENAV_GUI_PICTURES=DIR keeps an image of every
// step.

#include <gtest/gtest.h>

#include <QApplication>

#include "facenav/scene/display.h"
#include "jobs.h"
#include "shell/appearance.h"

namespace facenav::walk {
namespace {

const testing::KeptPictures& keptPictures() {
  static const testing::KeptPictures kPictures(
      std::filesystem::path(FACENAV_SOURCE_DIR) / "testing/walk/pictures",
      testing::KeptPictures::useFromEnvironment());
  return kPictures;
}

/// One patient for all walks of the program.
class Walk : public ::testing::Test {
 protected:
  static void TearDownTestSuite() { patient_.reset(); }
  void walk(void (*job)(Patient&, const Look&), const Look& look) {
    if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
    FACENAV_NEEDS(testing::virtualPatientMri());
    if (!patient_) patient_ = std::make_unique<Patient>();
    ui::applyAppearance(*qApp, look.text_scale);
    job(*patient_, look);
    ui::applyAppearance(*qApp);
  }
  void walkAll(const Look& look) {
    for (auto* job : {prepareAScan, planTargets, setUpCameras, treat, treatAtHome}) walk(job, look);
  }
  static std::unique_ptr<Patient> patient_;
};

std::unique_ptr<Patient> Walk::patient_;

const Look kUsual{"1366", {1366, 768}, 1, &keptPictures()};

TEST_F(Walk, TheRadiographerPreparesAScan) { walk(prepareAScan, kUsual); }
TEST_F(Walk, TheNeurologistPlansTargets) { walk(planTargets, kUsual); }
TEST_F(Walk, AnEngineerSetsUpCameras) { walk(setUpCameras, kUsual); }
TEST_F(Walk, TheClinicianTreats) { walk(treat, kUsual); }
TEST_F(Walk, AClinicianTreatsWithTheProgramsOwnMethods) { walk(treatInTheRoom, {"room", {1366, 768}}); }
TEST_F(Walk, APersonTreatsAtHome) { walk(treatAtHome, kUsual); }
TEST_F(Walk, AllJobsFitASmallScreen) { walkAll({"1280", {1280, 720}}); }
TEST_F(Walk, AllJobsFitALargeScreen) { walkAll({"1920", {1920, 1080}}); }
TEST_F(Walk, AllJobsFitTextOfTwiceTheSize) { walkAll({"double", {1920, 1080}, 2}); }

}  // namespace
}  // namespace facenav::walk
