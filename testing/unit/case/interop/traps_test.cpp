// Traps of single formats, from resources/doc/interop.md.

#include <gmock/gmock.h>

#include "interop_fixtures.h"
#include "support/refusal.h"

namespace facenav::interop {
namespace {

using facenav::testing::refusalOf;
using ::testing::HasSubstr;
using namespace interop::testing;

std::string changed(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

std::string brainsight() { return readWholeFile(made("brainsight_v12_targets.txt")); }

TEST(Brainsight, SystemsOfATemplateAreRefusedAndWorldIsAsked) {
  for (const char* system : {"NIfTI:MNI-152", "NIfTI:Talairach", "NIfTI:Other-Template"}) {
    const auto file = readCheckedText(changed(brainsight(), "NIfTI:Aligned", system), madeHead());
    for (const auto& item : file.items) EXPECT_THAT(item.refusal, HasSubstr("a template's")) << system;
  }
  const auto world = readCheckedText(changed(brainsight(), "NIfTI:Aligned", "World"), madeHead());
  EXPECT_THAT(world.items[0].refusal, HasSubstr("--space"));
}

TEST(Brainsight, TakesWindowsLinesAByteOrderMarkAndAnOpenEnd) {
  std::string text = "\xEF\xBB\xBF" + changed(brainsight(), "\n", "\r\n");
  text.resize(text.find_last_not_of("\r\n") + 1);
  const auto file = readCheckedText(text, madeHead());
  EXPECT_EQ(apart(file, truth()).compared, 4);
  EXPECT_LT(apart(file, truth()).mm, 1e-4);
}

TEST(Brainsight, FindsColumnsByNameInVersion7And8) {
  std::string text = changed(brainsight(), "# Version: 12", "# Version: 7");
  text = changed(text, "# Units:", "# units:");
  text = changed(text, "# Target Name\tLoc. X\tLoc. Y\tLoc. Z", "# Target Name\tLoc. Y\tLoc. X\tLoc. Z");
  const auto file = readCheckedText(text, madeHead());
  EXPECT_NEAR(file.items[0].mri_T_coil->translation_mm().x(), -21.0994, 1e-4) << "X and Y change places";
}

TEST(Brainsight, APoseOfNullIsNone) {
  std::string text = brainsight();
  const auto row = text.find("Vertex\t");
  const auto end = text.find('\n', row);
  std::string nulls = "Vertex";
  for (int i = 0; i < 12; ++i) nulls += "\t(null)";
  text.replace(row, end - row, nulls);
  const auto file = readCheckedText(text, madeHead());
  EXPECT_FALSE(itemNamed(file, "Vertex").pose);
  EXPECT_EQ(itemNamed(file, "Vertex").refusal, "");
}

TEST(Brainsight, AFileWithAllAxesNegatedIsRefusedByItsHandedness) {
  std::string text = brainsight();
  const auto row = text.find("Vertex\t");
  const auto end = text.find('\n', row);
  text.replace(row, end - row,
               "Vertex\t1.5\t-16.7\t113.9\t-1\t0\t0\t0\t-0.9991\t-0.0421\t0\t0.0421\t-0.9991");
  const auto file = readCheckedText(text, madeHead());
  EXPECT_THAT(itemNamed(file, "Vertex").refusal, HasSubstr("left-handed"));
  EXPECT_EQ(itemNamed(file, "SMA").refusal, "");
}

/// X, Y, Z of Brainsight's own system from the made T1: i = nx - 1 - X / sx, j = ny - 1 - Y / sy, k = Z / sz.
TEST(Brainsight, ItsOwnSystemIsConvertedByTheT1) {
  const auto head = madeHead();
  const auto grid = canonical(head.t1.grid);
  const Eigen::Vector3d ijk(20, 30, 25), spacing = grid.spacing_mm();
  const Eigen::Vector3d theirs((grid.size[0] - 1 - ijk.x()) * spacing.x(),
                               (grid.size[1] - 1 - ijk.y()) * spacing.y(), ijk.z() * spacing.z());
  std::string text =
      "# Version: 12\n# Coordinate system: Brainsight\n# Target Name\tLoc. X\tLoc. Y\tLoc. Z\tm0n0\tm0n1"
      "\tm0n2\tm1n0\tm1n1\tm1n2\tm2n0\tm2n1\tm2n2\nT";
  for (int i = 0; i < 3; ++i) text += "\t" + std::to_string(theirs[i]);
  text += "\t1\t0\t0\t0\t1\t0\t0\t0\t1\n";
  const auto file = readCheckedText(text, head);
  ASSERT_TRUE(file.items[0].mri_T_coil) << file.items[0].refusal;
  const Eigen::Vector3d expected = grid.mri_from_voxel * ijk;
  EXPECT_NEAR((file.items[0].mri_T_coil->translation_mm() - expected).norm(), 0.0, 1e-4);
  EXPECT_THAT(file.notes, ::testing::Contains(HasSubstr("compare one target")));
}

TEST(Localite, AListWithoutASpaceIsAsked) {
  const std::string text =
      changed(readWholeFile(made("InstrumentMarker_ras.xml")), " coordinateSpace=\"RAS\"", "");
  EXPECT_THAT(readCheckedText(text, madeHead()).items[0].refusal, HasSubstr("--space"));
}

TEST(Localite, TheRotationTellsAnUnsetMarkerNotItsPlace) {
  const std::string text =
      "<InstrumentMarkerList coordinateSpace=\"RAS\"><InstrumentMarker><Marker description=\"\" "
      "set=\"false\"><Matrix4D "
      "data00=\"1.0\" data01=\"0.0\" data02=\"0.0\" data03=\"-10.3\" data10=\"0.0\" data11=\"1.0\" "
      "data12=\"0.0\" "
      "data13=\"1.3\" data20=\"0.0\" data21=\"0.0\" data22=\"1.0\" data23=\"253.5\" data30=\"0.0\" "
      "data31=\"0.0\" "
      "data32=\"0.0\" data33=\"1.0\"/></Marker></InstrumentMarker></InstrumentMarkerList>";
  const auto file = readCheckedText(text, madeHead());
  EXPECT_FALSE(file.items[0].pose);
  EXPECT_EQ(file.items[0].name, "target 1");
}

TEST(Slicer, APointWithoutAnOrientationIsAPlace) {
  const std::string text =
      "{\"markups\": [{\"type\": \"Fiducial\", \"controlPoints\": [{\"label\": \"F\", \"position\": [10, 20, "
      "30], "
      "\"orientation\": [-1, 0, 0, 0, -1, 0, 0, 0, 1]}]}, {\"type\": \"Line\", \"coordinateSystem\": "
      "\"RAS\", "
      "\"controlPoints\": [{\"label\": \"R\", \"position\": [10, 20, 30]}, {\"label\": \"U\", "
      "\"positionStatus\": "
      "\"undefined\", \"position\": [0, 0, 0]}]}]}";
  const auto file = readCheckedText(text, madeHead());
  ASSERT_EQ(file.items.size(), 3u);
  EXPECT_EQ(file.items[0].kind, Kind::landmark);
  EXPECT_EQ(file.items[0].mri_place->mm.x(), -10) << "LPS where nothing is said";
  EXPECT_EQ(itemNamed(file, "R").mri_place->mm.x(), 10);
  EXPECT_FALSE(itemNamed(file, "U").place_mm);
}

TEST(Slicer, UnitsMayBeACodedEntryAndMustBeMillimetres) {
  const auto withUnits = [](const std::string& units) {
    return "{\"markups\": [{\"coordinateUnits\": " + units +
           ", \"controlPoints\": [{\"label\": \"F\", \"position\": [10, 20, 30]}]}]}";
  };
  for (const char* units : {"\"mm\"", "[\"mm\", \"UCUM\", \"millimeter\"]", "{\"codeValue\": \"mm\"}"})
    EXPECT_EQ(readCheckedText(withUnits(units), madeHead()).items.size(), 1u) << units;
  EXPECT_THAT(refusalOf([&] { readCheckedText(withUnits("\"m\""), madeHead()); }),
              HasSubstr("mm was expected"));
}

TEST(Slicer, AnOlderListNamesItsSpace) {
  const std::string start = "# Markups fiducial file version = 4.11\n# CoordinateSystem = ";
  const std::string row =
      "\n# columns = "
      "id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n1,10,20,30,0,0,0,1,1,1,0,F-1,,\n";
  EXPECT_EQ(readCheckedText(start + "LPS" + row, madeHead()).items[0].mri_place->mm.y(), -20);
  EXPECT_EQ(readCheckedText(start + "0" + row, madeHead()).items[0].mri_place->mm.y(), 20);
  EXPECT_THAT(readCheckedText(start + "?" + row, madeHead()).items[0].refusal, HasSubstr("--space"));
}

TEST(Visor2, AFileOfAnotherT1IsNamedInMillimetres) {
  auto head = madeHead();
  head.t1.qform->translation() += Eigen::Vector3d(0, 0, 5);
  const auto file = readChecked(made("ant_visor2.mrk"), head);
  EXPECT_THAT(file.items[0].refusal, HasSubstr("corners lie up to 5.0 mm"));
}

/// The frame of three points 0.1 m ahead of the case's.
TEST(Stimguide, PlacesAreRegisteredByNasionAndEars) {
  const std::string text =
      R"({"Targets": [{"Name": "DLPFC", "Position": {"X": -0.05, "Y": 0.14, "Z": 0.07}, "Rotation": )"
      R"({"X": 0, "Y": 0, "Z": 0, "W": 1}}], "Stimuli": [], "Landmarks": [{"Time": "", "LeftEar": )"
      R"({"X": -0.07, "Y": 0.1, "Z": 0}, "Nasion": {"X": 0, "Y": 0.2, "Z": 0}, "RightEar": )"
      R"({"X": 0.07, "Y": 0.1, "Z": 0}}]})";
  auto head = madeHead();
  EXPECT_THAT(readCheckedText(text, head).items[0].refusal, HasSubstr("has no landmarks"));
  head.points = HeadPoints{{-70, 0, 0}, {0, 100, 0}, {70, 0, 0}};
  const auto file = readCheckedText(text, head);
  EXPECT_EQ(file.items[0].kind, Kind::landmark);
  ASSERT_TRUE(file.items[0].mri_place) << file.items[0].refusal;
  EXPECT_NEAR((file.items[0].mri_place->mm - Eigen::Vector3d(-50, 40, 70)).norm(), 0.0, 1e-6);
  EXPECT_THAT(file.notes, ::testing::Contains(HasSubstr("to 0.0 mm")));
  head.points = HeadPoints{{-70, 0, 0}, {0, 140, 0}, {70, 0, 0}};
  EXPECT_THAT(readCheckedText(text, head).items[0].refusal, HasSubstr("at most 8 mm"));
}

TEST(Navinibs, ABareListIsTaken) {
  const std::string text = readWholeFile(made("navinibs_targets.json"));
  const auto begin = text.find('['), end = text.rfind(']');
  const auto file = readCheckedText(text.substr(begin, end - begin + 1), madeHead());
  EXPECT_EQ(apart(file, truth()).compared, 4);
}

TEST(Invesalius, OlderFilesTellTheKindByLabelAndOrientation) {
  std::string text = "##INVESALIUS3_MARKER_FILE_0\nx\ty\tz\talpha\tbeta\tgamma\tlabel\n";
  text += "100\t100\t100\tNone\tNone\tNone\tLEI\n100\t100\t100\t10\t20\t30\thot\n";
  const auto file = readCheckedText(text, madeHead());
  EXPECT_EQ(itemNamed(file, "LEI").kind, Kind::landmark);
  EXPECT_EQ(itemNamed(file, "hot").kind, Kind::target);
}

/// Cut within the last line, where a reader could take what is left for a whole item.
TEST(Formats, ALastLineThatIsCutShortIsRefused) {
  const std::pair<const char*, std::size_t> kCuts[] = {{"brainsight_v12_targets.txt", 10},
                                                       {"simnibs_positions.csv", 4},
                                                       {"invesalius_v5.mkss", 190},
                                                       {"slicer_first_pose.tfm", 30}};
  for (const auto& [name, cut] : kCuts) {
    const std::string content = readWholeFile(made(name));
    EXPECT_THAT(refusalOf([&] { readCheckedText(content.substr(0, content.size() - cut), madeHead()); }),
                HasSubstr("is cut short"))
        << name;
  }
}

TEST(Formats, KindsThatAreKnownAndNotReadAreNamed) {
  const auto refusal = [](const std::string& content) {
    return refusalOf([&] { readOtherText({content, "file", nullptr}); });
  };
  EXPECT_THAT(refusal("onset\tduration\n"), HasSubstr("NIBS-BIDS"));
  EXPECT_THAT(refusal("SQLite format 3"), HasSubstr("Brainsight project"));
  EXPECT_THAT(refusal(std::string("\xFF\xFE#\0", 4)), HasSubstr("UTF-16"));
  EXPECT_THAT(refusal("# Version: 1\n# Something\n"), HasSubstr("stream of poses"));
}

TEST(SimnibsPositions, ATableSavedByASpreadsheetGivesTheSamePoses) {
  const std::string commas = readWholeFile(made("simnibs_positions.csv"));
  for (const char* separator : {";", "\t"}) {
    const std::string saved = changed(changed(commas, ",", separator), ".", ",");
    EXPECT_TRUE(isKnown(saved));
    const auto file = readCheckedText(saved, madeHead());
    EXPECT_EQ(apart(file, truth()).compared, 4);
    EXPECT_LT(apart(file, truth()).mm, 1e-5);
    EXPECT_THAT(file.notes.front(), HasSubstr("as a spreadsheet does it"));
  }
}

TEST(SimnibsPositions, AMissingDistanceLeavesTheName) {
  const auto file =
      readCheckedText("CoilPos,0,0,100,0,0,-1,0,1,0,M1\nCoilPos,0,0,100,0,0,-1,0,1,0,4\n", madeHead());
  EXPECT_EQ(file.items[0].name, "M1");
  EXPECT_NE(file.items[1].name, "4") << "a distance without a name";
}

TEST(OwnTable, AQuaternionThatIsNoUnitIsNamed) {
  const auto file =
      readCheckedText("kind,name,tx,ty,tz,qw,qx,qy,qz\ntarget,M1,0,0,100,0,2,0,0\n", madeHead());
  EXPECT_EQ(file.items[0].refusal, "its quaternion has the length 2 instead of 1");
}

TEST(AnyText, Utf16WithoutItsMarkIsNamed) {
  std::string wide;
  for (const char c : brainsight()) wide += std::string(1, c) + '\0';
  EXPECT_THAT(refusalOf([&] { readOtherText({wide, "file", nullptr}); }), HasSubstr("UTF-16"));
}

}  // namespace
}  // namespace facenav::interop
