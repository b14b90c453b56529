// The window that shows what files of other programs would bring in, and the one that exports: by keyboard,
// at the size of a small laptop and with doubled text. FACENAV_GUI_PICTURES=DIR stores an image of each.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QComboBox>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QSettings>
#include <QShortcut>
#include <QtTest/QTest>
#include <cstdlib>
#include <tuple>

#include "facenav/plan/imported_field.h"
#include "facenav/scene/display.h"
#include "facenav/surface/scalp_surface.h"
#include "facenav/volume/nifti.h"
#include "gui_fixtures.h"
#include "plan/export_window.h"
#include "plan/field_import_window.h"
#include "plan/import_choices.h"
#include "plan/import_list.h"
#include "plan/import_view.h"
#include "plan/import_window.h"
#include "prepare/prepare_workspace.h"
#include "shell/appearance.h"
#include "shell/elided_label.h"
#include "shell/main_window.h"
#include "support/coil_positions.h"
#include "support/made_field_mesh.h"
#include "support/window_checks.h"

namespace facenav::ui {
namespace {

namespace fs = std::filesystem;

const fs::path kMade = fs::path(FACENAV_SOURCE_DIR) / "testing/unit/case/interop/made";

/// The head that the made files belong to.
casefile::PreparedCase madeHead() {
  casefile::PreparedCase prepared;
  prepared.mri = volume::readNifti(kMade / "t1_lpi.nii.gz").volume;
  prepared.head_mask.grid = prepared.mri.grid;
  for (const float value : prepared.mri.voxels) prepared.head_mask.voxels.push_back(value > 20.f);
  TaskMonitor monitor;
  prepared.scalp = surface::extractScalp(prepared.mri, prepared.head_mask, monitor);
  prepared.label = "Family, Given";
  return prepared;
}

class ImportWindows : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
    QSettings().clear();
  }
  void TearDown() override { applyAppearance(*qApp); }
  void open(const casefile::PreparedCase& prepared) {
    casefile::CaseStore::create(folder_.path() / "case", prepared, {}, false);
    window_ = std::make_unique<MainWindow>(Services{});
    window_->show();
    window_->openCase(path("case"));
    ASSERT_TRUE(fixtures::waitFor([&] { return !window_->tasks().isRunning(); }));
    window_->setWorkspace(Workspace::plan);
  }
  QString path(const std::string& name) const {
    return QString::fromStdString((folder_.path() / name).string());
  }
  QString write(const std::string& name, const std::string& content) const {
    return QString::fromStdString(testing::writtenFile(folder_.path() / name, content).string());
  }
  /// The preview, when it is shown.
  ImportWindow* preview() {
    fixtures::waitFor([&] {
      auto* shown = window_->findChild<ImportWindow*>();
      return shown && shown->isActiveWindow() && !shown->presenter().isReading();
    });
    return window_->findChild<ImportWindow*>();
  }
  void leave(ImportWindow& shown) {
    shown.close();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    EXPECT_FALSE(window_->findChild<ImportWindow*>());
  }
  std::vector<guidance::Target> targets() const {
    return casefile::CaseStore::open(folder_.path() / "case").targets().targets;
  }
  QString message() const {
    for (auto* label : window_->findChild<QWidget*>("taskbar")->findChildren<QLabel*>())
      if (label->isVisible()) return label->toolTip().isEmpty() ? label->text() : label->toolTip();
    return {};
  }
  static void keepPicture(QWidget& of, const QString& name) {
    if (const char* pictures = std::getenv("FACENAV_GUI_PICTURES"))
      of.grab().save(QString("%1/%2.png").arg(pictures, name));
  }
  static void expectFits(QWidget& window, const QString& name) {
    fixtures::waitFor([] { return false; }, 150);  // time for layout and drawing
    keepPicture(window, name);
    EXPECT_EQ(testing::cutTexts(window).join("\n").toStdString(), "") << name.toStdString();
    EXPECT_EQ(testing::misplacedParts(window).join("\n").toStdString(), "") << name.toStdString();
  }
  testing::TemporaryFolder folder_;
  std::unique_ptr<MainWindow> window_;
};

TEST_F(ImportWindows, AFileIsShownTickedByKeysBroughtInAndTakenBack) {
  open(fixtures::ballWithBrain());
  window_->take(
      {write("two.csv", testing::coilPosition("M1", {-1, 0, 1}) + testing::coilPosition("SMA", {0, 1, 2}))});
  auto* shown = preview();
  ASSERT_TRUE(shown && shown->isVisible());
  auto* list = shown->findChild<ImportList*>();
  EXPECT_EQ(list->chosen().name, "M1");
  QTest::keyClick(list, Qt::Key_Space);
  ASSERT_TRUE(fixtures::waitFor([&] { return shown->presenter().targets() == 1; }));
  EXPECT_EQ(list->chosen().name, "M1") << "it stays chosen";
  QTest::keyClick(list, Qt::Key_Down);
  EXPECT_EQ(list->chosen().name, "SMA");
  EXPECT_TRUE(list->describe().contains("comes in")) << list->describe().toStdString();
  auto& scene = shown->findChild<ImportView*>()->sceneView();
  EXPECT_FALSE(scene.accessibleName().isEmpty());
  emit scene.picked(-64, 0, 64, false);
  EXPECT_EQ(list->chosen().name, "M1") << "a click on the head chooses the nearest coil";
  EXPECT_TRUE(targets().empty()) << "nothing is written before";
  QTest::keyClick(shown, Qt::Key_Return, Qt::ControlModifier);
  ASSERT_TRUE(fixtures::waitFor([&] { return targets().size() == 1; }));
  EXPECT_EQ(window_->workspace(), Workspace::plan);
  EXPECT_TRUE(message().startsWith("1 target came in")) << message().toStdString();
  ASSERT_TRUE(fixtures::waitFor([&] { return !window_->findChild<ImportWindow*>(); }));
}

