// Files that other code wrote for this project, and real files of other people: the truth comes back within
// the digits of each format.

#include <gmock/gmock.h>

#include "interop_fixtures.h"

namespace facenav::interop {
namespace {

using ::testing::HasSubstr;
using namespace interop::testing;

struct MadeFile {
  const char *name, *format;
  double digits_mm, digits_deg;
};

TEST(MadeFiles, GiveTheTruthBack) {
  const MadeFile kFiles[] = {{"brainsight_v12_targets.txt", "brainsight", 1e-4, 6e-3},
                             {"brainsight_v14_samples.txt", "brainsight", 1e-4, 6e-3},
                             {"InstrumentMarker_ras.xml", "localite", 1e-9, 1e-6},
                             {"InstrumentMarker_lps.xml", "localite", 1e-9, 1e-6},
                             {"GUMMarkers.xml", "localite", 1e-9, 1e-6},
                             {"softaxic.stmpx", "softaxic", 6e-4, 6e-5},
                             {"ant_visor2.mrk", "visor2", 1e-9, 1e-6},
                             {"simnibs_positions.csv", "simnibs-csv", 1e-6, 6e-5},
                             {"navinibs_targets.json", "navinibs", 1e-9, 1e-6},
                             {"slicer_targets.mrk.json", "mrk.json", 1e-9, 1e-6},
                             {"invesalius_v5.mkss", "mkss", 3e-5, 2e-5},
                             {"truth_poses.csv", "csv", 1e-9, 1e-6}};
  const auto head = madeHead();
  for (const auto& [name, format, digits_mm, digits_deg] : kFiles) {
    const auto file = readChecked(made(name), head);
    EXPECT_EQ(file.format, format) << name;
    const auto difference = apart(file, truth());
    EXPECT_EQ(difference.compared, 4) << name;
    EXPECT_LE(difference.mm, digits_mm) << name;
    EXPECT_LE(difference.deg, digits_deg) << name;
    for (const auto& item : file.items) EXPECT_EQ(item.refusal, "") << name << " " << item.name;
  }
}

TEST(MadeFiles, ATransformHasTheFilesNameAndTheFirstPose) {
  const auto file = readChecked(made("slicer_first_pose.tfm"), madeHead());
  ASSERT_EQ(file.items.size(), 1u);
  EXPECT_EQ(file.items[0].name, "slicer_first_pose");
  const auto error = poseError(*file.items[0].mri_T_coil, truth().at("M1 hand L"));
  EXPECT_LT(error.translation_mm, 1e-9);
  EXPECT_LT(error.rotation_rad, 1e-9);
}

TEST(MadeFiles, BrainsightsSamplesHaveTimeStrengthAndTarget) {
  const auto file = readChecked(made("brainsight_v14_samples.txt"), madeHead());
  const auto& sample = itemNamed(file, "Sample 2");
  EXPECT_EQ(sample.kind, Kind::pulse);
  EXPECT_EQ(sample.target, "DLPFC L");
  EXPECT_EQ(sample.time, "2026-03-05 10:20:33.276");
  EXPECT_NEAR(*sample.clock_s, 1772706033.276, 1e-3);
  EXPECT_EQ(sample.intensity_pct, 55.0);
}

TEST(MadeFiles, LocalitesUntrackedPulseIsKeptWithoutAPose) {
  const auto file = readChecked(made("TriggerMarkers_Coil0_20260305102030125.xml"), madeHead());
  int posed_pulses = 0, lost = 0;
  for (const auto& item : file.items) (item.mri_T_coil ? posed_pulses : lost) += 1;
  EXPECT_EQ(posed_pulses, 11);
  EXPECT_EQ(lost, 1);
  const auto& first = file.items.front();
  EXPECT_EQ(first.time, "2026-03-05 10:20:30.176");
  EXPECT_EQ(first.didt_a_per_us, 61.0);
  EXPECT_EQ(first.intensity_pct, 44.0);
  EXPECT_FALSE(first.mep_uv) << "NaN in the file";
}

TEST(MadeFiles, InvesaliussFiducialsArePlaces) {
  const auto file = readChecked(made("invesalius_v5.mkss"), madeHead());
  const auto& nasion = itemNamed(file, "NAI");
  EXPECT_EQ(nasion.kind, Kind::landmark);
  EXPECT_NEAR((nasion.mri_place->mm - Eigen::Vector3d(1, 84, -14)).norm(), 0.0, 3e-5);
}

TEST(RealFiles, LocalitesMniListIsRefusedAndItsUnsetMarkerHasNoPose) {
  const auto folder = facenav::testing::sharedData() / "interop/localite";
  FACENAV_NEEDS(folder);
  const auto file = readChecked(folder / "InstrumentMarker20240902120301059.xml", madeHead());
  ASSERT_EQ(file.items.size(), 2u);
  EXPECT_FALSE(file.items[0].pose);
  EXPECT_EQ(file.items[0].refusal, "") << "an unset marker is no error";
  EXPECT_THAT(file.items[1].refusal, HasSubstr("MNI"));
  const auto pulses = readChecked(folder / "TriggerMarkers_Coil0_20240902121554692.xml", madeHead());
  EXPECT_EQ(pulses.items.size(), 9u);
}

TEST(RealFiles, BrainsightsExportOfVersion14IsRead) {
  const auto path = facenav::testing::sharedData() / "interop/brainsight/DEEP.txt";
  FACENAV_NEEDS(path);
  const auto file = readChecked(path, madeHead());
  ASSERT_EQ(file.items.size(), 1u);
  EXPECT_EQ(file.items[0].name, "Deep");
  ASSERT_TRUE(file.items[0].mri_T_coil) << file.items[0].refusal;
  EXPECT_NEAR(file.items[0].mri_T_coil->rotation()(2, 2), -0.9921, 1e-3);
}

}  // namespace
}  // namespace facenav::interop
