#include "facenav/efield/coil_file.h"

#include <gmock/gmock.h>
#include <zlib.h>

#include <cmath>
#include <cstring>
#include <fstream>

#include "facenav/efield/built_in_coils.h"
#include "facenav/efield/primary_field.h"
#include "facenav/efield/thinned_coil.h"
#include "support/refusal.h"
#include "support/test_data.h"
#include "unit/target/efield/made_coil_files.h"

namespace facenav::efield {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::refusalOf;

class CoilFileTest : public CoilFiles {};

std::string listOf(const Eigen::Matrix3Xd& values) {
  std::string text = "[";
  for (Eigen::Index i = 0; i < values.cols(); ++i)
    text += (i ? ",[" : "[") + ccdNumber(values(0, i)) + "," + ccdNumber(values(1, i)) + "," +
            ccdNumber(values(2, i)) + "]";
  return text + "]";
}

std::string base64(const std::string& bytes) {
  const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned bits = 0;
    for (std::size_t b = 0; b < 3; ++b)
      bits = bits << 8 | (i + b < bytes.size() ? static_cast<unsigned char>(bytes[i + b]) : 0u);
    for (std::size_t d = 0; d < 4; ++d)
      text += i + d > bytes.size() ? '=' : digits[bits >> (18 - 6 * d) & 63];
  }
  return text;
}

std::string packed(const Eigen::Matrix3Xd& values, bool is_compressed) {
  std::string bytes(reinterpret_cast<const char*>(values.data()),
                    std::size_t(values.size()) * sizeof(double));
  if (!is_compressed) return "\"" + base64(bytes) + "\"";
  std::vector<unsigned char> small(compressBound(uLong(bytes.size())));
  uLongf size = uLongf(small.size());
  EXPECT_EQ(compress(small.data(), &size, reinterpret_cast<const Bytef*>(bytes.data()), uLong(bytes.size())),
            Z_OK);
  return "\"" + base64(std::string(small.begin(), small.begin() + long(size))) + "\"";
}

std::string tcdOf(const std::string& elements, const std::string& more = "") {
  return R"({"name": "made", "stimulatorList": [{"name": "s", "maxdIdt": 66e6}], "coilElementList": [)" +
         elements + "]" + more + "}";
}

/// Two wings of wire, several turns each, as pieces of 4 degrees.
LineElements wires() {
  LineElements lines;
  lines.positions_mm.resize(3, 2 * 4 * 90);
  lines.lengths_mm.resize(3, lines.positions_mm.cols());
  Eigen::Index at = 0;
  for (const int wing : {-1, 1})
    for (int turn = 0; turn < 4; ++turn)
      for (int i = 0; i < 90; ++i, ++at) {
        const double angle = 2 * M_PI * i / 90, radius_mm = 28 + 4 * turn;
        lines.positions_mm.col(at) << 44 * wing + radius_mm * std::cos(angle), radius_mm * std::sin(angle),
            -6;
        lines.lengths_mm.col(at) << -std::sin(angle), std::cos(angle), 0;
        lines.lengths_mm.col(at) *= -wing * radius_mm * 2 * M_PI / 90;
      }
  return lines;
}

TEST_F(CoilFileTest, CcdGivesItsDipoles) {
  const auto made = figureEight70();
  const auto source = readCoilSource(write("d70.ccd", ccdOf(made)));
  ASSERT_EQ(source.dipoles.positions_mm.cols(), 42);
  EXPECT_LT((source.dipoles.positions_mm - made.positions_mm).norm() / made.positions_mm.norm(), 1e-6);
  EXPECT_LT((source.dipoles.moments_Am2 - made.moments_Am2).norm() / made.moments_Am2.norm(), 1e-6);
  EXPECT_EQ(source.dipoles.largest_didt_A_per_us, 114.73);
  EXPECT_EQ(source.dipoles.name, "D70");
  const Eigen::Matrix3Xd point = Eigen::Vector3d(5, 3, 25);
  const RigidTransform<Mri, frames::Coil> pose;
  const Eigen::Matrix3Xd read = primaryField(source.dipoles, pose, point),
                         wanted = primaryField(made, pose, point);
  EXPECT_LT((read - wanted).norm() / wanted.norm(), 1e-6);
  EXPECT_LT(read(1, 0), 0) << "the current's sign is the file's";
}

