// Writes images of every page with a real case, for people to look at. FACENAV_GUI_CASES=DIR is a folder of
// cases (it is written to: use a copy), FACENAV_GUI_PICTURES=DIR the output. Skipped without them.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QListWidget>
#include <QMouseEvent>
#include <QPushButton>
#include <QSlider>
#include <QTableView>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "facenav/atlas/brain_template.h"
#include "facenav/core/error.h"
#include "facenav/core/processor_time.h"
#include "facenav/scene/display.h"
#include "gui_fixtures.h"
#include "plan/brain_look_panel.h"
#include "prepare/distance_legend.h"
#include "prepare/prepare_workspace.h"
#include "shell/main_window.h"
#include "shell/scene_view.h"
#include "treat/treat_workspace.h"
#include "unit/treat/session/session_fakes.h"

namespace facenav::ui {
namespace {

class Pictures {
 public:
  Pictures(MainWindow& window, QString folder) : window_(window), folder_(std::move(folder)) {}
  void take(const QString& name) {
    fixtures::waitFor([this] { return !window_.tasks().isRunning(); }, 60000);
    fixtures::waitFor([] { return false; }, 700);  // time to draw
    EXPECT_TRUE(window_.grab().save(folder_ + "/" + name + ".png"));
  }

 private:
  MainWindow& window_;
  QString folder_;
};

/// Cameras that repeat a recording: FACENAV_GUI_RECORDING=DIR.
class PlayedCameras : public capture::FrameSource {
 public:
  explicit PlayedCameras(const std::string& folder) : recording_(capture::openRecording(folder)) {}
  const cameras::StereoRig& rig() const override { return recording_.rig; }
  std::shared_ptr<const cameras::StereoFrame> next() override {
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    if (!source_) source_ = capture::makeSource(recording_);
    auto frame = source_->next();
    if (!frame) return source_ = nullptr, next();
    auto now = std::make_shared<cameras::StereoFrame>(*frame);
    now->number = number_++;
    now->captured = Timestamp::now();
    return now;
  }

