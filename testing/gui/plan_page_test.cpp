// The page of Plan: keys, the list of targets, refusals beside what caused them, one author, one depth.

#include <gtest/gtest.h>
#include <vtkRenderWindowInteractor.h>

#include <QAbstractButton>
#include <QAction>
#include <QClipboard>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSettings>
#include <QShortcut>
#include <QSpinBox>
#include <QtTest/QTest>
#include <cmath>
#include <memory>

#include "facenav/guidance/handle.h"
#include "facenav/scene/display.h"
#include "gui_fixtures.h"
#include "plan/dose_panel.h"
#include "plan/grid_panel.h"
#include "plan/plan_workspace.h"
#include "plan/target_list.h"
#include "plan/typed_coordinates.h"
#include "prepare/sign_off_presenter.h"
#include "shell/author.h"
#include "shell/linked_views.h"
#include "shell/view_menu.h"

namespace facenav::ui {
namespace {

/// The page of Plan over a ball, with one target.
class PlanPage : public ::testing::Test {
 protected:
  PlanPage() : plan_(model_), place_(services_, model_), cortex_(model_) {
    if (!scene::hasDisplay()) return;
    page_ = std::make_unique<PlanWorkspace>(plan_, place_, cortex_, model_);
    model_.open(fixtures::loadBallCase(folder_.path()));
    plan_.addTarget(Point<Mri>(-40, 5, 60));
    page_->resize(1300, 700);
    page_->show();
    QApplication::processEvents();
  }
  Eigen::Vector3d cortex_mm() const { return plan_.active()->cortex_point.mm; }
  Eigen::Vector3d plate_mm() const { return plan_.active()->mri_T_target.translation_mm(); }
  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& target : model_.current().store.targets().targets) all.push_back(target.name);
    return all;
  }
  Eigen::Matrix3d axes() const { return plan_.active()->mri_T_target.rotation(); }

  testing::TemporaryFolder folder_;
  CaseModel model_;
  PlanPresenter plan_;
  Services services_;
  PlacePresenter place_;
  CortexPresenter cortex_;
  std::unique_ptr<PlanWorkspace> page_;
};

TEST_F(PlanPage, PlainArrowsMoveTheTargetWhileAViewHasTheFocus) {
  if (!page_) GTEST_SKIP() << "no X display here: run under xvfb-run";
  std::vector<QWidget*> views{page_->findChild<SliceView*>(), page_->findChild<CoilSliceView*>(),
                              page_->findChild<SceneView*>()};
  for (auto* view : views) {
    EXPECT_TRUE(view->toolTip().contains("arrows")) << view->metaObject()->className();
    view->setFocus();
    const Eigen::Vector3d start_mm = plate_mm(), left = axes().col(0), ahead = axes().col(1);
    QTest::keyClick(view, Qt::Key_Left);
    EXPECT_NEAR((plate_mm() - start_mm).dot(left), 1.0, 0.03) << view->metaObject()->className();
    QTest::keyClick(view, Qt::Key_Right);
    EXPECT_LT((plate_mm() - start_mm).norm(), 0.1);
    QTest::keyClick(view, Qt::Key_Up, Qt::ShiftModifier);
    EXPECT_NEAR((plate_mm() - start_mm).dot(ahead), 5.0, 0.2);
    QTest::keyClick(view, Qt::Key_Down, Qt::ShiftModifier | Qt::KeypadModifier);
    EXPECT_LT((plate_mm() - start_mm).norm(), 1.0);
    const Eigen::Matrix3d before = axes();
    QTest::keyClick(view, Qt::Key_Right, Qt::ControlModifier);
    const double turned_deg = std::atan2(axes().col(1).dot(-before.col(0)), axes().col(1).dot(before.col(1)));
    EXPECT_NEAR(turned_deg * 180 / M_PI, 5.0, 0.1) << "clockwise, seen along the coil's z";
    plan_.undo();
  }
  auto* list = page_->findChild<TargetList*>();
  list->setFocus();
  const Eigen::Vector3d before_mm = cortex_mm();
  QTest::keyClick(list, Qt::Key_Down);
  EXPECT_EQ(cortex_mm(), before_mm) << "in the list, arrows choose";
}