TEST_F(CoilFileTest, CcdOfTheOlderLayoutIsRead) {
  const auto source = readCoilSource(write("old.ccd",
                                           "# number of elements\n2\r\n# centers and weighted directions\r\n"
                                           "0.04\t0 -0.01 0 0 -0.03\r\n-0.04 0 -0.01 0 0 0.03\r\n\r\n"));
  ASSERT_EQ(source.dipoles.positions_mm.cols(), 2);
  EXPECT_NEAR(source.dipoles.positions_mm(0, 0), 40, 1e-9);
  EXPECT_EQ(source.dipoles.largest_didt_A_per_us, 0) << "not known";
  EXPECT_EQ(source.dipoles.name, "old.ccd");
}

TEST_F(CoilFileTest, BadCcdIsRefusedInOneLine) {
  const auto good = ccdOf(figureEight70());
  EXPECT_THAT(refusal("a.ccd", good.substr(0, good.size() / 2)), HasSubstr("a.ccd"));
  EXPECT_THAT(refusal("short.ccd", good.substr(0, good.rfind('\n', good.size() - 2) + 1)),
              AllOf(HasSubstr("announces 42 dipoles and holds 41"), HasSubstr("copy it again")));
  EXPECT_THAT(refusal("nan.ccd", "# c\n1\n# d\n0 0 nan 0 0 1\n"),
              AllOf(HasSubstr("'nan' is no number"), HasSubstr("line 4")));
  EXPECT_THAT(refusal("inf.ccd", "# c\n1\n# d\n0 0 0 0 0 inf\n"), HasSubstr("'inf' is no number"));
  EXPECT_THAT(refusal("five.ccd", "# c\n1\n# d\n0 0 0 0 1\n"), HasSubstr("needs 6 numbers"));
  EXPECT_THAT(refusal("empty.ccd", ""), HasSubstr("holds no dipole"));
  EXPECT_THAT(refusal("zero.ccd", "# c\n2\n# d\n0 0 0 0 0 0\n.05 0 0 0 0 0\n"), HasSubstr("no current"));
  EXPECT_THAT(refusalOf([&] { readCoilSource(folder_.path() / "none.ccd"); }), HasSubstr("no such coil"));
  EXPECT_THAT(refusal("coil.stl", "solid"), HasSubstr("is no coil's field by its name"));
}

TEST_F(CoilFileTest, MetresAndMillimetresExchangedAreRefused) {
  EXPECT_THAT(refusal("mm.ccd", ccdOf(figureEight70(), 1000)),
              AllOf(HasSubstr("a thousand times too large"), HasSubstr("in metres")));
  EXPECT_THAT(refusal("km.ccd", ccdOf(figureEight70(), 0.001)), HasSubstr("a thousand times too small"));
  auto strong = figureEight70();
  strong.moments_Am2 *= 1e6;  // A mm^2
  EXPECT_THAT(refusal("strong.ccd", ccdOf(strong)), HasSubstr("no coil's"));
  const auto coil = figureEight70();
  const Eigen::Matrix3Xd metres = coil.positions_mm / 1000;
  EXPECT_THAT(refusal("m.tcd", tcdOf(R"({"type": 1, "points": )" + listOf(metres) + R"(, "values": )" +
                                     listOf(coil.moments_Am2) + "}")),
              AllOf(HasSubstr("too small"), HasSubstr("in mm")));
  auto grid = sampled(coil, 5);
  grid.coil_from_voxel.matrix().topRows<3>() /= 1000;
  EXPECT_NE(refusal("m.nii", niftiOf(grid)), "");
  grid = sampled(coil, 5);
  grid.potential_Tm *= 1e6;
  EXPECT_THAT(refusal("strong.nii", niftiOf(grid)), HasSubstr("T m per ampere"));
}

TEST_F(CoilFileTest, TcdGivesDipolesAsListsAndPacked) {
  const auto made = figureEight70();
  const std::string as_list = R"({"type": 1, "stimulator": 0, "points": )" + listOf(made.positions_mm) +
                              R"(, "values": )" + listOf(made.moments_Am2) + "}";
  std::vector<std::string> all{as_list};
  for (const bool is_compressed : {true, false})
    all.push_back(R"({"type": 1, "points": )" + packed(made.positions_mm, is_compressed) + R"(, "values": )" +
                  packed(made.moments_Am2, is_compressed) + "}");
  for (const auto& element : all) {
    const auto source = readCoilSource(write("c.tcd", tcdOf(element)));
    ASSERT_EQ(source.dipoles.positions_mm.cols(), 42);
    EXPECT_LT((source.dipoles.positions_mm - made.positions_mm).norm() / made.positions_mm.norm(), 1e-6);
    EXPECT_LT((source.dipoles.moments_Am2 - made.moments_Am2).norm() / made.moments_Am2.norm(), 1e-6);
    EXPECT_NEAR(source.dipoles.largest_didt_A_per_us, 66, 1e-9);
    EXPECT_EQ(source.dipoles.name, "made");
  }
}

