#include "facenav/treat/live_orders.h"

#include <gmock/gmock.h>

#include "facenav/casefile/kept_session.h"
#include "facenav/casefile/sign_off.h"
#include "facenav/core/error.h"
#include "support/ball_case.h"
#include "support/test_data.h"
#include "unit/treat/session/session_fakes.h"

namespace facenav::steps {
namespace {

namespace fakes = session::fakes;
using ::testing::HasSubstr;

const RigidTransform<Camera, Marker> kOrderedCoil(Eigen::Quaterniond::Identity(), {20, -60, 550});

class LiveOrdersTest : public ::testing::Test {
 protected:
  LiveOrdersTest()
      : store_(casefile::CaseStore::create(folder_.path() / "case", testing::ballCase(), {}, false)) {
    casefile::signOff(store_, {"XY", "", true});
    auto alignment = std::make_shared<AlignmentOutcome>();
    alignment->result.camera_T_mri = fakes::cameraAtReference();
    capture::Recording recording;
    recording.rig = fakes::rig();
    const TreatmentRequest request{store_, recording, false, coil_tracking::defaultCoil(), alignment};
    const TreatmentDevices devices{
        [](const session::NavigatorSetup& setup) {
          return std::make_unique<session::Navigator>(
              setup, std::make_unique<fakes::Head>([](auto) { return RigidTransform<Camera, Head>(); }),
              std::make_unique<fakes::Coil>(kOrderedCoil));
        },
        [] { return std::make_unique<fakes::Source>(3000, 0.01); }};
    treatment_ = std::make_unique<Treatment>(prepareTreatment(request, devices),
                                             fakes::targetAt(kOrderedCoil.reframe<Camera, Coil>()));
    while (treatment_->session().latest()->frame < 2)
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }

  void send(const links::LiveOrder& order) { server_.receive(order); }
  void command(const std::string& word) {
    links::LiveOrder order;
    order.from = "127.0.0.1:50112";
    order.name = word;
    order.arrived = Timestamp::now();
    send(order);
  }
  void target(const std::string& name, const Eigen::Matrix4d& pose) {
    links::LiveOrder order;
    order.kind = links::LiveOrder::Kind::target;
    order.from = "127.0.0.1:50112";
    order.name = name;
    order.pose = pose;
    send(order);
  }
  /// A coil on top of the ball, `gap_mm` above its skin at 90 mm.
  static Eigen::Matrix4d onTop(double gap_mm) {
    Eigen::Matrix4d pose = Eigen::Matrix4d::Identity();
    pose.topLeftCorner<3, 3>() = Eigen::Vector3d(1, -1, -1).asDiagonal();  // z into the head
    pose(2, 3) = 90 + gap_mm;
    return pose;
  }
  std::vector<OrderNews> obey() { return orders_.obey(*treatment_, store_); }

