// What is written comes back within the digits of the format, on a T1 that is not stored in RAS order and
// whose qform and sform differ; names of every script survive.

#include <gmock/gmock.h>

#include "two_forms.h"

namespace facenav::interop {
namespace {

using namespace interop::testing;

const char* const kNames[] = {"M1 hand L", "mano, \"sinistra\" <&>", "左手 運動野", "рука 'M1' \\ правая",
                              "يد #1"};

/// Five targets on the head, two pulses (one without a pose) and a landmark.
Order madeOrder(const T1& t1) {
  Order order;
  order.t1 = t1;
  order.software = "FaceNav 0.1.0";
  order.utc = "2026-11-27T14:05:09.123Z";
  order.coil = "figure-8 70 mm";
  int number = 0;
  for (const char* name : kNames) {
    Item item;
    item.name = name;
    const Eigen::Vector3d turn(0.4 * number - 1.1, 2.3 - 0.3 * number, 0.7 * number);
    item.mri_T_coil = RigidTransform<Mri, Coil>(Eigen::Quaterniond(expRotation(turn)),
                                                t1.grid.centre().mm + 80.0 * expRotation(turn).col(2));
    item.cortex_point_mm = t1.grid.centre().mm + 55.0 * expRotation(turn).col(2);
    order.items.push_back(item);
    ++number;
  }
  for (const bool has_pose : {true, false}) {
    auto pulse = madePulse("20261127T140509Z", kNames[2]);
    pulse.name = has_pose ? "Sample 1" : "Sample 2";
    if (has_pose) pulse.mri_T_coil = order.items[2].mri_T_coil;
    pulse.reason = has_pose ? "" : "face not seen";
    order.items.push_back(pulse);
  }
  order.items.push_back(nasionAt(t1.grid.centre()));
  return order;
}

Poses posesOf(const Order& order) {
  Poses poses;
  for (const auto& item : order.items)
    if (item.kind == Kind::target) poses.emplace(item.name, *item.mri_T_coil);
  return poses;
}

class RoundTrip : public ::testing::Test {
 protected:
  facenav::testing::TemporaryFolder folder_;
  T1 t1_ = writeTwoForms(folder_.path() / "t1.nii");
  CaseHead head_ = headOf(t1_);
  OtherFile back(const std::string& format, const Order& order, const std::string& name = "file") {
    return readCheckedText(writtenFormat(format).write(order).content, head_, {}, name);
  }
};

TEST_F(RoundTrip, TheTwoFormsOfTheT1Differ) {
  EXPECT_EQ(t1_.used, "sform");
  EXPECT_GT(t1_.formsApart_mm(), 10.0);
  EXPECT_LT(t1_.grid.mri_from_voxel(0, 0), 0.0) << "stored from the right to the left";
}

TEST_F(RoundTrip, PosesAndNamesComeBackWithinTheDigits) {
  const std::map<std::string, std::array<double, 2>> kDigits{
      // mm, deg
      {"brainsight", {1e-4, 6e-3}},  {"localite", {1e-9, 1e-6}}, {"simnibs-csv", {1e-6, 8e-5}},
      {"simnibs-mat", {1e-9, 1e-6}}, {"visor2", {1e-9, 1e-6}},   {"softaxic", {6e-4, 1e-4}},
      {"mkss", {1e-9, 1e-5}},        {"mrk.json", {1e-9, 1e-6}}, {"navinibs", {1e-9, 1e-6}},
      {"csv", {1e-6, 1e-6}},         {"json", {1e-9, 1e-6}}};
  Order order = madeOrder(t1_);
  const Order with_pulses = order;
  order.items.erase(order.items.begin() + 5, order.items.begin() + 7);
  for (const auto& [format, digits] : kDigits) {
    const bool holds_both = format == "brainsight" || format == "csv";
    const auto file = back(format, holds_both ? with_pulses : order);
    EXPECT_EQ(file.format, format);
    const auto difference = apart(file, posesOf(order));
    EXPECT_EQ(difference.compared, 5) << format << ": all names come back";
    EXPECT_LE(difference.mm, digits[0]) << format;
    EXPECT_LE(difference.deg, digits[1]) << format;
    for (const auto& item : file.items) EXPECT_EQ(item.refusal, "") << format << " " << item.name;
  }
}

TEST_F(RoundTrip, ATransformHoldsOneTargetUnderTheFilesName) {
  Order order = madeOrder(t1_);
  EXPECT_THROW(writtenFormat("tfm").write(order), Error);
  order.items = {order.items[2]};
  const auto file = back("tfm", order, std::string(kNames[2]) + ".tfm");
  const auto difference = apart(file, posesOf(order));
  EXPECT_EQ(difference.compared, 1);
  EXPECT_LE(difference.mm, 1e-9);
}

TEST_F(RoundTrip, PulsesComeBackWithTimeStrengthAndAnswer) {
  for (const char* format : {"brainsight", "csv", "localite"}) {
    Order order = madeOrder(t1_);
    if (format == std::string("localite")) order.items.erase(order.items.begin(), order.items.begin() + 5);
    const auto file = back(format, order, "TriggerMarkers_Coil0_20261127140509250.xml");
    const auto& pulse = itemNamed(file, "Sample 1");
    EXPECT_EQ(pulse.kind, Kind::pulse) << format;
    EXPECT_NEAR(*pulse.clock_s, 1795788309.25, 1e-3) << format;
    EXPECT_EQ(pulse.intensity_pct, 61.5) << format;
    EXPECT_EQ(pulse.mep_uv, 412.25) << format;
    ASSERT_TRUE(pulse.mri_T_coil) << format;
    EXPECT_LT(poseError(*pulse.mri_T_coil, *madeOrder(t1_).items[5].mri_T_coil).translation_mm, 1e-4)
        << format;
  }
}

TEST_F(RoundTrip, APulseWithoutAPoseStaysOneWhereTheFormatHoldsIt) {
  Order order = madeOrder(t1_);
  EXPECT_FALSE(itemNamed(back("csv", order), "Sample 2").mri_T_coil);
  const auto written = writtenFormat("brainsight").write(order);
  EXPECT_THAT(written.notes,
              ::testing::Contains(::testing::HasSubstr("1 pulses without a pose are left out")));
  order.items.erase(order.items.begin(), order.items.begin() + 5);
  const auto localite = back("localite", order);
  EXPECT_FALSE(itemNamed(localite, "Sample 2").pose);
  EXPECT_THAT(itemNamed(localite, "Sample 2").reason, ::testing::HasSubstr("not tracked"));
}

TEST_F(RoundTrip, TheScriptForSimnibsHoldsEveryName) {
  const std::string script = writtenFormat("simnibs-py").write(madeOrder(t1_)).content;
  EXPECT_THAT(script, ::testing::HasSubstr("pos.name = 'рука \\'M1\\' \\\\ правая'"));
  EXPECT_THAT(script, ::testing::HasSubstr("run_simnibs(s)"));
}

}  // namespace
}  // namespace facenav::interop