TEST_F(CoilFileTest, TcdMovesItsPartsAsTheyStandAtFirst) {
  const auto made = figureEight70();
  const std::string element = R"({"type": 1, "deformations": [0, 1], "points": )" +
                              listOf(made.positions_mm) + R"(, "values": )" + listOf(made.moments_Am2) + "}";
  const std::string moves =
      R"(, "deformList": [{"type": "z", "initial": -5, "range": [-9, 9]},
         {"type": "rot2p", "initial": 90, "range": [-90, 90], "point1": [0, 0, -5], "point2": [0, 0, 5]}])";
  const auto source = readCoilSource(write("c.tcd", tcdOf(element, moves)));
  const Eigen::Vector3d first = source.dipoles.positions_mm.col(0);
  EXPECT_NEAR((first - Eigen::Vector3d(0, 44, -11.5)).norm(), 0, 1e-9) << first.transpose();
  EXPECT_THAT(source.notes, ::testing::Contains(HasSubstr("movable parts")));
}

TEST_F(CoilFileTest, TcdOfWiresHasTheirField) {
  const auto made = wires();
  const auto path = write("w.tcd", tcdOf(R"({"type": 2, "points": )" + listOf(made.positions_mm) +
                                         R"(, "values": )" + listOf(made.lengths_mm) + "}"));
  const auto source = readCoilSource(path);
  ASSERT_EQ(source.lines.positions_mm.cols(), made.positions_mm.cols());
  EXPECT_LT((source.lines.positions_mm - made.positions_mm).norm() / made.positions_mm.norm(), 1e-6);
  EXPECT_LT((source.lines.lengths_mm - made.lengths_mm).norm() / made.lengths_mm.norm(), 1e-6);
  Eigen::Matrix3Xd points(3, 3);
  points << 0, 20, 44, 0, 10, -30, 12, 14, 20;
  const Eigen::VectorXd flux = fluxOf(dipolesOf(source), points), wanted = fluxOf(made, points);
  EXPECT_LT((flux - wanted).norm() / wanted.norm(), 2e-3) << "Biot and Savart";
  const auto coil = fieldCoil(path.string());
  EXPECT_LE(coil.dipoles.positions_mm.cols(), 100);
  EXPECT_LE(coil.thinning_error, 0.005);
  const Eigen::Matrix3Xd below = Eigen::Vector3d(0, 0, 25);
  const RigidTransform<Mri, frames::Coil> pose;
  EXPECT_LT(sphereField(coil.dipoles, pose, Eigen::Vector3d(0, 0, 92), below)(1, 0), -0.1);
}

TEST_F(CoilFileTest, ASampledFieldAgreesWithTheDipolesItCameFrom) {
  const auto made = figureEight70();
  for (const double spacing_mm : {2.0, 4.0}) {
    const auto grid = sampled(made, spacing_mm);
    const auto path = write("d70.nii", niftiOf(grid));
    const auto source = readCoilSource(path);
    ASSERT_EQ(source.grids.size(), 1u);
    EXPECT_LT((source.grids[0].potential_Tm - grid.potential_Tm).norm() / grid.potential_Tm.norm(), 1e-6);
    EXPECT_EQ(source.dipoles.largest_didt_A_per_us, 114.73);
    const auto coil = fieldCoil(path.string());
    EXPECT_LE(coil.dipoles.positions_mm.cols(), 100);
    EXPECT_LT(relativeErrorInSphere(coil.dipoles, made), 0.01) << "grid of " << spacing_mm << " mm";
  }
}