TEST_F(PlanPage, NoUnmodifiedLetterMakesOrChangesATarget) {
  if (!page_) GTEST_SKIP() << "no X display here: run under xvfb-run";
  const auto pose = plan_.active()->mri_T_target;
  std::vector<QWidget*> places{page_->findChild<SliceView*>(), page_->findChild<SceneView*>(), page_.get()};
  const auto expectSame = [&](const std::string& keys) {
    ASSERT_EQ(plan_.plan().targets.size(), 1u) << keys;
    EXPECT_EQ(plan_.active()->mri_T_target.translation_mm(), pose.translation_mm()) << keys;
    EXPECT_EQ(plan_.active()->mri_T_target.rotation(), pose.rotation()) << keys;
  };
  for (auto* place : places)
    for (int letter = Qt::Key_A; letter <= Qt::Key_Z; ++letter) {
      place->setFocus();
      QTest::keyClick(place, Qt::Key(letter));
      expectSame(std::string(1, char(letter)));
    }
  for (auto* shortcut : page_->findChildren<QShortcut*>())
    if (const QString keys = shortcut->key().toString(); keys.size() == 1) {
      emit shortcut->activated();
      expectSame(keys.toStdString());
    }
  for (auto* button : page_->findChildren<QAbstractButton*>())
    if (const QString keys = button->shortcut().toString(); keys.size() == 1) {
      button->click();
      expectSame(keys.toStdString());
    }
  EXPECT_EQ(page_->findChild<SceneView*>()->interactor()->GetKeyCode(), 0) << "VTK would quit at a Q";
  QSettings().clear();
}

TEST_F(PlanPage, TheSceneIsTheLargestViewAndAllViewsFit) {
  if (!page_) GTEST_SKIP() << "no X display here: run under xvfb-run";
  page_->resize(1216, 660);  // the page in a window of 1366 x 768
  for (const bool are_coil_slices_shown : {true, false, true}) {
    page_->findChild<LinkedViews*>()->setCoilSlicesShown(are_coil_slices_shown);
    QApplication::processEvents();
    EXPECT_EQ(page_->size(), QSize(1216, 660));
    const QSize scene = page_->findChild<SceneView*>()->size();
    for (auto* slice : page_->findChildren<SliceView*>()) {
      EXPECT_GT(scene.width() * scene.height(), 2 * slice->width() * slice->height());
      EXPECT_TRUE(slice->visibleRegion().boundingRect() == slice->rect());
    }
  }
}

TEST_F(PlanPage, ARefusedStepIsExplainedBesideTheTargetsUntilTheNextOne) {
  if (!page_) GTEST_SKIP() << "no X display here: run under xvfb-run";
  const auto fault = [&] {
    for (auto* label : page_->findChildren<QLabel*>("fault"))
      if (label->isVisible()) return label->text();
    return QString();
  };
  EXPECT_TRUE(fault().isEmpty()) << fault().toStdString();
  plan_.addTarget(Point<Mri>(0, 100, 0));
  EXPECT_TRUE(fault().contains("10 mm outside the head")) << fault().toStdString();
  QApplication::processEvents();
  EXPECT_FALSE(fault().isEmpty());
  plan_.turnActive(5);
  EXPECT_TRUE(fault().isEmpty()) << fault().toStdString();
}

