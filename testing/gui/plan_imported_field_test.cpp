// An imported electric field (tier 3) in Plan: named, and shown for the pose it was imported for alone.

#include <gmock/gmock.h>

#include <QCheckBox>
#include <QMenu>
#include <QWidgetAction>
#include <cstdlib>
#include <fstream>

#include "facenav/plan/imported_field.h"
#include "facenav/scene/display.h"
#include "gui_fixtures.h"
#include "plan/field_import_presenter.h"
#include "plan/field_panel.h"
#include "shell/appearance.h"
#include "support/made_field_mesh.h"
#include "support/window_checks.h"

namespace facenav::ui {
namespace {

using ::testing::HasSubstr;

/// A ball with a brain and one target over its top, without a page.
class PlanImportedField : public ::testing::Test {
 protected:
  PlanImportedField() : plan_(model_), field_(plan_, model_) {
    QSettings().clear();
    casefile::CaseStore::create(folder_.path() / "case", fixtures::ballWithBrain(), {}, false);
    TaskMonitor monitor;
    model_.open(loadCase(folder_.path() / "case", monitor));
    plan_.addTargetNear(Point<Mri>(4, 6, 37));
    field_.setInSight(true);
  }
  ~PlanImportedField() override { QSettings().clear(); }
  bool waitForField() {
    return fixtures::waitFor([&] { return field_.shown() != nullptr; });
  }
  /// Writes a field whose strength grows with the height.
  std::filesystem::path writeField() const {
    testing::FieldMeshLayout layout;
    layout.brain_mm = 42;
    const auto file = folder_.path() / "sim.msh";
    std::ofstream(file, std::ios::binary) << testing::madeFieldMesh(
        layout, [](const Eigen::Vector3d& p) { return Eigen::Vector3d(0, 0.02 * p.z(), 0); });
    return file;
  }
  void importField() const {
    steps::FieldImport order{writeField()};
    order.target = plan_.active()->name;
    steps::importField(model_.current().store, order);
  }

  testing::TemporaryFolder folder_;
  CaseModel model_;
  PlanPresenter plan_;
  FieldPresenter field_;
};

TEST_F(PlanImportedField, ItIsNamedAndShownForItsPoseAlone) {
  FieldPanel panel(field_);
  QCheckBox* choice = nullptr;
  for (auto* box : panel.findChildren<QCheckBox*>())
    if (box->text() == "imported field (tier 3)") choice = box;
  ASSERT_NE(choice, nullptr);
  EXPECT_FALSE(choice->isVisibleTo(&panel)) << "the target has none";
  importField();
  field_.setRate({10});
  field_.setOn(true);
  ASSERT_TRUE(waitForField()) << field_.words().toStdString();
  EXPECT_TRUE(choice->isVisibleTo(&panel));
  EXPECT_EQ(field_.shown()->tier, steps::FieldTier::imported);
  EXPECT_NEAR(field_.shown()->at_target, 10 * 0.02 * plan_.active()->cortex_point.mm.z(), 1)
      << "steps of 5 mm";
  EXPECT_THAT(field_.words().toStdString(), HasSubstr("imported field (tier 3): its own maximum"));
  EXPECT_THAT(field_.words().toStdString(), ::testing::Not(HasSubstr("nan")));
  choice->click();
  ASSERT_TRUE(waitForField());
  EXPECT_EQ(field_.shown()->tier, steps::FieldTier::local_sphere);
  choice->click();
  ASSERT_TRUE(waitForField());
  EXPECT_EQ(field_.shown()->tier, steps::FieldTier::imported);
  plan_.setGap("5");
  ASSERT_TRUE(waitForField());
  EXPECT_EQ(field_.shown()->tier, steps::FieldTier::local_sphere) << "another pose";
  EXPECT_FALSE(choice->isVisibleTo(&panel));
}

TEST_F(PlanImportedField, AFileIsJudgedForATargetBeforeItIsTakenIn) {
  FieldImportPresenter import(model_, plan_);
  QString taken;
  QObject::connect(&import, &FieldImportPresenter::takenIn, [&](const QString& words) { taken = words; });
  const QString target = plan_.activeName();
  import.open(QString::fromStdString(writeField().string()));
  ASSERT_TRUE(fixtures::waitFor([&] { return import.canTakeIn(); })) << import.words().toStdString();
  EXPECT_THAT(import.words().toStdString(), HasSubstr("V/m at 1 A/"));
  EXPECT_THAT(import.words().toStdString(), ::testing::Not(HasSubstr("--")));
  EXPECT_TRUE(steps::importedFields(model_.current().store).empty()) << "a preview writes nothing";
  plan_.addTargetNear(Point<Mri>(0, -70, 10));
  import.setTarget(plan_.activeName());
  ASSERT_TRUE(
      fixtures::waitFor([&] { return !import.isReading() && (import.isRefused() || import.canTakeIn()); }));
  import.setTarget(target);
  import.setRate(2);
  ASSERT_TRUE(fixtures::waitFor([&] { return import.canTakeIn(); }));
  import.takeIn();
  ASSERT_TRUE(fixtures::waitFor([&] { return !taken.isEmpty(); })) << import.words().toStdString();
  EXPECT_EQ(plan_.activeName(), target);
  EXPECT_TRUE(field_.hasImported()) << "Plan shows it at once";
  EXPECT_EQ(steps::importedFields(model_.current().store).front().rate_A_per_us, 2);
}

TEST_F(PlanImportedField, AnOpenMenuTakesNewChoicesAndWordsAtDoubledText) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  changeTextScale(*qApp, 2.0);
  QMenu menu;
  auto* action = new QWidgetAction(&menu);
  auto* panel = new FieldPanel(field_);
  action->setDefaultWidget(panel);
  menu.addAction(action);
  field_.setOn(true);
  ASSERT_TRUE(waitForField());
  menu.popup(QPoint(0, 0));
  importField();
  field_.setRate({10});  // reads it
  ASSERT_TRUE(fixtures::waitFor([&] { return field_.reach() != nullptr; }));
  fixtures::waitFor([] { return false; }, 200);  // time for layout
  EXPECT_EQ(testing::cutTexts(*panel).join('\n').toStdString(), "");
  EXPECT_GE(panel->height(), panel->sizeHint().height());
  EXPECT_LE(menu.width(), 1366);
  EXPECT_LE(menu.height(), 768);
  if (const char* pictures = std::getenv("FACENAV_GUI_PICTURES"))
    menu.grab().save(QString("%1/field_menu_doubled.png").arg(pictures));
  menu.close();
  changeTextScale(*qApp, 1.0);
}

}  // namespace
}  // namespace facenav::ui