TEST_F(ImportWindows, WhatIsDroppedKeepsItsMeaningOnTheOtherPages) {
  open(fixtures::ballCase());
  const QString file = write("one.csv", testing::coilPosition("M1", {-1, 0, 1}));
  window_->take({write("noise.bin", std::string(300, '\x01'))});
  EXPECT_TRUE(message().contains("noise.bin is no file of another navigator")) << message().toStdString();
  EXPECT_EQ(window_->workspace(), Workspace::plan);
  window_->take(
      {write("cut.txt", "# Version: 12\n# Coordinate system: NIfTI:Aligned\n# Target Name\tLoc. X\n")});
  ASSERT_TRUE(fixtures::waitFor([&] { return message().contains("cut.txt"); })) << message().toStdString();
  EXPECT_FALSE(message().contains('\n'));
  EXPECT_TRUE(fixtures::waitFor([&] { return !window_->findChild<ImportWindow*>(); }));
  window_->setWorkspace(Workspace::review);
  window_->take({write("pulses.csv", testing::twoSessionsOfPulses()), file});
  auto* shown = preview();
  ASSERT_TRUE(shown);
  EXPECT_EQ(shown->presenter().files().size(), 2u);
  QTest::keyClick(shown, Qt::Key_Escape);
  ASSERT_TRUE(fixtures::waitFor([&] { return !window_->findChild<ImportWindow*>(); }));
  window_->setPrepareStep(PrepareStep::check);
  window_->take({path("case")});
  EXPECT_FALSE(window_->findChild<ImportWindow*>());
  ASSERT_TRUE(fixtures::waitFor([&] { return !window_->tasks().isRunning(); }));
}

TEST_F(ImportWindows, TheWindowFitsASmallLaptopAndDoubledText) {
  open(madeHead());
  const QStringList files{QString::fromStdString((kMade / "brainsight_v14_samples.txt").string()),
                          QString::fromStdString((kMade / "GUMMarkers.xml").string()),
                          write("noise.csv", "CoilPos,0,0,900,0,0,-1,0,1,0,0,far\n")};
  for (const auto& [scale, size, name] :
       {std::tuple{1.0, QSize(1366, 736), "import"}, std::tuple{2.0, QSize(1366, 736), "import_doubled"}}) {
    applyAppearance(*qApp, scale);
    window_->take(files);
    auto* shown = preview();
    ASSERT_TRUE(shown && shown->isVisible());
    shown->resize(size);
    expectFits(*shown, name);
    EXPECT_LE(shown->minimumSizeHint().width(), size.width());
    EXPECT_LE(shown->minimumSizeHint().height(), size.height());
    EXPECT_EQ(shown->size(), size);
    for (auto* field : shown->findChildren<QWidget*>()) {
      const bool is_read = qobject_cast<QComboBox*>(field) || qobject_cast<ImportList*>(field);
      if (is_read && field->isVisible()) {
        EXPECT_FALSE(field->accessibleName().isEmpty()) << field->metaObject()->className();
      }
    }
    for (auto* key : shown->findChildren<QShortcut*>()) {
      EXPECT_FALSE(key->whatsThis().isEmpty());
    }
    leave(*shown);
  }
}

TEST_F(ImportWindows, EveryMadeFileReadsWellInItsOwnHead) {
  open(madeHead());
  for (const auto& entry : fs::directory_iterator(kMade)) {
    const std::string file = entry.path().filename().string();
    const bool is_part = file.find("sub-01_") == 0;  // of a data set, which is read as a folder
    if (file.find("t1_") == 0 || file.find("truth") == 0 || is_part) continue;
    const QString path = QString::fromStdString(entry.path().string());
    auto* shown = window_->findChild<ImportWindow*>();
    shown ? shown->open({path}) : window_->take({path});  // one window reads all of them
    shown = preview();
    ASSERT_TRUE(shown && shown->isVisible()) << file << ": " << message().toStdString();
    auto* list = shown->findChild<ImportList*>();
    EXPECT_GT(shown->presenter().targets() + shown->presenter().pulses() + (file == "GUMMarkers.xml"), 0)
        << file;
    EXPECT_FALSE(list->describe().contains("--")) << list->describe().toStdString();
    if (std::getenv("FACENAV_GUI_PICTURES")) {
      shown->resize(1240, 680);
      fixtures::waitFor([] { return false; }, 300);
      keepPicture(*shown, "import_" + QString::fromStdString(file));
    }
  }
}