TEST_F(PlanPage, AGridOrDoseThatIsRefusedIsExplainedInItsPanel) {
  if (!page_) GTEST_SKIP() << "no X display here: run under xvfb-run";
  const auto press = [](QWidget& panel, const QString& words) {
    for (auto* button : panel.findChildren<QAbstractButton*>())
      if (button->text() == words) button->click();
  };
  const auto faultIn = [](const QWidget& panel) {
    auto* label = panel.findChild<QLabel*>("fault");
    return label->isHidden() ? QString() : label->text();
  };
  GridPanel grid(plan_);
  bool is_done = false;
  QObject::connect(&grid, &GridPanel::done, [&] { is_done = true; });
  press(grid, "Make the grid");  // the ball has no brain
  EXPECT_FALSE(is_done);
  EXPECT_TRUE(faultIn(grid).contains("no brain model")) << faultIn(grid).toStdString();
  DosePanel dose(plan_);
  for (auto* field : dose.findChildren<QSpinBox*>())
    if (field->maximum() == 100000) field->setValue(7);
  auto* trains = dose.findChildren<QSpinBox*>().last();
  trains->setValue(8);  // more than its 7 pulses
  press(dose, "Apply to the target");
  EXPECT_TRUE(faultIn(dose).contains("trains")) << faultIn(dose).toStdString();
  trains->setValue(7);
  press(dose, "Apply to the target");
  EXPECT_TRUE(faultIn(dose).isEmpty()) << faultIn(dose).toStdString();
  EXPECT_EQ(plan_.active()->dose->trains, 7);
}

TEST_F(PlanPage, TheListsMenuRenamesCopiesLocksAndRemovesTheTargetUnderTheMouse) {
  if (!page_) GTEST_SKIP() << "no X display here: run under xvfb-run";
  const QString first = plan_.activeName();
  plan_.addTarget(Point<Mri>(40, 5, 60));
  const QString second = plan_.activeName();
  TargetList list(plan_);
  list.show();
  const auto action = [&](const QString& target, const QString& words) {
    for (auto* each : list.menuOf(target)->actions())
      if (each->text().startsWith(words)) return each;
    return static_cast<QAction*>(nullptr);
  };
  EXPECT_FALSE(action(second, "Make active")->isEnabled());
  action(first, "Make active")->trigger();
  EXPECT_EQ(plan_.activeName(), first);
  action(second, "Rename")->trigger();
  EXPECT_EQ(plan_.activeName(), second);
  auto* editor = list.findChild<QLineEdit*>();
  ASSERT_NE(editor, nullptr);
  editor->setText("M1 R");
  QTest::keyClick(editor, Qt::Key_Return);
  QApplication::processEvents();
  EXPECT_EQ(names(), (std::vector<std::string>{first.toStdString(), "M1 R"}));
  action("M1 R", "Duplicate")->trigger();
  EXPECT_EQ(plan_.activeName(), "M1 R copy");
  action("M1 R", "Lock")->trigger();
  EXPECT_FALSE(action("M1 R", "Delete")->isEnabled());
  EXPECT_FALSE(action("M1 R", "Rename")->isEnabled());
  plan_.setActive(first);
  action("M1 R copy", "Delete")->trigger();
  EXPECT_EQ(names(), (std::vector<std::string>{first.toStdString(), "M1 R"}));
  EXPECT_EQ(plan_.activeName(), first) << "the active target stays so";
}

TEST_F(PlanPage, FourTargetsAreInSightInAWindowOf1366By768) {
  if (!page_) GTEST_SKIP() << "no X display here: run under xvfb-run";
  for (int i = 0; i < 3; ++i) plan_.addTarget(Point<Mri>(40, 5 * i, 60));
  page_->resize(1240, 620);  // what the window leaves to a page
  QTest::qWait(100);
  const auto* list = page_->findChild<TargetList*>();
  EXPECT_GE(list->visibleRegion().boundingRect().height(), 4 * list->sizeHintForRow(0));
}