 private:
  capture::Recording recording_;
  std::unique_ptr<capture::FrameSource> source_;
  std::int64_t number_ = 0;
};

/// Services with one job that stops half-way and one that fails.
Services exampleServices() {
  Services services;
  services.listSeries = [](const std::filesystem::path& folder, TaskMonitor&) {
    if (folder.filename() == "broken") throw Error("no DICOM image in the folder", {}, "choose another");
    dicom::SeriesInfo t1, survey;
    t1.description = "T1 MPRAGE sag", t1.modality = survey.modality = "MR", t1.plane = "sagittal";
    t1.date = survey.date = "2026-11-20", t1.rows = t1.columns = 256, t1.slices = 176;
    t1.spacing_mm = {1, 1, 1}, t1.id = t1.series_uid = "1.2.3", t1.is_loadable = true;
    t1.is_recommended = t1.is_fit_for_navigation = true, t1.fitness = "fit for navigation";
    survey.description = "survey", survey.problem = "three planes of 3 slices each";
    return std::vector<dicom::SeriesInfo>{t1, survey};
  };
  services.prepareCase = [](const PrepareOrder&, TaskMonitor& monitor) {
    for (;;) {
      monitor.report("finding the brain", 0.6);
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  };
  services.findInArchive = [](const pacs::PacsNode&, const pacs::PacsQuery&, TaskMonitor&) {
    pacs::PacsSeries t1, t2;
    t1.date = t2.date = "2026-11-20", t1.modality = t2.modality = "MR";
    t1.study_description = t2.study_description = "Brain, navigation", t1.images = 176;
    t1.description = "T1 MPRAGE sag 1 mm", t2.description = "T2 FLAIR";
    return std::vector<pacs::PacsSeries>{t1, t2};
  };
  const char* recording = std::getenv("FACENAV_GUI_RECORDING");
  services.listCameras = [recording](capture::Search) {
    if (!recording) return std::vector<capture::FoundCamera>();
    std::vector<capture::FoundCamera> pair(2);
    pair[0].identity = {"genicam", "FLIR-1", "FLIR Blackfly", "19040101", "192.168.1.11"};
    pair[1].identity = {"genicam", "FLIR-2", "FLIR Blackfly", "19040102", "192.168.1.12"};
    return pair;
  };
  services.openCameras = [recording](const cameras::StereoRig&, const std::string&, const std::string&) {
    return std::make_unique<PlayedCameras>(recording);
  };
  services.readTemplate = [] { return atlas::readColin27(); };
  return services;
}

QAbstractButton* buttonNamed(MainWindow& window, const QString& text) {
  for (auto* button : window.findChildren<QAbstractButton*>())
    if (button->text() == text && button->isVisible()) return button;
  return nullptr;
}

/// Takes the cortex at three depths and the distance map; prints the time of one step of the slider.
void takeBrainLooks(MainWindow& window, Pictures& shots) {
  auto* panel = window.findChild<BrainLookPanel*>();
  ASSERT_NE(panel, nullptr);
  const auto looks = panel->findChildren<QPushButton*>();
  auto* peel = panel->findChild<QSlider*>();
  looks[1]->click();
  ASSERT_TRUE(fixtures::waitFor([&] { return peel->isEnabled(); }, 60000));
  for (const int depth_mm : {0, 5, 20}) {
    peel->setValue(2 * depth_mm);
    shots.take(QString("5_plan_cortex_%1mm").arg(depth_mm));
  }
  std::vector<double> steps_ms;
  const double begun_ms = processorTime_ms();
  for (int value = 0; value <= peel->maximum(); ++value) {
    QElapsedTimer timer;
    timer.start();
    peel->setValue(value);
    QApplication::processEvents();
    steps_ms.push_back(double(timer.nsecsElapsed()) * 1e-6);
  }
  std::sort(steps_ms.begin(), steps_ms.end());
  std::printf(
      "peel slider: %.1f ms a step (median), %.1f ms at most, %d steps; %.1f ms of processor time each\n",
      steps_ms[steps_ms.size() / 2], steps_ms.back(), int(steps_ms.size()),
      (processorTime_ms() - begun_ms) / double(steps_ms.size()));
  looks[2]->click();
  fixtures::waitFor([&] { return panel->findChild<DistanceLegend*>()->isVisible(); }, 90000);
  shots.take("5_plan_distance");
  looks[3]->click();
  fixtures::waitFor([] { return false; }, 3000);  // time for the second view's first image
  shots.take("5_plan_side_by_side");
  looks[0]->click();
}

/// Takes the scalpel's line on the 3-D view of Check & edit, and the result of the cut.
void takeScalpel(MainWindow& window, Pictures& shots) {
  auto* scalpel = buttonNamed(window, "Scalpel");
  ASSERT_NE(scalpel, nullptr);
  scalpel->click();
  SceneView* view = nullptr;
  for (auto* each : window.findChildren<SceneView*>())
    if (each->isVisible()) view = each;
  ASSERT_NE(view, nullptr);
  const QPoint middle(view->width() / 2, view->height() * 45 / 100);
  QTest::mousePress(view, Qt::LeftButton, {}, middle + QPoint(50, 0));
  for (int i = 1; i < 30; ++i) {
    const double angle = 2 * M_PI * i / 32;
    QMouseEvent move(QEvent::MouseMove, middle + QPointF(50 * std::cos(angle), 40 * std::sin(angle)),
                     Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(view, &move);
  }
  shots.take("3_check_scalpel_line");
  QTest::mouseRelease(view, Qt::LeftButton, {}, middle + QPoint(48, -8));
  fixtures::waitFor([] { return false; }, 8000);  // time until the model is updated
  shots.take("3_check_scalpel_cut");
  buttonNamed(window, "Undo")->click();
  scalpel->click();
}

void takeCameras(MainWindow& window, Pictures& shots, const std::string& recording) {
  auto* treat = window.findChild<TreatWorkspace*>();
  window.setWorkspace(Workspace::treat);
  treat->presenter().cameras().setRigFile(QString::fromStdString(recording + "/stereo.yml"));
  treat->presenter().cameras().choose("genicam:FLIR Blackfly#19040101", "genicam:FLIR Blackfly#19040102");
  treat->presenter().cameras().refreshDevices();
  buttonNamed(window, "Open the cameras")->click();
  fixtures::waitFor([&] { return treat->presenter().cameras().isWell(); });
  buttonNamed(window, "1 Take with dots")->click();
  shots.take("6_treat_cameras_live");
}

/// Reads the poses in truth/`name`.csv, by frame.
template <class To, class From>
std::vector<RigidTransform<To, From>> readTruth(const std::filesystem::path& recording,
                                                const std::string& name) {
  std::ifstream csv(recording / "truth" / (name + ".csv"));
  std::string line;
  std::getline(csv, line);
  std::vector<RigidTransform<To, From>> poses;
  while (std::getline(csv, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream values(line);
    double frame, x, y, z, qw, qx, qy, qz;
    if (values >> frame >> x >> y >> z >> qw >> qx >> qy >> qz)
      poses.emplace_back(Eigen::Quaterniond(qw, qx, qy, qz), Eigen::Vector3d(x, y, z));
  }
  return poses;
}

class TrueCoil : public coil_tracking::CoilTracker {
 public:
  explicit TrueCoil(std::vector<RigidTransform<Camera, Marker>> poses) : poses_(std::move(poses)) {}
  void start(const cameras::StereoRig&, const coil_tracking::CoilModel&) override {}
  coil_tracking::CoilResult track(const cameras::StereoFrame& frame,
                                  const coil_tracking::CoilContext&) override {
    coil_tracking::CoilPose coil;
    coil.camera_T_marker = poses_[std::size_t(frame.number) % poses_.size()];
    return Tracked<coil_tracking::CoilPose>(coil, 0.9);
  }

 private:
  std::vector<RigidTransform<Camera, Marker>> poses_;
};

/// Guides a recording by its own truth, so that the image shows what a clinician would see. The face is lost
/// while `is_face_hidden`.
Services trueServices(const std::string& folder, std::shared_ptr<std::atomic<bool>> is_face_hidden) {
  const auto head = readTruth<Camera, Mri>(folder, "head");
  const auto coil = readTruth<Camera, Marker>(folder, "coil");
  Services services = exampleServices();
  services.align = [head](const casefile::CaseStore&, const capture::Recording& recording, const HeadKnown&,
                          TaskMonitor&) {
    steps::AlignmentOutcome outcome;
    outcome.result.camera_T_mri = head.front();
    outcome.result.rms_mm = 0.41, outcome.result.points = 16000;
    outcome.reference.frame = recording.capture.value().plain;
    return outcome;
  };
  services.makeNavigator = [head, coil, is_face_hidden](const session::NavigatorSetup& setup) {
    const auto pose = [head, is_face_hidden](std::int64_t n) -> std::optional<RigidTransform<Camera, Head>> {
      if (*is_face_hidden) return std::nullopt;
      const auto camera_T_mri = head[std::size_t(n) % head.size()];
      return (camera_T_mri * head.front().inverse()).reframe<Camera, Head>();
    };
    return std::make_unique<session::Navigator>(setup, std::make_unique<session::fakes::Head>(pose),
                                                std::make_unique<TrueCoil>(coil));
  };
  return services;
}

TEST(Pictures, OfGuidance) {
  const char *cases = std::getenv("FACENAV_GUI_CASES"), *pictures = std::getenv("FACENAV_GUI_PICTURES");
  const char* recording = std::getenv("FACENAV_GUI_RECORDING");
  if (!cases || !pictures || !recording)
    GTEST_SKIP() << "FACENAV_GUI_CASES, _PICTURES and _RECORDING are not set";
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  const auto is_face_hidden = std::make_shared<std::atomic<bool>>(false);
  MainWindow window(trueServices(recording, is_face_hidden));
  window.resize(1480, 920);
  window.show();
  const auto entries = casefile::listCases(cases);
  ASSERT_FALSE(entries.empty());
  casefile::signOff(casefile::CaseStore::open(entries.front().folder), {"XY", "", true});
  window.openCase(QString::fromStdString(entries.front().folder.string()));
  ASSERT_TRUE(fixtures::waitFor([&] { return !window.tasks().isRunning(); }, 60000));
  window.setWorkspace(Workspace::treat);
  window.play(recording, true);
  ASSERT_TRUE(fixtures::waitFor([&] { return window.treat().isRunning(); }, 60000));
  Pictures shots(window, pictures);
  shots.take("7_treat_guiding");
  *is_face_hidden = true;
  shots.take("7_treat_face_lost");
  *is_face_hidden = false;
  ASSERT_TRUE(fixtures::waitFor([&] { return window.treat().hasEnded(); }, 60000));
  shots.take("7_treat_recording_ended");
}

TEST(Pictures, OfEveryPage) {
  const char *cases = std::getenv("FACENAV_GUI_CASES"), *pictures = std::getenv("FACENAV_GUI_PICTURES");
  if (!cases || !pictures) GTEST_SKIP() << "FACENAV_GUI_CASES and FACENAV_GUI_PICTURES are not set";
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  const testing::TemporaryFolder folder;
  MainWindow window(exampleServices());
  window.resize(1480, 920);
  window.show();
  window.setCasesFolder(cases);
  const auto entries = casefile::listCases(cases);
  ASSERT_FALSE(entries.empty());
  Pictures shots(window, pictures);
  for (const char* name : {"broken", "head_1", "head_2"}) {
    std::filesystem::create_directories(folder.path() / name);
    window.queue().add(QString::fromStdString((folder.path() / name).string()));
  }
  shots.take("1_worklist");
  window.openCase(QString::fromStdString(entries.front().folder.string()));
  shots.take("3_check");
  takeScalpel(window, shots);
  window.setPrepareStep(PrepareStep::sign_off);
  shots.take("4_sign_off");
  window.setWorkspace(Workspace::treat);
  shots.take("6_treat_not_signed_off");
  for (const auto& entry : entries)
    casefile::signOff(casefile::CaseStore::open(entry.folder), {"XY", "", true});
  window.openCase(QString::fromStdString(entries.front().folder.string()));
  window.setWorkspace(Workspace::plan);
  shots.take("5_plan");
  takeBrainLooks(window, shots);
  window.setWorkspace(Workspace::treat);
  shots.take("6_treat_cameras");
  if (const char* recording = std::getenv("FACENAV_GUI_RECORDING")) takeCameras(window, shots, recording);
  window.setPrepareStep(PrepareStep::archive);
  if (auto* find = buttonNamed(window, "Find")) find->click();
  shots.take("2_archive");
  window.setPrepareStep(PrepareStep::series);
  shots.take("2_series");
  window.setPrepareStep(PrepareStep::sign_off);
  shots.take("4_signed_off");
  window.setPrepareStep(PrepareStep::worklist);
  shots.take("1_worklist_checked");
  for (auto* table : window.findChildren<QTableView*>())
    if (table->isVisible()) table->selectRow(2);  // the waiting job
  if (auto* show = buttonNamed(window, "Show series")) show->click();
  shots.take("2_series_read");
}

}  // namespace
}  // namespace facenav::ui
