#include "facenav/plan/imported_field.h"

#include <gmock/gmock.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>

#include "facenav/core/whole_file.h"
#include "facenav/guidance/handle.h"
#include "facenav/plan/planned_field.h"
#include "facenav/surface/mesh_files.h"
#include "facenav/volume/nifti.h"
#include "support/ball_with_cortex.h"
#include "support/made_field_mesh.h"
#include "support/refusal.h"
#include "support/test_data.h"

namespace facenav::steps {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using testing::refusalOf;

/// A field with its maximum on the cortex under the vertex, V/m.
Eigen::Vector3d fieldAt(const Eigen::Vector3d& p_mm) {
  const double off_mm = (p_mm - Eigen::Vector3d(0, 0, 68)).norm();
  return 80 * std::exp(-off_mm / 40) * Eigen::Vector3d(0, -1, 0);
}

/// The ball case: skin at 90 mm, brain of 70 mm, one target on the vertex.
class ImportedFieldTest : public ::testing::Test {
 protected:
  ImportedFieldTest()
      : store_(casefile::CaseStore::create(folder_.path() / "case", testing::ballWithCortex(), {}, false)),
        top_(targetOverCortex(plannedHead(store_), "top", Point<Mri>(0, 0, 68))) {
    guidance::TreatmentPlan plan;
    plan.targets = {top_};
    store_.setTargets(plan);
  }
  std::filesystem::path mesh(const testing::FieldMeshLayout& layout,
                             const std::string& name = "sim.msh") const {
    const auto path = folder_.path() / name;
    std::ofstream(path, std::ios::binary) << testing::madeFieldMesh(layout, fieldAt);
    return path;
  }
  FieldImport orderOf(const std::filesystem::path& file) const {
    FieldImport order{file};
    order.target = "top";
    return order;
  }
  double strengthAt(const Eigen::Vector3d& p_mm) const {
    const auto head = importedHead(store_, top_);
    return head->at({}, coilPoseOf(top_), Eigen::Matrix3Xd(p_mm)).norm();
  }
  /// The field in the whole head on the case's grid, as SimNIBS's subject_volumes.
  volume::Volume image() const {
    volume::Volume made = store_.mri();
    for (int k = 0; k < made.grid.size[2]; ++k)
      for (int j = 0; j < made.grid.size[1]; ++j)
        for (int i = 0; i < made.grid.size[0]; ++i) {
          const auto p_mm = made.grid.toMri(Eigen::Vector3d(i, j, k)).mm;
          made.voxels[made.grid.index(i, j, k)] = p_mm.norm() < 90 ? float(fieldAt(p_mm).norm()) : 0.f;
        }
    return made;
  }
  void writePose(const std::string& name, const CoilPose& pose) const {
    std::ofstream file(folder_.path() / name);
    file << "View\"coil\"{\n";
    const Eigen::Vector3d at_mm = pose.translation_mm();
    for (int c = 0; c < 3; ++c) {
      const Eigen::Vector3d axis = pose.rotation().col(c);
      file << "VP(" << at_mm.x() << ", " << at_mm.y() << ", " << at_mm.z() << "){" << axis.x() << ", "
           << axis.y() << ", " << axis.z() << "};\n";
    }
    file << "};\n";
  }

  /// Balls at the coil's centre and along its y and z axes, as SimNIBS draws a coil of a sampled field.
  static std::string ballsOf(const CoilPose& pose) {
    std::ostringstream text;
    text << "View\"coil_directions\"{\n";
    const auto put = [&](const Eigen::Vector3d& at_coil_mm) {
      const Eigen::Vector3d p = (pose * Point<frames::Coil>(at_coil_mm)).mm;
      text << "SP(" << p.x() << ", " << p.y() << ", " << p.z() << "){0};\n";
    };
    put({0, 0, 0});
    for (int i = 1; i < 10; ++i) put({0, double(i), 0});
    for (int i = 1; i < 30; ++i) put({0, 0, double(i)});
    text << "};\n";
    return text.str();
  }