TEST_F(PlanPage, TheMenuOfAViewCopiesGoesThereAndResets) {
  if (!page_) GTEST_SKIP() << "no X display here: run under xvfb-run";
  auto* views = page_->findChild<LinkedViews*>();
  const auto act = [](QWidget& view, const ViewOffers& offers, const QString& begin) {
    const std::unique_ptr<QMenu> menu(makeViewMenu(view, offers));
    for (auto* action : menu->actions())
      if (action->text().startsWith(begin)) return action->trigger(), true;
    return false;
  };
  auto* slice = page_->findChildren<SliceView*>().front();
  const QPoint place(slice->width() / 3, slice->height() / 3);
  const auto offers = slice->offersAt(place);
  ASSERT_TRUE(offers.place);
  ASSERT_TRUE(act(*slice, offers, "Copy the coordinates"));
  const auto typed = readCoordinates(QApplication::clipboard()->text());
  ASSERT_TRUE(typed.mm) << "the field for coordinates reads what was copied";
  EXPECT_LT((*typed.mm - offers.place->mm).norm(), 0.1);
  const std::size_t targets = names().size();
  ASSERT_TRUE(act(*slice, offers, "Go to this place"));
  EXPECT_LT((views->crosshair().mm - offers.place->mm).norm(), 1e-6);
  EXPECT_EQ(names().size(), targets) << "no target is made";
  EXPECT_TRUE(act(*slice, offers, "Reset the view"));
  auto& scene = views->sceneView();
  const auto at_head = scene.offersAt(scene.rect().center()), beside = scene.offersAt(QPoint(2, 2));
  ASSERT_TRUE(at_head.place);
  ASSERT_TRUE(act(scene, at_head, "Go to this place"));
  EXPECT_LT((views->crosshair().mm - at_head.place->mm).norm(), 1e-6);
  EXPECT_EQ(names().size(), targets);
  EXPECT_FALSE(beside.place) << "there is no surface";
  EXPECT_FALSE(act(scene, beside, "Copy"));
  EXPECT_TRUE(act(scene, beside, "Reset the view"));
  for (auto* coil_slice : page_->findChildren<CoilSliceView*>()) {
    EXPECT_TRUE(coil_slice->offersAt(coil_slice->rect().center()).goTo);
  }
  SceneView alone;  // as in Review: nothing follows a crosshair there
  EXPECT_FALSE(alone.offersAt(QPoint(5, 5)).goTo);
}

TEST_F(PlanPage, AClickOfTheRightButtonOpensTheMenuAndADragZooms) {
  if (!page_) GTEST_SKIP() << "no X display here: run under xvfb-run";
  auto* slice = page_->findChildren<SliceView*>().front();
  const auto menus = [&] { return slice->findChildren<QMenu*>(); };
  QTest::mousePress(slice, Qt::RightButton, Qt::NoModifier, QPoint(60, 60));
  QTest::mouseMove(slice, QPoint(60, 90));
  QTest::mouseRelease(slice, Qt::RightButton, Qt::NoModifier, QPoint(60, 90));
  EXPECT_TRUE(menus().isEmpty());
  QTest::mouseClick(slice, Qt::RightButton, Qt::NoModifier, QPoint(60, 60));
  ASSERT_EQ(menus().size(), 1);
  menus().front()->close();
}

TEST_F(PlanPage, TheAuthorIsAskedOnceForAllPages) {
  if (!page_) GTEST_SKIP() << "no X display here: run under xvfb-run";
  rememberAuthor("  A. Author ");
  plan_.addTarget(Point<Mri>(-40, 5, 60));
  EXPECT_EQ(plan_.active()->changes.back().by, "A. Author");
  TaskRunner tasks;
  EXPECT_EQ(SignOffPresenter(model_, tasks).name(), "A. Author");
  QSettings().clear();
  EXPECT_EQ(recordedAuthor(), qgetenv("USER").toStdString());
}

TEST_F(PlanPage, OneDepthIsStatedFromScalpToCortexWhateverTheGap) {
  if (!page_) GTEST_SKIP() << "no X display here: run under xvfb-run";
  plan_.setGap("9");
  const double depth_mm = guidance::cortexDepth_mm(*plan_.active());
  EXPECT_NEAR(depth_mm, 90 - Eigen::Vector3d(-40, 5, 60).norm(), 1.0);
  const QString words = QString("cortex %1 mm below the scalp").arg(depth_mm, 0, 'f', 0);
  EXPECT_TRUE(plan_.describe(*plan_.active()).contains(words));
  CoilSliceView slice(scene::CoilCut::along_handle);
  const auto shown = std::make_shared<scene::SliceScene>();
  shown->mri = model_.current().mri;
  shown->targets = {*plan_.active()};
  shown->active_target = plan_.activeName().toStdString();
  slice.setScene(shown);
  slice.setCoil(plan_.slicedCoil());
  EXPECT_EQ(slice.caption(), "along: " + words);
}

}  // namespace
}  // namespace facenav::ui
