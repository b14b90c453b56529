#include <gtest/gtest.h>

#include "facenav/scene/display.h"
#include "gui_fixtures.h"
#include "main_window.h"
#include "unit/session/session_fakes.h"
#include "views/scene_view.h"
#include "widgets/figures_panel.h"

namespace facenav::ui {
namespace {

namespace fakes = session::fakes;

const RigidTransform<Camera, Marker> kMarker(Eigen::Quaterniond::Identity(), {20, -60, 550});

/// Trackers that always see both; the coil stands where the target was planned.
Services fakeServices() {
  Services services;
  services.align = [](const casefile::CaseStore&, const capture::Recording&, TaskMonitor&) {
    session::AlignmentOutcome outcome;
    outcome.result.camera_T_mri = fakes::cameraAtReference();
    outcome.reference.frame = *fakes::frame(0, 0);
    return outcome;
  };
  services.makeNavigator = [](const session::NavigatorSetup& setup) {
    return std::make_unique<session::Navigator>(
        setup, std::make_unique<fakes::Head>([](auto) { return RigidTransform<Camera, Head>(); }),
        std::make_unique<fakes::Coil>(kMarker));
  };
  return services;
}

std::filesystem::path writeRecording(const std::filesystem::path& folder, int frames) {
  capture::RecordingWriter writer(folder / "recording", fakes::rig());
  for (int i = 0; i < frames; ++i) writer.add(*fakes::frame(i, i * 0.02));
  writer.close();
  return folder / "recording";
}

TEST(Treat, GuidesWhileTheRecordingPlaysAndLeavesNoPoseStandingAtItsEnd) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  testing::TemporaryFolder folder;
  const auto case_folder = fixtures::writeBallCase(folder.path());
  guidance::TreatmentPlan plan;
  plan.targets.push_back(fakes::targetAt(kMarker.reframe<Camera, Coil>()).target);
  casefile::CaseStore::open(case_folder).setTargets(plan);
  MainWindow window(fakeServices());
  window.show();
  window.openCase(QString::fromStdString(case_folder.string()));
  window.play(QString::fromStdString(writeRecording(folder.path(), 100).string()));
  window.setWorkspace(Workspace::treat);
  auto* figures = window.findChild<FiguresPanel*>();
  ASSERT_NE(figures, nullptr);
  const QString dash(QChar(0x2013));
  ASSERT_TRUE(fixtures::waitFor([&] { return figures->figures()[0] != dash; }));
  EXPECT_EQ(figures->figures()[0], "0.0");
  SceneView* scene_view = nullptr;
  for (auto* view : window.findChildren<SceneView*>())
    if (view->isVisible()) scene_view = view;
  ASSERT_NE(scene_view, nullptr);
  EXPECT_TRUE(scene_view->scene().showsCoil());
  ASSERT_TRUE(fixtures::waitFor([&] { return figures->instruction().contains("ENDED"); }));
  EXPECT_EQ(figures->figures(), (std::array<QString, 4>{dash, dash, dash, dash}));
  EXPECT_FALSE(scene_view->scene().showsCoil());
}

}  // namespace
}  // namespace facenav::ui