TEST_F(CoilFileTest, TcdOfASampledFieldIsRead) {
  const auto made = figureEight70();
  const auto grid = sampled(made, 5);
  std::string data = "[";
  for (int i = 0; i < grid.size[0]; ++i) {
    data += i ? ",[" : "[";
    for (int j = 0; j < grid.size[1]; ++j) {
      Eigen::Matrix3Xd column(3, grid.size[2]);
      for (int k = 0; k < grid.size[2]; ++k) column.col(k) = grid.potential_Tm.col(grid.index(i, j, k));
      data += (j ? "," : "") + listOf(column);
    }
    data += "]";
  }
  const std::string affine = R"(, "affine": [[5,0,0,-140],[0,5,0,-100],[0,0,5,-10],[0,0,0,1]]})";
  const auto source = readCoilSource(write("g.tcd", tcdOf(R"({"type": 3, "data": )" + data + "]" + affine)));
  ASSERT_EQ(source.grids.size(), 1u);
  EXPECT_LT((source.grids[0].potential_Tm - grid.potential_Tm).norm() / grid.potential_Tm.norm(), 1e-6);
  EXPECT_LT(relativeErrorInSphere(dipolesOf(source), made), 0.01);
}

TEST_F(CoilFileTest, BadTcdIsRefusedInOneLine) {
  EXPECT_THAT(refusal("a.tcd", "{"), HasSubstr("is not valid JSON"));
  EXPECT_THAT(refusal("b.tcd", "{}"), HasSubstr("coilElementList"));
  EXPECT_THAT(refusal("c.tcd", tcdOf("")), HasSubstr("no part that carries current"));
  EXPECT_THAT(refusal("d.tcd", tcdOf(R"({"type": 9})")), HasSubstr("a type of 1, 2 or 3"));
  EXPECT_THAT(refusal("e.tcd", tcdOf(R"({"type": 1, "points": "A*", "values": []})")),
              HasSubstr("no base64"));
  EXPECT_THAT(refusal("f.tcd", tcdOf(R"({"type": 1, "points": [[0,0,1]], "values": []})")),
              HasSubstr("not as many values as points"));
  EXPECT_THAT(refusal("g.tcd", tcdOf(R"({"type": 1, "points": [[0,0,NaN]], "values": [[0,0,1]]})")),
              HasSubstr("is not valid JSON"));
  Eigen::Matrix3Xd none = Eigen::Vector3d(0, std::nan(""), 1);
  EXPECT_THAT(
      refusal("h.tcd", tcdOf(R"({"type": 1, "points": )" + packed(none, true) + R"(, "values": [[0,0,1]]})")),
      HasSubstr("no number"));
  EXPECT_THAT(refusal("i.tcd", tcdOf(R"({"type": 3, "data": "eJw=", "affine": []})")),
              HasSubstr("only Python reads"));
}

TEST_F(CoilFileTest, BadNiftiIsRefusedInOneLine) {
  auto grid = sampled(figureEight70(), 5);
  EXPECT_THAT(refusal("a.nii", niftiOf(grid).substr(0, 5000)), HasSubstr("truncated"));
  grid.potential_Tm(1, 77) = std::nan("");
  EXPECT_THAT(refusal("b.nii", niftiOf(grid)), HasSubstr("no number"));
  auto behind = sampled(figureEight70(), 5);
  behind.coil_from_voxel.translation().z() = -300;
  const auto path = write("c.nii", niftiOf(behind));
  EXPECT_THAT(refusalOf([&] { fieldCoil(path.string()); }),
              AllOf(HasSubstr("c.nii"), HasSubstr("below the contact face")));
  auto turned = sampled(figureEight70(), 5);  // the coil lies below: z points out of the head
  turned.coil_from_voxel.linear().col(2) *= -1;
  turned.coil_from_voxel.translation().z() = 30;
  const auto upside_down = write("d.nii", niftiOf(turned));
  EXPECT_THAT(refusalOf([&] { fieldCoil(upside_down.string()); }),
              AllOf(HasSubstr("d.nii"), HasSubstr("z points into the head")));
}

TEST_F(CoilFileTest, BuiltInCoilsHaveNames) {
  EXPECT_EQ(fieldCoil("figure8-70").dipoles.positions_mm, figureEight70().positions_mm);
  EXPECT_EQ(fieldCoil("round").dipoles_in_file, int(roundCoil().positions_mm.cols()));
  EXPECT_THAT(refusalOf([] { fieldCoil("figure9"); }), HasSubstr("give figure8-70, round, or a .ccd"));
}

}  // namespace
}  // namespace facenav::efield
