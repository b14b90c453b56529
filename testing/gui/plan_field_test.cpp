// The electric field in Plan: colours on the brain, numbers in words, nothing of another pose or case, and
// the best pose as a step that undo takes back. FACENAV_GUI_PICTURES=DIR stores an image of the page.

#include <gmock/gmock.h>

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <cstdlib>

#include "facenav/core/error.h"
#include "facenav/prepare/case_field.h"
#include "facenav/scene/display.h"
#include "gui_fixtures.h"
#include "plan/field_panel.h"
#include "plan/field_view.h"
#include "plan/plan_workspace.h"
#include "prepare/prepare_queue.h"
#include "shell/appearance.h"
#include "shell/colour_legend.h"
#include "shell/linked_views.h"
#include "support/ball_with_cortex.h"
#include "support/window_checks.h"

namespace facenav::ui {
namespace {

using ::testing::HasSubstr;

/// Number of pixels that differ by more than noise.
int differing(const RgbImage& a, const RgbImage& b) {
  int n = 0;
  for (std::size_t i = 0; i < a.rgb.size(); i += 3)
    n += std::abs(a.rgb[i] - b.rgb[i]) + std::abs(a.rgb[i + 1] - b.rgb[i + 1]) +
             std::abs(a.rgb[i + 2] - b.rgb[i + 2]) >
         24;
  return n;
}

/// The page of Plan over a ball with a brain, with one target over its top.
class PlanField : public ::testing::Test {
 protected:
  PlanField() : plan_(model_), place_(services_, model_), cortex_(model_) {
    QSettings().clear();
    if (!scene::hasDisplay()) return;
    page_ = std::make_unique<PlanWorkspace>(plan_, place_, cortex_, model_);
    field_ = page_->findChild<FieldPresenter*>();
    best_ = page_->findChild<BestPosePresenter*>();
    open("case", fixtures::ballWithBrain());
    plan_.addTargetNear(Point<Mri>(4, 6, 37));
    page_->resize(1300, 700);
    page_->show();
    QApplication::processEvents();
  }
  ~PlanField() override { QSettings().clear(); }
  void open(const char* name, const casefile::PreparedCase& prepared) {
    casefile::CaseStore::create(folder_.path() / name, prepared, {}, false);
    TaskMonitor monitor;
    model_.open(loadCase(folder_.path() / name, monitor));
  }
  void press(const QString& words) {
    for (auto* button : page_->findChildren<QAbstractButton*>())
      if (button->text() == words) button->click();
  }
  bool waitForField() {
    return fixtures::waitFor([&] { return field_->shown() != nullptr; });
  }
  /// The text on the page.
  std::string words() const {
    return page_->findChild<FieldView*>()->findChild<QLabel*>("figures_text")->text().toStdString();
  }
  RgbImage picture() { return page_->findChild<LinkedViews*>()->sceneView().scene().render(500, 400); }
  /// Field of the active target as `facenav field` computes it.
  steps::FieldOnCortex expected() const {
    const auto& store = model_.current().store;
    const auto surfaces = steps::fieldSurfaces(store);
    const auto head = steps::headField(store, surfaces, steps::coilPoseOf(*plan_.active()));
    return steps::fieldOnCortex(*head, surfaces, efield::fieldCoil("figure8-70").dipoles, *plan_.active());
  }