  testing::TemporaryFolder folder_;
  casefile::CaseStore store_;
  LiveOrders orders_;
  links::LiveIncoming server_ = orders_.incoming(true, true);
  std::unique_ptr<Treatment> treatment_;
};

TEST_F(LiveOrdersTest, CommandsPauseGoOnAndReportAPulse) {
  command("stop");
  EXPECT_THAT(obey().front().words, HasSubstr("from 127.0.0.1:50112"));
  EXPECT_TRUE(treatment_->isPaused());
  command("start");
  obey();
  EXPECT_FALSE(treatment_->isPaused());
  command("pulse");
  obey();
  for (int i = 0; i < 400 && treatment_->log().pulses() == 0; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  treatment_->end();
  const auto kept = casefile::readSession(casefile::findSession(store_.folder(), ""));
  ASSERT_EQ(kept.pulses.pulses.size(), 1u);
  EXPECT_EQ(kept.pulses.pulses.front().pulse.source, "igtl");
  std::string events;
  for (const auto& event : kept.events) events += event.event + ": " + event.detail + "\n";
  EXPECT_THAT(events, HasSubstr("pause: stopped by 127.0.0.1:50112"));
  EXPECT_THAT(events, HasSubstr("command: command pulse from 127.0.0.1:50112"));
}

TEST_F(LiveOrdersTest, ATargetIsOfferedAndTheChosenOneStaysAsItWas) {
  const auto before = treatment_->session().latest()->chosen;
  target("Target_M1", onTop(4));
  const auto news = obey();
  ASSERT_EQ(news.size(), 1u);
  EXPECT_EQ(news.front().offered, "Target_M1");
  EXPECT_THAT(news.front().words, HasSubstr("at (0.0, 0.0, 94.0) mm: offered"));
  EXPECT_TRUE(store_.targets().targets.empty()) << "nothing is in the plan until a person takes it";
  std::this_thread::sleep_for(std::chrono::milliseconds(40));
  EXPECT_EQ(treatment_->session().latest()->chosen, before);
  target("Target_M1", onTop(4));
  EXPECT_TRUE(obey().empty()) << "the same once more is no news";
  EXPECT_THROW(orders_.take("Target_M2", store_, ""), Error);
  orders_.take("Target_M1", store_, "AB");
  const auto taken = store_.targets().find("Target_M1");
  EXPECT_LT((taken.mri_T_target.matrix() - onTop(4)).norm(), 1e-6);
  EXPECT_THAT(taken.note, HasSubstr("127.0.0.1:50112"));
  EXPECT_EQ(treatment_->session().latest()->chosen, before);
}

TEST_F(LiveOrdersTest, ATargetThatCannotBeRightIsRefusedInWords) {
  Eigen::Matrix4d mirrored = onTop(4);
  mirrored.col(0) *= -1;
  target("Target_mirrored", mirrored);
  target("Target_far", onTop(500));
  target("Target_none", Eigen::Matrix4d::Identity());
  links::LiveOrder point;
  point.kind = links::LiveOrder::Kind::target;
  point.name = "Target_point";
  point.place_mm = Eigen::Vector3d(0, 0, 90);
  send(point);
  const auto news = obey();
  ASSERT_EQ(news.size(), 4u);
  for (const auto& each : news) {
    EXPECT_EQ(each.offered, "") << each.words;
    EXPECT_THAT(each.words, HasSubstr("not taken: "));
  }
  EXPECT_THROW(orders_.take("Target_mirrored", store_, ""), Error);
  EXPECT_TRUE(store_.targets().targets.empty());
}

TEST_F(LiveOrdersTest, WithoutASessionCommandsAreToldAndTargetsAreOffered) {
  const OrderReceiver nobody{[](const auto&) { return std::string("no session runs"); }};
  command("stop");
  target("Target_M1", onTop(4));
  const auto news = orders_.obey(nobody, &store_);
  ASSERT_EQ(news.size(), 2u);
  EXPECT_THAT(news[0].words, HasSubstr("command stop from 127.0.0.1:50112: no session runs"));
  EXPECT_EQ(news[1].offered, "Target_M1");
  EXPECT_TRUE(obey().empty()) << "a session that starts later obeys no old command";
  EXPECT_FALSE(treatment_->isPaused());
  guidance::TreatmentPlan written;
  orders_.take("Target_M1", store_, "AB", [&](const guidance::TreatmentPlan& plan) { written = plan; });
  ASSERT_EQ(written.targets.size(), 1u);
  EXPECT_TRUE(store_.targets().targets.empty()) << "the writer stores the plan";
  EXPECT_TRUE(orders_.offers().empty());
  orders_.forget();
  target("Target_M1", onTop(4));
  EXPECT_THAT(orders_.obey(nobody, nullptr).front().words, HasSubstr("there is no case"));
}

TEST_F(LiveOrdersTest, ARefusedTargetReturnsOnlyWithAnotherPose) {
  target("Target_M1", onTop(4));
  obey();
  orders_.refuse("Target_M1");
  EXPECT_THROW(orders_.take("Target_M1", store_, ""), Error);
  target("Target_M1", onTop(4));
  EXPECT_TRUE(obey().empty());
  EXPECT_TRUE(orders_.offers().empty());
}

TEST_F(LiveOrdersTest, ATargetThatIsMovedIsJudgedOnceASecond) {
  int judged = 0;
  for (int i = 0; i < 30; ++i) {
    target("Target_M1", onTop(4 + 0.1 * i));
    judged += int(obey().size());
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  EXPECT_EQ(judged, 1);
  std::this_thread::sleep_for(std::chrono::milliseconds(900));
  const auto last = obey();
  ASSERT_EQ(last.size(), 1u) << "the newest pose is judged at last";
  EXPECT_THAT(last.front().words, HasSubstr("96.9"));
}

}  // namespace
}  // namespace facenav::steps