TEST_F(ImportWindows, ASetThatIsRefusedIsOneLine) {
  open(fixtures::ballCase());
  std::string far;
  for (const char* name : {"a", "b", "c"}) far += testing::coilPosition(name, {0, 0, 1}, 900);
  window_->take({write("far.csv", far + testing::coilPosition("M1", {-1, 0, 1}))});
  auto* shown = preview();
  ASSERT_TRUE(shown);
  auto* list = shown->findChild<ImportList*>();
  ASSERT_EQ(list->topLevelItemCount(), 1);
  auto* refused = list->topLevelItem(0)->child(0);
  ASSERT_EQ(list->topLevelItem(0)->childCount(), 2);
  EXPECT_EQ(refused->text(0), "3 items");
  EXPECT_TRUE(refused->text(1).startsWith("refused: its centre lies 900 mm"))
      << refused->text(1).toStdString();
  EXPECT_FALSE(refused->isExpanded());
  ASSERT_EQ(refused->childCount(), 3);
  EXPECT_EQ(refused->child(0)->text(1), "refused");
  list->setCurrentItem(refused->child(1));
  EXPECT_EQ(list->chosen().name, "b");
  EXPECT_TRUE(list->describe().contains("900 mm")) << list->describe().toStdString();
}

TEST_F(ImportWindows, AFieldThatIsDroppedOnPlanIsOfferedForATarget) {
  open(fixtures::ballWithBrain());
  window_->take({write("one.csv", testing::coilPosition("M1", {0, 0, 1}))});
  auto* shown = preview();
  ASSERT_TRUE(shown);
  QTest::keyClick(shown, Qt::Key_Return, Qt::ControlModifier);
  ASSERT_TRUE(fixtures::waitFor([&] { return targets().size() == 1; }));
  testing::FieldMeshLayout layout;
  layout.brain_mm = 42;
  const auto mesh = testing::madeFieldMesh(
      layout, [](const Eigen::Vector3d& p) { return Eigen::Vector3d(0, 0.02 * p.z(), 0); });
  applyAppearance(*qApp, 2.0);
  window_->take({write("sim.msh", mesh)});
  auto* offered = window_->findChild<FieldImportWindow*>();
  ASSERT_TRUE(offered);
  ASSERT_TRUE(fixtures::waitFor([&] { return offered->presenter().canTakeIn(); }))
      << offered->presenter().words().toStdString();
  expectFits(*offered, "field_import_doubled");
  QTest::keyClick(offered, Qt::Key_Return, Qt::ControlModifier);
  ASSERT_TRUE(fixtures::waitFor([&] { return message().contains("tier 3"); })) << message().toStdString();
  EXPECT_EQ(steps::importedFields(casefile::CaseStore::open(folder_.path() / "case")).size(), 1u);
}

TEST_F(ImportWindows, AnExportOffersTheTargetsAndANameWithoutThePatient) {
  open(fixtures::ballWithBrain());
  window_->take(
      {write("two.csv", testing::coilPosition("M1", {-1, 0, 1}) + testing::coilPosition("SMA", {0, 1, 2}))});
  auto* shown = preview();
  ASSERT_TRUE(shown);
  QTest::keyClick(shown, Qt::Key_Return, Qt::ControlModifier);
  ASSERT_TRUE(fixtures::waitFor([&] { return targets().size() == 2; }));
  window_->exportOther();
  auto* exports = window_->findChild<ExportWindow*>();
  ASSERT_TRUE(exports);
  expectFits(*exports, "export");
  auto* file = exports->findChild<QLineEdit*>("export_file");
  EXPECT_TRUE(file->text().endsWith("/brainsight.txt")) << file->text().toStdString();
  auto* list = exports->findChild<QListWidget*>();
  QTest::keyClick(list, Qt::Key_Space);
  EXPECT_EQ(list->item(0)->checkState(), Qt::Unchecked);
  const QString written = path("targets.txt");
  file->setText(written);
  QApplication::setActiveWindow(exports);
  QTest::keyClick(exports, Qt::Key_Return, Qt::ControlModifier);
  EXPECT_TRUE(fixtures::waitFor([&] { return QFileInfo::exists(written); }));
  auto* formats = exports->findChild<QComboBox*>();
  applyAppearance(*qApp, 2.0);
  exports->resize(1366, 736);
  for (int dicom = 3; dicom >= 1; --dicom) {
    formats->setCurrentIndex(formats->count() - dicom);
    expectFits(*exports, QString("export_doubled_%1").arg(dicom));
  }
  EXPECT_LE(exports->minimumSizeHint().width(), 1366);
  EXPECT_LE(exports->minimumSizeHint().height(), 736);
  EXPECT_EQ(exports->size(), QSize(1366, 736));
}

}  // namespace
}  // namespace facenav::ui
