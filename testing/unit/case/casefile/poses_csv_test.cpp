#include "facenav/casefile/poses_csv.h"

#include <gtest/gtest.h>

#include <clocale>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "support/matchers.h"
#include "support/test_data.h"

namespace facenav::casefile {
namespace {
using facenav::testing::PoseNear;
using facenav::testing::TemporaryFolder;
using HeadPose = RigidTransform<Camera, Mri>;
using CoilPose = RigidTransform<Camera, Coil>;

const std::string kHeader = "frame,t_s,object,status,tx,ty,tz,qw,qx,qy,qz,quality,reason\n";

std::string faultOfReading(const std::string& content) {
  const TemporaryFolder folder;
  writeWholeFile(folder.path() / "poses.csv", content);
  try {
    readPoses(folder.path() / "poses.csv");
  } catch (const Error& fault) {
    return fault.what();
  }
  return "";
}

TEST(PosesCsv, WritesTheColumnsOfTheFormat) {
  const HeadPose pose(Eigen::Quaterniond(-0.5, 0.5, -0.5, 0.5),
                      {1.5, -2, 600.25});  // w < 0: written as its negative
  EXPECT_EQ(posesCsvHeader(),
            "frame,t_s,object,status,tx,ty,tz,qw,qx,qy,qz,quality,reason,of_frame,detail\n");
  EXPECT_EQ(toCsvLine(poseRow(3, 0.05, PoseObject::head, Tracked<HeadPose>(pose, 0.875))),
            "3,0.050000,head,tracked,1.500000,-2.000000,600.250000,0.500000000,-0.500000000,0.500000000,"
            "-0.500000000,0.8750,,mri,\n");
  EXPECT_EQ(toCsvLine(poseRow(4, 0.1, PoseObject::coil, Tracked<CoilPose>(Lost{LostReason::no_marker}))),
            "4,0.100000,coil,lost,,,,,,,,0,no_marker,coil,\n");
}

TEST(PosesCsv, RoundTripHoldsMicrometres) {
  const TemporaryFolder folder;
  const CoilPose pose(Eigen::Quaterniond(0.3, 0.1, -0.8, 0.2), {-31.234567, 12.5, 701.999});
  auto lost = poseRow(0, 0.0, PoseObject::head, Tracked<HeadPose>(Lost{LostReason::high_residual}));
  lost.detail = "drift";
  writePoses({lost, poseRow(0, 0.0, PoseObject::coil, Tracked<CoilPose>(pose, 0.5))},
             folder.path() / "poses.csv");
  const auto rows = readPoses(folder.path() / "poses.csv");
  ASSERT_EQ(rows.size(), 2u);
  const auto head = rows[0].tracked<Camera, Mri>();
  EXPECT_FALSE(head.isTracked());
  EXPECT_EQ(head.reason(), LostReason::high_residual);
  const auto coil = rows[1].tracked<Camera, Coil>();
  ASSERT_TRUE(coil.isTracked());
  EXPECT_THAT(*coil, PoseNear(pose, 1e-6, 2e-6));
  EXPECT_EQ(coil.quality(), 0.5);
  EXPECT_EQ(rows[0].of_frame, "mri");
  EXPECT_EQ(rows[0].detail, "drift");
  EXPECT_EQ(rows[1].of_frame, "coil");
}

TEST(PosesCsv, ReadsColumnsInAnyOrderAndIgnoresUnknownOnes) {
  const TemporaryFolder folder;
  writeWholeFile(folder.path() / "poses.csv",
                 "\xEF\xBB\xBFremark,object,frame,t_s,status,qw,qx,qy,qz,tx,ty,tz,quality,reason\r\n"
                 "\"a, b\",coil,7,0.1,tracked,1,0,0,0,10,20,30,1,\r\n");
  const auto rows = readPoses(folder.path() / "poses.csv");
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].frame, 7);
  EXPECT_EQ(rows[0].pose->translation(), Eigen::Vector3d(10, 20, 30));
}

TEST(PosesCsv, NamesFileAndLineOfAFault) {
  const std::string good = "0,0,head,tracked,1,2,3,1,0,0,0,1,\n";
  EXPECT_EQ(faultOfReading(kHeader + good), "");
  for (const char* bad :
       {"1,0,head,tracked,1,2,x,1,0,0,0,1,", "1,0,head,tracked,1,2,nan,1,0,0,0,1,",
        "1,0,head,tracked,1,2,3,1,1,0,0,1,", "1,0,head,tracked,,,,,,,,1,",
        "1,0,foot,tracked,1,2,3,1,0,0,0,1,", "1,0,head,seen,1,2,3,1,0,0,0,1,", "1,0,head,lost,,,,,,,,0,gone",
        "1,0,head,tracked,1,2,3,1,0,0,0,7,", "1,0,head,tracked,1,2", "1.5,0,head,lost,,,,,,,,0,camera"}) {
    const std::string fault = faultOfReading(kHeader + good + bad + "\n");
    EXPECT_NE(fault.find("poses.csv, line 3"), std::string::npos) << bad << " gave: " << fault;
  }
  EXPECT_NE(faultOfReading("frame,t_s\n0,0\n").find("'object'"), std::string::npos);
  EXPECT_NE(faultOfReading("").find("empty"), std::string::npos);
}

TEST(PosesCsv, KeepsItsDecimalPointInEveryLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8"}) std::setlocale(LC_ALL, name);  // if installed
  const std::string line = toCsvLine({1, 0.5, PoseObject::head, Eigen::Isometry3d::Identity(), 0.5, {}, ""});
  std::setlocale(LC_ALL, before.c_str());
  EXPECT_NE(line.find("0.500000,head"), std::string::npos);
}

}  // namespace
}  // namespace facenav::casefile
