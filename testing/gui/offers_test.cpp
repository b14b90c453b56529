// Targets that clients of the server offer, in Plan and in Treat: looked at, taken into the plan, refused.

#include <gmock/gmock.h>

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSettings>

#include "gui_fixtures.h"
#include "plan/plan_presenter.h"
#include "treat/offer_panel.h"
#include "treat/treat_presenter.h"

namespace facenav::ui {
namespace {

using ::testing::HasSubstr;

/// A ball case that is open, a server's end, and the panels of both pages.
class Offers : public ::testing::Test {
 protected:
  Offers()
      : plan_(model_),
        treat_(services_, model_, tasks_),
        in_plan_(treat_.offers(), OfferPanel::Page::plan),
        in_treat_(treat_.offers(), OfferPanel::Page::treat) {
    QSettings().clear();
    model_.open(fixtures::loadBallCase(folder_.path()));
    treat_.offers().keepBy(
        [this](const guidance::TreatmentPlan& plan, const QString& taken) { plan_.takePlan(plan, taken); });
  }
  /// A coil that a client sends, `gap_mm` above the top of the ball.
  void send(const std::string& name, double gap_mm) {
    links::LiveOrder order;
    order.kind = links::LiveOrder::Kind::target;
    order.from = "127.0.0.1:50112";
    order.name = name;
    Eigen::Matrix4d pose = Eigen::Matrix4d::Identity();
    pose.topLeftCorner<3, 3>() = Eigen::Vector3d(1, -1, -1).asDiagonal();  // z into the head
    pose(2, 3) = 90 + gap_mm;
    order.pose = pose;
    server_.receive(order);
    news_ = treat_.obeyOrders();
  }
  static void press(OfferPanel& panel, const QString& words) {
    for (auto* button : panel.findChildren<QPushButton*>())
      if (button->text() == words) return button->click();
    ADD_FAILURE() << "no button " << words.toStdString();
  }

  testing::TemporaryFolder folder_;
  Services services_;
  CaseModel model_;
  TaskRunner tasks_;
  PlanPresenter plan_;
  TreatPresenter treat_;
  OfferPanel in_plan_, in_treat_;
  links::LiveIncoming server_ = treat_.offers().orders().incoming(true, true);
  QString news_;
};

TEST_F(Offers, ATargetIsDrawnAndTakenAsOneStepAndNeverChosen) {
  EXPECT_TRUE(in_plan_.isHidden());
  int previews = 0;
  QObject::connect(&in_plan_, &OfferPanel::previewChanged, [&] { ++previews; });
  send("Target_M1", 4);
  EXPECT_THAT(news_.toStdString(), HasSubstr("offered; the chosen target is as before"));
  EXPECT_FALSE(in_plan_.isHidden());
  EXPECT_FALSE(in_treat_.isHidden());
  ASSERT_TRUE(in_plan_.previewed());
  EXPECT_NEAR(in_plan_.previewed()->mri_T_coil.translation_mm().z(), 94, 1e-6);
  EXPECT_THAT(in_plan_.previewed()->words.toStdString(),
              HasSubstr("from 127.0.0.1:50112, at 0.0  0.0  94.0"));
  EXPECT_FALSE(in_treat_.previewed()) << "Treat draws no pose but the target's";
  press(in_plan_, "Preview");
  EXPECT_FALSE(in_plan_.previewed());
  EXPECT_EQ(previews, 2);
  EXPECT_TRUE(plan_.plan().targets.empty());
  press(in_treat_, "Take");
  ASSERT_EQ(plan_.plan().targets.size(), 1u);
  EXPECT_EQ(plan_.activeName(), "Target_M1");
  EXPECT_EQ(treat_.targetName(), "") << "Treat aims at nothing that was not chosen";
  EXPECT_TRUE(in_plan_.isHidden());
  plan_.undo();
  EXPECT_TRUE(plan_.plan().targets.empty());
}

TEST_F(Offers, ARefusedOneIsPutAwayAndAWrongOneIsNotOffered) {
  send("Target_far", 500);
  EXPECT_THAT(news_.toStdString(), HasSubstr("not taken"));
  EXPECT_TRUE(in_plan_.isHidden());
  send("Target_A", 4);
  send("Target_B", 6);
  auto* names = in_plan_.findChild<QComboBox*>();
  EXPECT_EQ(names->count(), 2);
  QString page;
  QObject::connect(&treat_.offers(), &OffersPresenter::shown, [&](const QString& name) { page = name; });
  press(in_treat_, "Show in Plan");
  EXPECT_EQ(page, "Target_A");
  press(in_plan_, "Refuse");
  EXPECT_EQ(names->count(), 1);
  EXPECT_EQ(names->currentText(), "Target_B");
  EXPECT_TRUE(model_.current().store.targets().targets.empty());
  model_.open(std::make_shared<LoadedCase>(model_.current()));
  EXPECT_TRUE(in_plan_.isHidden()) << "another case: its offers are gone";
}

}  // namespace
}  // namespace facenav::ui