  testing::TemporaryFolder folder_;
  casefile::CaseStore store_;
  guidance::Target top_;
};

TEST_F(ImportedFieldTest, EveryLayoutOfSimnibsGivesTheSameField) {
  testing::FieldMeshLayout layout;
  for (const bool is_binary : {true, false})
    for (const bool ends_lines : {true, false}) {
      layout.is_binary = is_binary, layout.ends_lines = ends_lines;
      layout.first_id = is_binary == ends_lines ? 500 : 1;
      const auto field = previewField(store_, orderOf(mesh(layout)));
      EXPECT_NEAR(field.peak, fieldAt({0, 0, 70}).norm(), 1e-6);
      EXPECT_GT(field.percentile_99_9, 0.7 * field.peak);
      EXPECT_LT(field.percentile_99_9, field.peak);
      EXPECT_TRUE(field.has_directions);
      EXPECT_TRUE(field.fills_brain);
      EXPECT_THAT(field.words, HasSubstr("of its scalp within"));
    }
  EXPECT_FALSE(std::filesystem::exists(store_.folder() / "imported_fields.json"))
      << "a preview writes nothing";
}

TEST_F(ImportedFieldTest, ItIsKeptAndGivenForItsPoseAlone) {
  auto order = orderOf(mesh({}));
  order.rate_A_per_us = 2;
  const auto field = importField(store_, order);
  ASSERT_TRUE(importedField(store_, top_));
  EXPECT_NEAR(strengthAt({0, 0, 65}), fieldAt({0, 0, 65}).norm() / 2, 1e-6) << "at 1 A/us";
  EXPECT_EQ(strengthAt({0, 0, 85}), 0) << "no value of the brain is near";
  const auto head = importedHead(store_, top_);
  EXPECT_EQ(head->tier(), FieldTier::imported);
  const auto above = guidance::withHairGap(top_, 5);
  EXPECT_THAT(
      refusalOf([&] { head->at({}, coilPoseOf(above), Eigen::Matrix3Xd(Eigen::Vector3d(0, 0, 65))); }),
      HasSubstr("pose of 'top' alone"));
  EXPECT_FALSE(importedField(store_, above));
  EXPECT_THAT(refusalOf([&] { importedHead(store_, above); }), HasSubstr("no field was imported"));
  importField(store_, orderOf(mesh({})));  // again: replaces the old one
  EXPECT_EQ(importedFields(store_).size(), 1u);
  EXPECT_FALSE(std::filesystem::exists(store_.folder() / field.file));
  EXPECT_NEAR(strengthAt({0, 0, 65}), fieldAt({0, 0, 65}).norm(), 1e-6);
  EXPECT_THAT(importedFields(store_)[0].notes, Contains(HasSubstr("taken as 1 A/us")));
}

TEST_F(ImportedFieldTest, AnotherHeadOrPlaceIsRefused) {
  testing::FieldMeshLayout layout;
  layout.shift_mm = {0, 6, 0};
  EXPECT_THAT(refusalOf([&] { importField(store_, orderOf(mesh(layout))); }), HasSubstr("not the case's"));
  layout.shift_mm = {0, 2, 0};
  EXPECT_EQ(refusalOf([&] { importField(store_, orderOf(mesh(layout))); }), "");
  layout.shift_mm = {0, 0, 0}, layout.scalp_mm = 84;
  EXPECT_THAT(refusalOf([&] { importField(store_, orderOf(mesh(layout))); }), HasSubstr("mm off the skin"));
  layout.scalp_mm = 90, layout.brain_mm = 40;
  EXPECT_THAT(refusalOf([&] { importField(store_, orderOf(mesh(layout))); }),
              HasSubstr("no value at the target"));
  auto nobody = orderOf(mesh({}));
  nobody.target = "another";
  EXPECT_THAT(refusalOf([&] { importField(store_, nobody); }), HasSubstr("another"));
  EXPECT_EQ(importedFields(store_).size(), 1u) << "what is refused changes nothing";
}

TEST_F(ImportedFieldTest, AVolumeCountsInTheBrainAndItsGridIsThatOfTheT1) {
  const auto path = folder_.path() / "sim_magnE.nii.gz";
  auto made = image();
  volume::writeNifti(made, path);
  const auto field = importField(store_, orderOf(path));
  EXPECT_THAT(field.words, HasSubstr("grid is that of the case's T1"));
  EXPECT_FALSE(field.has_directions);
  EXPECT_LT((field.peak_place.mm - Eigen::Vector3d(0, 0, 68)).norm(), 6) << "not in the scalp above";
  EXPECT_NEAR(strengthAt({2, 2, 62}), fieldAt({2, 2, 62}).norm(), 0.01);
  TaskMonitor monitor;
  WantedField wanted{top_, "figure8-70", {10}};
  wanted.imported = field;
  const ReadHead head(store_);
  const auto planned = plannedField(head, wanted, monitor);
  EXPECT_EQ(planned.tier, FieldTier::imported);
  EXPECT_NEAR(planned.at_target, 10 * fieldAt(top_.cortex_point.mm).norm(), 0.15 * planned.at_target)
      << "voxels of 4 mm";
  EXPECT_TRUE(std::isnan(planned.along_normal)) << "a magnitude has no direction";
  EXPECT_TRUE(plannedReach(head, wanted, {}, monitor).regions);
  made.grid.mri_from_voxel.translation() += Eigen::Vector3d(8, 0, 0);
  volume::writeNifti(made, path);
  EXPECT_THAT(refusalOf([&] { importField(store_, orderOf(path)); }), HasSubstr("not the case's"));
}

TEST_F(ImportedFieldTest, AVolumeOfTheBrainAloneNeedsThePlaceOfTheT1) {
  const auto path = folder_.path() / "sim_magnE.nii.gz";
  volume::Volume coarse;
  coarse.grid.size = {25, 25, 25};
  coarse.grid.mri_from_voxel.linear() *= 8.0;
  coarse.grid.mri_from_voxel.translation() = Eigen::Vector3d::Constant(-96.0);
  for (int k = 0; k < 25; ++k)
    for (int j = 0; j < 25; ++j)
      for (int i = 0; i < 25; ++i) {
        const auto p_mm = coarse.grid.toMri(Eigen::Vector3d(i, j, k)).mm;
        coarse.voxels.push_back(p_mm.norm() < 66 ? float(fieldAt(p_mm).norm()) : 0.f);
      }
  volume::writeNifti(coarse, path);
  EXPECT_THAT(previewField(store_, orderOf(path)).words, HasSubstr("voxels of another size"));
  coarse.grid.mri_from_voxel.translation().x() += 10;
  volume::writeNifti(coarse, path);
  EXPECT_THAT(refusalOf([&] { previewField(store_, orderOf(path)); }), HasSubstr("T1 is not the case's"));
}

TEST_F(ImportedFieldTest, ValuesOnASurfaceNeedTheirSurface) {
  const auto values = folder_.path() / "lh.sim.central.E.magn", surface = folder_.path() / "lh.central.gii";
  const auto cortex = testing::ballMesh(68, 90, 120);
  surface::writeMesh(cortex, surface::MeshFormat::gifti, surface);
  const auto bigEndian = [](std::uint32_t bits) {
    return std::string{char(bits >> 24), char(bits >> 16), char(bits >> 8), char(bits)};
  };
  std::string content =
      "\xff\xff\xff" + bigEndian(std::uint32_t(cortex.vertices_mm.size())) + bigEndian(9) + bigEndian(1);
  for (const auto& p : cortex.vertices_mm) {
    const float value = float(fieldAt(p).norm());
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    content += bigEndian(bits);
  }
  std::ofstream(values, std::ios::binary) << content;
  EXPECT_TRUE(isFieldFile(values));
  EXPECT_THAT(refusalOf([&] { importField(store_, orderOf(values)); }), HasSubstr("--surface"));
  auto order = orderOf(values);
  order.surface = surface;
  const auto field = importField(store_, order);
  EXPECT_FALSE(field.fills_brain);
  EXPECT_NEAR(field.peak, 80, 0.5);
  EXPECT_THAT(field.words, HasSubstr("no scalp to check"));
  EXPECT_NEAR(strengthAt({0, 0, 66}), 80, 0.5);
  surface::writeMesh(testing::ballMesh(68), surface::MeshFormat::gifti, surface);
  EXPECT_THAT(refusalOf([&] { importField(store_, order); }), HasSubstr("the surface has 1200 vertices"));
}

TEST_F(ImportedFieldTest, ThePoseBesideTheFileIsCompared) {
  const auto path = mesh({}, "sim_TMS_1-0001_coil_scalar.msh");
  const std::string beside = "sim_TMS_1-0001_coil_coil_pos.geo";
  const auto notes = [&] { return previewField(store_, orderOf(path)).notes; };
  EXPECT_THAT(notes(), Contains(HasSubstr("no file beside it tells the coil's pose")));
  writePose(beside, coilPoseOf(top_));
  EXPECT_THAT(notes(), Contains(HasSubstr("stood 0.0 mm and 0.0 degrees off the target's pose")));
  using Step = RigidTransform<frames::Coil, frames::Coil>;
  writePose(beside, coilPoseOf(top_) * Step(Eigen::Quaterniond::Identity(), {0, 0, -4}));
  EXPECT_THAT(notes(), Contains(HasSubstr("stood 4.0 mm and 0.0 degrees")));
  std::ofstream(folder_.path() / beside) << ballsOf(coilPoseOf(top_));
  EXPECT_THAT(notes(), Contains(HasSubstr("stood 0.0 mm and 0.0 degrees"))) << "balls along y and z";
  std::ofstream(folder_.path() / beside)
      << "View\"dipoles\"{\nVP(1, 2, 3){0, 0, 1};\nVP(2, 2, 3){0, 0, 1};\n};\n";
  EXPECT_THAT(notes(), Contains(HasSubstr("no file beside it tells"))) << "dipoles tell no pose";
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()));
  writePose(beside, coilPoseOf(top_) * Step(turn, {0, 0, 0}));
  EXPECT_THAT(refusalOf([&] { notes(); }), HasSubstr("another pose"));
}

TEST_F(ImportedFieldTest, OtherFilesAreNoFields) {
  const auto text = folder_.path() / "notes.txt";
  std::ofstream(text) << "M1 hand L 1 2 3\n";
  EXPECT_FALSE(isFieldFile(text));
  EXPECT_TRUE(isFieldFile(mesh({})));
  const auto damaged = folder_.path() / "d.msh";
  const std::string whole = testing::madeFieldMesh({}, fieldAt);
  std::ofstream(damaged, std::ios::binary) << whole.substr(0, whole.size() / 2);
  EXPECT_THAT(refusalOf([&] { importField(store_, orderOf(damaged)); }), HasSubstr("d.msh"));
}

}  // namespace
}  // namespace facenav::steps
