#include <gtest/gtest.h>

#include "facenav/coil_tracking/coil_tracker.h"
#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "support/matchers.h"
#include "support/test_data.h"

namespace facenav::coil_tracking {
namespace {
using facenav::testing::PoseNear;
using facenav::testing::TemporaryFolder;

const std::string kShifted = "[1,0,0,10, 0,1,0,-20, 0,0,1,5, 0,0,0,1]";

std::string faultOf(const std::string& content) {
  const TemporaryFolder folder;
  writeWholeFile(folder.path() / "coil.json", content);
  try {
    readCoil(folder.path() / "coil.json");
  } catch (const Error& fault) {
    return fault.what();
  }
  return "";
}

TEST(CoilModel, ReadsTheSingleMarkerForm) {
  const TemporaryFolder folder;
  writeWholeFile(folder.path() / "coil.json",
                 R"({"name": "figure-8 70 mm", "marker": {"dictionary": "4x4_50", "id": 7, "size_mm": 60},
                     "marker_T_coil": )" +
                     kShifted + R"(, "mesh": "coil.stl", "colour": "grey"})");
  const CoilModel coil = readCoil(folder.path() / "coil.json");
  EXPECT_EQ(coil.name, "figure-8 70 mm");
  ASSERT_EQ(coil.markers.size(), 1u);
  EXPECT_EQ(coil.markers[0].id, 7);
  EXPECT_EQ(coil.marker_T_coil().translation_mm(), Eigen::Vector3d(10, -20, 5));
  EXPECT_EQ(coil.markers[0].coil_T_marker.translation_mm(), Eigen::Vector3d(-10, 20, -5));
  EXPECT_EQ(*coil.mesh, folder.path() / "coil.stl");
}

TEST(CoilModel, RoundTripsSeveralMarkers) {
  const TemporaryFolder folder;
  CoilModel coil = defaultCoil();
  coil.name = "two";
  coil.markers.push_back(
      {"6x6_250", 41, {}, 35.5, 0.2, {Eigen::Quaterniond(0.5, 0.5, -0.5, 0.5), {70, 0, -3}}});
  writeCoil(coil, folder.path() / "coil.json");
  const CoilModel read = readCoil(folder.path() / "coil.json");
  ASSERT_EQ(read.markers.size(), 2u);
  EXPECT_EQ(read.markers[1].dictionary, "6x6_250");
  EXPECT_EQ(read.markers[1].size_mm, 35.5);
  EXPECT_THAT(read.markers[1].coil_T_marker, PoseNear(coil.markers[1].coil_T_marker, 1e-9, 1e-9));
  writeCoil(defaultCoil(), folder.path() / "one.json");
  EXPECT_EQ(readCoil(folder.path() / "one.json").markers.size(), 1u);
  EXPECT_TRUE(readCoil(folder.path() / "one.json").tip.mm.isZero()) << "the contact face's centre";
  coil.tip = Point<Coil>(98.5, 0, -2);
  writeCoil(coil, folder.path() / "coil.json");
  EXPECT_EQ(readCoil(folder.path() / "coil.json").tip.mm, coil.tip.mm);
}

TEST(CoilModel, NamesFileAndKeyOfAFault) {
  const std::string marker = R"({"dictionary": "4x4_50", "id": 7, "size_mm": 60})";
  const auto with = [&](const std::string& changed) {
    return R"({"marker": )" + changed + R"(, "marker_T_coil": )" + kShifted + "}";
  };
  EXPECT_EQ(faultOf(with(marker)), "");
  const struct {
    std::string content, word;
  } faults[] = {
      {"{}", "'marker'"},
      {R"({"marker": )" + marker + "}", "marker_T_coil"},
      {with(R"({"dictionary": "4x4_50", "id": 7})"), "marker.size_mm"},
      {with(R"({"dictionary": "4x4_50", "id": 7, "size_mm": 0.06})"), "millimetres"},  // metres
      {with(R"({"dictionary": "4x4_50", "id": 50, "size_mm": 60})"), "id 50"},
      {with(R"({"dictionary": "9x9", "id": 7, "size_mm": 60})"), "4x4_50"},
      {with(R"({"pattern": "none.patt", "size_mm": 60})"), "none.patt"},
      {R"({"marker": )" + marker + R"(, "marker_T_coil": [-1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]})",
       "mirrored"},
      {R"({"markers": []})", "markers"},
      {R"({"markers": [{"dictionary": "4x4_50", "id": 7, "size_mm": 60}]})", "markers[0].coil_T_marker"},
      {R"({"markers": [{"dictionary": "4x4_50", "id": 7, "size_mm": 60, "coil_T_marker": )" + kShifted +
           R"(}, {"dictionary": "4x4_50", "id": 7, "size_mm": 50, "coil_T_marker": )" + kShifted + "}]}",
       "twice"},
      {R"({"marker": )" + marker + R"(, "tip_mm": [1, 2], "marker_T_coil": )" + kShifted + "}", "tip_mm"},
      {R"({"marker": )" + marker + R"(, "tip_mm": [0, 900, 0], "marker_T_coil": )" + kShifted + "}",
       "500 mm"},
  };
  for (const auto& fault : faults) {
    const std::string message = faultOf(fault.content);
    EXPECT_NE(message.find("coil.json"), std::string::npos) << message;
    EXPECT_NE(message.find(fault.word), std::string::npos) << fault.word << " in: " << message;
  }
}

}  // namespace
}  // namespace facenav::coil_tracking
