#include "plan/cortex_presenter.h"

#include <gtest/gtest.h>

#include "gui_fixtures.h"

namespace facenav::ui {
namespace {

class CortexPresenterTest : public ::testing::Test {
 protected:
  CortexPresenterTest() : cortex_(model_) {}
  void open(bool has_brain) {
    casefile::CaseStore::create(folder_.path() / "case",
                                has_brain ? fixtures::ballWithBrain() : fixtures::ballCase(), {}, true);
    TaskMonitor monitor;
    model_.open(loadCase(folder_.path() / "case", monitor));
  }
  testing::TemporaryFolder folder_;
  CaseModel model_;
  CortexPresenter cortex_;
};

TEST_F(CortexPresenterTest, TheCortexIsMadeWhenItIsFirstAskedFor) {
  open(true);
  EXPECT_FALSE(cortex_.isMaking());
  cortex_.setLook(scene::BrainLook::cortex);
  EXPECT_TRUE(cortex_.isMaking());
  EXPECT_TRUE(cortex_.words().contains("%"));
  ASSERT_TRUE(fixtures::waitFor([&] { return cortex_.cortex() != nullptr; }));
  EXPECT_TRUE(cortex_.words().isEmpty());
  cortex_.setLook(scene::BrainLook::distance);
  EXPECT_TRUE(cortex_.words().contains("median"));
  EXPECT_GE(cortex_.scale_mm(), 2.0);
}

TEST_F(CortexPresenterTest, AnotherBrainIsMadeAnewAndAnOldOneNeverShown) {
  open(true);
  cortex_.setLook(scene::BrainLook::cortex);
  open(true);  // while the first is being computed
  EXPECT_EQ(cortex_.cortex(), nullptr);
  ASSERT_TRUE(fixtures::waitFor([&] { return cortex_.cortex() != nullptr; }));
  const auto first = cortex_.cortex();
  open(true);
  EXPECT_EQ(cortex_.cortex(), nullptr);
  ASSERT_TRUE(fixtures::waitFor([&] { return cortex_.cortex() != nullptr; }));
  EXPECT_NE(cortex_.cortex(), first);
}

TEST_F(CortexPresenterTest, ACaseWithoutABrainSaysSo) {
  open(false);
  cortex_.setLook(scene::BrainLook::cortex);
  EXPECT_FALSE(cortex_.isMaking());
  EXPECT_TRUE(cortex_.words().contains("no brain"));
}

TEST_F(CortexPresenterTest, ThePeelDepthStaysInItsRangeAndIsRemembered) {
  cortex_.setPeel_mm(90);
  EXPECT_EQ(cortex_.peel_mm(), scene::kMostPeel_mm);
  cortex_.setPeel_mm(12.5);
  EXPECT_EQ(CortexPresenter(model_).peel_mm(), 12.5);
}

}  // namespace
}  // namespace facenav::ui