  testing::TemporaryFolder folder_;
  CaseModel model_;
  PlanPresenter plan_;
  Services services_;
  PlacePresenter place_;
  CortexPresenter cortex_;
  std::unique_ptr<PlanWorkspace> page_;
  FieldPresenter* field_ = nullptr;
  BestPosePresenter* best_ = nullptr;
};

TEST_F(PlanField, TheSwitchColoursTheBrainAndSaysTheNumbers) {
  if (!page_) GTEST_SKIP() << "no X display here: run under xvfb-run";
  auto* view = page_->findChild<FieldView*>();
  EXPECT_FALSE(view->isVisible()) << "off at first";
  const RgbImage plain = picture();
  press("Electric field");
  EXPECT_TRUE(view->isVisible());
  EXPECT_THAT(words(), HasSubstr("computing"));
  ASSERT_TRUE(waitForField()) << words();
  const auto known = expected();
  EXPECT_NEAR(field_->shown()->at_target, known.at_target.norm(), 1e-9);
  EXPECT_NEAR(field_->shown()->peak, known.peak, 1e-9);
  const QString strengths = QString("E at target %1 V/m, along the normal %2; maximum %3 V/m, %4 mm")
                                .arg(strengthFigure(known.at_target.norm()),
                                     strengthFigure(std::abs(known.along_normal)), strengthFigure(known.peak))
                                .arg(std::lround(known.peak_distance_mm));
  EXPECT_THAT(words(), HasSubstr(strengths.toStdString()));
  EXPECT_THAT(words(), HasSubstr("at 1 A/us; tier 0: a local sphere, usual error 28 %"));
  const std::string bar = view->findChild<ColourLegend*>()->words().toStdString();
  EXPECT_THAT(bar, HasSubstr("|E|, tier 0"));
  EXPECT_THAT(bar, HasSubstr("to " + strengthFigure(known.peak).toStdString() + " V/m"));
  ASSERT_EQ(field_->shown()->strength.size(), model_.current().brain->mesh.vertices_mm.size());
  EXPECT_GT(differing(plain, picture()), 1000);
  press("Electric field");
  EXPECT_FALSE(view->isVisible());
  EXPECT_EQ(differing(plain, picture()), 0);
}

TEST_F(PlanField, TheSlicesShowTheFieldInTheBrainAndTheMenuItsRegion) {
  if (!page_) GTEST_SKIP() << "no X display here: run under xvfb-run";
  const auto fieldsOnSlices = [&] {
    const auto overlay = field_->sliceOverlay();
    return overlay && overlay->map && overlay->within == model_.current().brain_mask;
  };
  FieldPanel panel(*field_);
  const auto* region = panel.findChild<QLabel*>("figures_text");
  EXPECT_EQ(region->text(), "");
  press("Electric field");
  ASSERT_TRUE(waitForField());
  EXPECT_TRUE(region->text().contains("measuring"));
  ASSERT_TRUE(fixtures::waitFor([&] { return field_->reach() != nullptr; }));
  EXPECT_TRUE(fieldsOnSlices());
  const auto& regions = *field_->reach()->regions;
  for (const auto& one : regions)
    EXPECT_THAT(region->text().toStdString(),
                HasSubstr(QString("above %1 %: %2 mm\u00b2 of the brain's hull, %3 ml of the brain")
                              .arg(std::lround(100 * one.share))
                              .arg(std::lround(one.area_mm2))
                              .arg(one.volume_ml, 0, 'f', 1)
                              .toStdString()));
  if (const char* pictures = std::getenv("FACENAV_GUI_PICTURES")) {
    panel.show();
    QApplication::processEvents();
    panel.grab().save(QString("%1/plan_field_menu.png").arg(pictures));
  }
  plan_.nudgeActive(3, 0);
  EXPECT_FALSE(field_->sliceOverlay()) << "nothing of the old pose";
  EXPECT_TRUE(region->text().contains("measuring"));
  ASSERT_TRUE(fixtures::waitFor([&] { return field_->reach() != nullptr; }));
  press("Electric field");
  EXPECT_FALSE(field_->sliceOverlay());
  EXPECT_EQ(region->text(), "");
}

TEST_F(PlanField, AnotherTargetsPoseIsComparedAtTheActiveOne) {
  if (!page_) GTEST_SKIP() << "no X display here: run under xvfb-run";
  const QString first = plan_.activeName();
  plan_.addTargetNear(Point<Mri>(30, 6, 20));
  press("Electric field");
  field_->setAgainst(first);
  ASSERT_TRUE(fixtures::waitFor([&] { return field_->reach() != nullptr; }));
  const auto compared = *field_->reach()->against;
  EXPECT_NEAR(compared.at_target, field_->shown()->at_target, 1e-9);
  const auto words = field_->againstWords();
  EXPECT_TRUE(words.startsWith(QString("against '%1': -").arg(first))) << words.toStdString();
  bool is_shown = false;
  for (const auto* label : page_->findChild<FieldView*>()->findChildren<QLabel*>())
    is_shown = is_shown || (label->isVisible() && label->text() == words);
  EXPECT_TRUE(is_shown);
  plan_.setActive(first);
  ASSERT_TRUE(fixtures::waitFor([&] { return field_->reach() != nullptr; }));
  EXPECT_FALSE(field_->reach()->against) << "a target is not compared with itself";
  EXPECT_EQ(field_->againstWords(), "");
}

TEST_F(PlanField, AnOldModelIsReadOnceSaidAndBuiltAgainInTheBackground) {
  if (!page_) GTEST_SKIP() << "no X display here: run under xvfb-run";
  const auto folder = folder_.path() / "old";
  const auto store = casefile::CaseStore::create(folder, facenav::testing::ballWithCortex(), {}, false);
  efield::writeCortexField({}, "made from other masks", steps::fieldFile(store));
  std::vector<std::string> asked;
  services_.buildField = [&](const std::filesystem::path& which, TaskMonitor&) {
    asked.push_back(which.filename().string());
    if (asked.size() == 1) throw Error("no memory for the equations");
    std::filesystem::remove(steps::fieldFile(store));  // so that it is no longer the old one
  };
  PrepareQueue queue(services_);
  page_->buildFieldsBy(queue);
  TaskMonitor monitor;
  model_.open(loadCase(folder, monitor));
  plan_.addTargetNear(Point<Mri>(0, 0, 66));
  press("Electric field");
  const auto says = [&](const char* text) {
    return fixtures::waitFor([&] { return words().find(text) != std::string::npos; });
  };
  EXPECT_TRUE(says("older than the masks and could not be built again: no memory")) << words();
  EXPECT_EQ(field_->shown()->tier, steps::FieldTier::local_sphere);
  const auto read = field_->head();
  plan_.nudgeActive(1, 0);
  ASSERT_TRUE(waitForField());
  EXPECT_EQ(field_->head(), read) << "the case is not read again for another pose";
  EXPECT_EQ(asked.size(), 1u) << "asked once";
  model_.open(loadCase(folder, monitor));
  EXPECT_TRUE(fixtures::waitFor([&] { return asked.size() == 2; }));
  EXPECT_TRUE(fixtures::waitFor([&] {
    return field_->shown() && words().find("older") == std::string::npos;
  })) << words();
}

TEST_F(PlanField, AMovedTargetTakesTheOldColoursAwayAtOnce) {
  if (!page_) GTEST_SKIP() << "no X display here: run under xvfb-run";
  press("Electric field");
  ASSERT_TRUE(waitForField());
  const auto before = *field_->shown();
  for (int i = 0; i < 5; ++i) {
    plan_.nudgeActive(3, 0);
    EXPECT_EQ(field_->shown(), nullptr);
    EXPECT_FALSE(field_->picture());
    EXPECT_THAT(words(), HasSubstr("computing"));
  }
  ASSERT_TRUE(waitForField());
  EXPECT_NEAR(field_->shown()->at_target, expected().at_target.norm(), 1e-9) << "the newest pose";
  EXPECT_GT((field_->shown()->peak_place.mm - before.peak_place.mm).norm(), 2);
  plan_.setNote("of no weight for the field");
  EXPECT_NE(field_->shown(), nullptr) << "it is the same field";
}

TEST_F(PlanField, AnotherCaseShowsNothingOfTheLastOne) {
  if (!page_) GTEST_SKIP() << "no X display here: run under xvfb-run";
  press("Electric field");
  ASSERT_TRUE(waitForField());
  open("second", fixtures::ballWithBrain());
  EXPECT_EQ(field_->shown(), nullptr);
  EXPECT_THAT(words(), HasSubstr("no target chosen"));
  plan_.addTargetNear(Point<Mri>(0, 37, 0));
  ASSERT_TRUE(waitForField());
  EXPECT_NEAR(field_->shown()->at_target, expected().at_target.norm(), 1e-9);
  open("no brain", fixtures::ballCase());
  plan_.addTarget(Point<Mri>(-40, 5, 60));
  EXPECT_TRUE(fixtures::waitFor([&] { return words().find("no brain model") != std::string::npos; }))
      << words();
  EXPECT_FALSE(field_->picture());
}

TEST_F(PlanField, NothingIsComputedOutOfSight) {
  if (!page_) GTEST_SKIP() << "no X display here: run under xvfb-run";
  page_->hide();
  field_->setOn(true);
  EXPECT_FALSE(field_->wanted());
  page_->show();
  EXPECT_TRUE(waitForField());
  if (const char* pictures = std::getenv("FACENAV_GUI_PICTURES")) {
    fixtures::waitFor([] { return false; }, 300);  // time for drawing
    page_->grab().save(QString("%1/plan_field.png").arg(pictures));
  }
}

TEST_F(PlanField, CoilAndRateAreRememberedAndAPercentageNeedsTheCoilsLargestRate) {
  if (!page_) GTEST_SKIP() << "no X display here: run under xvfb-run";
  press("Electric field");
  ASSERT_TRUE(waitForField());
  const double at_1 = field_->shown()->at_target;
  field_->setRate({66, steps::CurrentRate::Unit::A_per_us});
  EXPECT_EQ(field_->shown(), nullptr);
  ASSERT_TRUE(waitForField());
  EXPECT_NEAR(field_->shown()->at_target, 66 * at_1, 1e-9);
  EXPECT_THAT(words(), HasSubstr("at 66 A/us"));
  field_->setCoil("round");
  ASSERT_TRUE(waitForField());
  EXPECT_GT(std::abs(field_->shown()->at_target - 66 * at_1), 0.1);
  const FieldPresenter next(plan_, model_);
  EXPECT_TRUE(next.isOn());
  EXPECT_EQ(next.coil(), "round");
  EXPECT_EQ(next.rate().value, 66);
  field_->setRate({60, steps::CurrentRate::Unit::output_pct});
  EXPECT_TRUE(fixtures::waitFor([&] { return words().find("give the rate in A/us") != std::string::npos; }))
      << words();
  EXPECT_EQ(words().find('\n'), std::string::npos) << "one line";
  field_->setCoil("none.ccd");
  EXPECT_TRUE(fixtures::waitFor([&] { return words().find("none.ccd") != std::string::npos; })) << words();
}

TEST_F(PlanField, TheBestPoseIsTakenByAPersonAndUndone) {
  if (!page_) GTEST_SKIP() << "no X display here: run under xvfb-run";
  // The coil 10 mm beside the target: a stronger pose is known.
  auto beside = *plan_.active();
  const auto& c = model_.current();
  beside = guidance::movedOnHead(beside, *c.scalp, c.coil.plate, 10, 0);
  beside.cortex_point = plan_.active()->cortex_point;
  model_.setPlan({{beside}});
  emit plan_.changed();
  press("Electric field");
  ASSERT_TRUE(waitForField());
  const double planned = field_->shown()->at_target;
  press("Best angle and place");
  ASSERT_TRUE(fixtures::waitFor([&] { return best_->hasProposal(); })) << best_->words().toStdString();
  EXPECT_EQ(plan_.active()->mri_T_target.translation_mm(), beside.mri_T_target.translation_mm())
      << "nothing changes by itself";
  EXPECT_FALSE(plan_.canRedo());
  EXPECT_THAT(best_->words().toStdString(),
              HasSubstr("V/m in place of " + strengthFigure(planned).toStdString()));
  const QString proposed = best_->words();
  press("Take it");
  EXPECT_FALSE(best_->hasProposal());
  EXPECT_EQ(plan_.active()->cortex_point.mm, beside.cortex_point.mm);
  EXPECT_EQ(plan_.active()->changes.back().what, "best pose");
  const auto& from = beside.mri_T_target;
  const Eigen::Vector3d moved_mm =
      from.rotation().transpose() * (plan_.active()->mri_T_target.translation_mm() - from.translation_mm());
  EXPECT_EQ(proposed.contains("to the left"), moved_mm.x() > 2) << proposed.toStdString();
  EXPECT_EQ(proposed.contains("to the right"), moved_mm.x() < -2) << proposed.toStdString();
  ASSERT_TRUE(waitForField());
  EXPECT_GT(field_->shown()->at_target, 1.02 * planned);
  plan_.undo();
  EXPECT_EQ(plan_.active()->mri_T_target.translation_mm(), beside.mri_T_target.translation_mm());
  EXPECT_EQ(plan_.active()->mri_T_target.rotation(), beside.mri_T_target.rotation());
  ASSERT_TRUE(waitForField());
  EXPECT_NEAR(field_->shown()->at_target, planned, 1e-9);
  plan_.lockActive(true);
  EXPECT_FALSE(best_->isPossible());
}

TEST_F(PlanField, TheModelWithTheFluidIsBuiltOnRequestAndCanBeStopped) {
  if (!page_) GTEST_SKIP() << "no X display here: run under xvfb-run";
  FieldPanel panel(*field_);
  const auto button = [&] { return panel.findChild<QPushButton*>(); };
  EXPECT_FALSE(button()->isEnabled()) << "the case has no cortex with sulci";
  open("with cortex", testing::ballWithCortex());
  ASSERT_TRUE(button()->isEnabled());
  EXPECT_EQ(button()->text().toStdString(), "with the fluid (takes about 60 s)");
  const auto& store = model_.current().store;
  button()->click();
  EXPECT_TRUE(fixtures::waitFor([&] { return button()->text().contains("equations"); }, 60000))
      << button()->text().toStdString();
  EXPECT_THAT(button()->text().toStdString(), HasSubstr("%: stop"));
  button()->click();
  EXPECT_TRUE(fixtures::waitFor([&] { return !field_->fluid().isBuilding(); }, 60000));
  EXPECT_FALSE(std::filesystem::exists(steps::fieldFile(store, steps::FieldTier::four_shells)));
  EXPECT_EQ(button()->text().toStdString(), "with the fluid (takes about 60 s)");
}

TEST_F(PlanField, TheModelWithTheFluidIsNamed) {
  if (!page_) GTEST_SKIP() << "no X display here: run under xvfb-run";
  const auto store =
      casefile::CaseStore::create(folder_.path() / "fluid", testing::ballWithCortex(), {}, false);
  TaskMonitor monitor;
  steps::buildField(store, monitor, steps::FieldTier::four_shells, {2, 600});
  model_.open(loadCase(folder_.path() / "fluid", monitor));
  plan_.addTargetNear(Point<Mri>(4, 6, 66));
  FieldPanel panel(*field_);
  EXPECT_FALSE(panel.findChild<QPushButton*>()->isEnabled());
  EXPECT_EQ(panel.findChild<QPushButton*>()->text().toStdString(), "with the fluid: built");
  press("Electric field");
  ASSERT_TRUE(waitForField()) << words();
  EXPECT_THAT(words(), HasSubstr("tier 2: four shells with the fluid, usual error"));
}

TEST_F(PlanField, NoTextIsCutAtTwiceTheTextSizeIn1366By768) {
  if (!page_) GTEST_SKIP() << "no X display here: run under xvfb-run";
  changeTextScale(*qApp, 2.0);
  page_->resize(1366, 768);
  QApplication::processEvents();
  const QStringList before = testing::cutTexts(*page_) + testing::misplacedParts(*page_);
  press("Electric field");
  ASSERT_TRUE(waitForField());
  fixtures::waitFor([] { return false; }, 300);  // time for layout
  for (const QString& fault : testing::cutTexts(*page_) + testing::misplacedParts(*page_))
    EXPECT_TRUE(before.contains(fault)) << fault.toStdString();
  FieldPanel panel(*field_);
  panel.show();
  QApplication::processEvents();
  EXPECT_EQ(testing::cutTexts(panel).join('\n').toStdString(), "");
  changeTextScale(*qApp, 1.0);
}

}  // namespace
}  // namespace facenav::ui
