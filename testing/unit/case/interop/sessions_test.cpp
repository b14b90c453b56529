// Session folders and archives of other navigators, StimGuide's and visor2's pulses.

#include <gmock/gmock.h>

#include "facenav/core/zip_file.h"
#include "interop_fixtures.h"
#include "support/refusal.h"

namespace facenav::interop {
namespace {

using facenav::testing::refusalOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using namespace interop::testing;

class Sessions : public ::testing::Test {
 protected:
  void write(const std::string& name, const std::string& content) {
    std::filesystem::create_directories((at() / name).parent_path());
    writeWholeFile(at() / name, content);
  }
  std::filesystem::path at() const { return folder_.path() / "session"; }
  facenav::testing::TemporaryFolder folder_;
};

std::string navinibsTargets() {
  const std::string text = readWholeFile(made("navinibs_targets.json"));
  return text.substr(text.find('['), text.rfind(']') + 1 - text.find('['));
}

ZipEntries navinibsSession() {
  return {{"SessionConfig.json",
           R"({"formatVersion": "0.0.2", "subjectID": "x", "targets": "SessionConfig_Targets.json", )"
           R"("samples": "SessionConfig_Samples.json"})"},
          {"SessionConfig_Targets.json", navinibsTargets()},
          {"SessionConfig_Samples.json",
           R"([{"key": "Sample 0", "timestamp": "2026-03-05T10:20:30.176000", "targetKey": "Vertex"}, )"
           R"({"key": "Sample 1", "timestamp": "2026-03-05T10:20:31.5", "coilToMRITransf": )"
           R"([[NaN, 0, 0, 1], [0, 1, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1]]}])"}};
}

TEST_F(Sessions, NavinibsComesAsAFolderAndAsAnArchive) {
  for (const auto& [name, content] : navinibsSession()) write(name, content);
  const auto archive = folder_.path() / "s.navinibs";
  writeZip(navinibsSession(), archive);
  ZipEntries nested;
  for (const auto& [name, content] : navinibsSession()) nested["sub-1/" + name] = content;
  writeZip(nested, folder_.path() / "nested.zip");
  EXPECT_TRUE(isSessionArchive(archive));
  for (const auto& path : {at(), archive, folder_.path() / "nested.zip"}) {
    const auto file = readChecked(path, madeHead());
    EXPECT_EQ(apart(file, truth()).compared, 4) << path;
    EXPECT_LT(apart(file, truth()).mm, 1e-9);
    EXPECT_EQ(itemNamed(file, "Sample 0").target, "Vertex");
    EXPECT_NEAR(*itemNamed(file, "Sample 1").clock_s, 1772706031.5, 1e-3);
    EXPECT_THAT(itemNamed(file, "Sample 1").refusal, HasSubstr("no finite number"));
  }
}

TEST_F(Sessions, ANavinibsSessionOfAnotherVersionOrWithAHoleIsRefused) {
  auto entries = navinibsSession();
  entries["SessionConfig.json"] = R"({"formatVersion": "0.1.0", "targets": "SessionConfig_Targets.json"})";
  writeZip(entries, folder_.path() / "new.navinibs");
  EXPECT_THAT(refusalOf([&] { readOther(folder_.path() / "new.navinibs", nullptr); }),
              HasSubstr("version '0.1.0'"));
  entries = navinibsSession();
  entries.erase("SessionConfig_Samples.json");
  writeZip(entries, folder_.path() / "hole.navinibs");
  EXPECT_THAT(refusalOf([&] { readOther(folder_.path() / "hole.navinibs", nullptr); }),
              HasSubstr("not there"));
  writeZip({{"notes.txt", "hello"}}, folder_.path() / "other.zip");
  EXPECT_THAT(refusalOf([&] { readOther(folder_.path() / "other.zip", nullptr); }), HasSubstr("archive"));
}

/// A list of pulses: "+" with a pose, "-" without.
std::string triggerList(const std::string& pulses, const std::string& start, double z = 90) {
  std::string text = "<TriggerMarkerList coordinateSpace=\"RAS\" startTime=\"" + start + "\">";
  int number = 0;
  for (const char c : pulses) {
    const std::string r = c == '+' ? "0" : "1", s = c == '+' ? "1" : "0";
    text += "<TriggerMarker description=\"\" recordingTime=\"" + std::to_string(1000 * ++number) +
            "\" set=\"" + (c == '+' ? "true" : "false") + "\"><Matrix4D data00=\"" + r + "\" data01=\"" + s +
            "\" data02=\"0\" data03=\"10\" data10=\"" + (c == '+' ? "-1" : "0") + "\" data11=\"" + r +
            "\" data12=\"0\" data13=\"20\" data20=\"0\" data21=\"0\" data22=\"1\" data23=\"" +
            std::to_string(z) + "\" data30=\"0\" data31=\"0\" data32=\"0\" data33=\"1\"/></TriggerMarker>";
  }
  return text + "</TriggerMarkerList>";
}

TEST_F(Sessions, OfLocalitesSavesTheFullestCountsAndBothCoilsAreJoined) {
  const std::string whole = readWholeFile(made("InstrumentMarker_ras.xml"));
  const std::string empty = "<InstrumentMarkerList coordinateSpace=\"RAS\"></InstrumentMarkerList>";
  write("Session.xml", "<Session/>");
  write("InstrumentMarkers/InstrumentMarker20260305102030125.xml", whole);
  write("InstrumentMarkers/InstrumentMarker20260305102030999.xml", empty);
  write("GUMMarkers/GUMMarkers20260305102030125.xml", readWholeFile(made("GUMMarkers.xml")));
  write("TMSTrigger/TriggerMarkers_Coil0_20260305102100125.xml", triggerList("+--+", "10:20:30.000"));
  write("TMSTrigger/TriggerMarkers_Coil0_20260305102100999.xml", triggerList("+-", "10:20:30.000"));
  write("TMSTrigger/TriggerMarkers_Coil1_20260305102100125.xml", triggerList("-+-+", "10:20:30.000", 80));
  const auto file = readChecked(at(), madeHead());
  EXPECT_EQ(file.format, "localite");
  EXPECT_EQ(apart(file, truth()).compared, 4) << "GUMMarkers repeats them";
  std::vector<Item> pulses;
  for (const auto& item : file.items)
    if (item.kind == Kind::pulse) pulses.push_back(item);
  ASSERT_EQ(pulses.size(), 5u);
  EXPECT_FALSE(pulses[2].pose);
  EXPECT_NEAR(pulses[1].pose->coeff(2, 3), 80, 1e-9) << "coil 2";
  EXPECT_EQ(pulses[1].values.at("coil"), "2");
  EXPECT_NEAR(*pulses[0].clock_s, 1772706031.0, 1e-3);
  EXPECT_THAT(file.notes, Contains(HasSubstr("the fullest of 2 saves: 4 entries")));
  EXPECT_THAT(file.notes, Contains(HasSubstr("both coils have a pose at 1 pulses")));
}

TEST_F(Sessions, APulseBeforeMidnightKeepsItsDayThoughTheListWasSavedAfterIt) {
  write("TriggerMarkers_Coil0_20260306001000125.xml", triggerList("+", "23:50:00.000"));
  const auto file = readOther(at() / "TriggerMarkers_Coil0_20260306001000125.xml", nullptr);
  EXPECT_EQ(file.items[0].time, "2026-03-05 23:50:01.000");
}

TEST_F(Sessions, SeveralSessionsAreAsked) {
  for (const char* session : {"a", "b"}) write(std::string(session) + "/Session.xml", "<Session/>");
  EXPECT_THAT(refusalOf([&] { readOther(at(), nullptr); }), HasSubstr("holds 2 sessions: a/, b/"));
}

TEST_F(Sessions, AFolderWithOneKnownFileIsReadAsThisFileAndWithTwoAsked) {
  write("notes.txt", "hello");
  write("targets.dat", readWholeFile(made("brainsight_v12_targets.txt")));
  EXPECT_EQ(readChecked(at(), madeHead()).format, "brainsight");
  write("x.csv", readWholeFile(made("simnibs_positions.csv")));
  EXPECT_THAT(refusalOf([&] { readOther(at(), nullptr); }), HasSubstr("holds 2 files that could be meant"));
  std::filesystem::create_directories(folder_.path() / "none");
  EXPECT_THAT(refusalOf([&] { readOther(folder_.path() / "none", nullptr); }),
              HasSubstr("holds no file of a navigator"));
}

constexpr const char* kVisor2Header =
    "visor2 software version,Subject,Session,Stimulus ID,Stimulation intensity (%),TMS stimulus time (clock "
    "time),TMS "
    "coil,Coordinate system,Coil position x (mm),Coil position y (mm),Coil position z (mm),Coil rotation "
    "x,Coil rotation "
    "y,Coil rotation z,Coil rotation w,rTMS stimulus,rTMS count,rTMS frequency (hz),Errors\n";

std::string visor2Pulses() {
  return std::string(kVisor2Header) +
         "2.4,S,\"one, \"\"a\"\"\",1,55,10:20:30.176,C,nasion-ear,60,-50,70,0,0,0,1,NO,NULL,NULL,\r\n"
         "2.4,S,\"one, \"\"a\"\"\",2,55,10:20:35.176,,,,,,,,,,,,,no coil";
}

CaseHead headWithPoints() {
  auto head = madeHead();
  head.points = HeadPoints{{-70, 5, 0}, {0, 105, 0}, {70, 5, 0}};
  return head;
}

TEST(Visor2Pulses, TheFrameIsAskedAndPulsesWithoutAPoseStay) {
  const auto asked = readCheckedText(visor2Pulses(), headWithPoints());
  EXPECT_EQ(asked.format, "visor2-pulses");
  EXPECT_THAT(asked.items[0].refusal, HasSubstr("--head-frame x-nasion or --head-frame x-right"));
  EXPECT_EQ(asked.items[1].refusal, "");
  Answers answers;
  answers.head_frame = HeadFrame::x_nasion;
  EXPECT_THAT(readCheckedText(visor2Pulses(), madeHead(), answers).items[0].refusal,
              HasSubstr("has no landmarks"));
  const auto file = readCheckedText(visor2Pulses(), headWithPoints(), answers);
  EXPECT_LT((file.items[0].mri_place->mm - Eigen::Vector3d(50, 65, 70)).norm(), 1e-9) << "x front, y left";
  answers.head_frame = HeadFrame::x_right;
  const auto other = readCheckedText(visor2Pulses(), headWithPoints(), answers);
  EXPECT_LT((other.items[0].mri_place->mm - Eigen::Vector3d(60, -45, 70)).norm(), 1e-9) << "x right, y front";
  EXPECT_EQ(other.items[0].session, "one, \"a\"");
  EXPECT_EQ(other.items[1].kind, Kind::pulse);
  EXPECT_FALSE(other.items[1].mri_place);
  EXPECT_EQ(other.items[1].intensity_pct, 55);
  EXPECT_NEAR(*other.items[1].onset_s, 5.0, 1e-6) << "since the first pulse";
  EXPECT_THAT(other.notes, Contains(HasSubstr("no residual can be stated")));
}

TEST(Visor2Pulses, OtherSystemsAndCutLinesAreRefused) {
  std::string text = visor2Pulses();
  text.replace(text.find("nasion-ear"), 10, "MNI");
  EXPECT_THAT(readCheckedText(text, headWithPoints()).items[0].refusal, HasSubstr("a template's"));
  text = visor2Pulses();
  text.resize(text.rfind(",,"));
  EXPECT_THAT(refusalOf([&] { readCheckedText(text, headWithPoints()); }), HasSubstr("cells, the header 19"));
}

TEST(Stimguide, StimuliStayPulsesWithThePlaceThatIsKnown) {
  const std::string ears =
      R"("LeftEar": {"X": -0.07, "Y": 0.005, "Z": 0}, "Nasion": {"X": 0, "Y": 0.105, "Z": 0}, )"
      R"("RightEar": {"X": 0.07, "Y": 0.005, "Z": 0})";
  const std::string text =
      R"({"Targets": [], "Stimuli": [{"Name": "1", "Position": {"X": -0.05, "Y": 0.04, "Z": 0.07}, "Intensity": )"
      R"({"Value": 60}, "Time": "2026-03-05T10:20:30.1760000Z", "Target": {"Name": "M1"}}, {"Name": "2"}], )"
      R"("Landmarks": [{)" +
      ears + "}]}";
  const auto file = readCheckedText(text, headWithPoints());
  EXPECT_EQ(file.items[0].kind, Kind::pulse);
  EXPECT_LT((file.items[0].mri_place->mm - Eigen::Vector3d(-50, 40, 70)).norm(), 1e-6);
  EXPECT_THAT(file.items[0].reason, HasSubstr("axes of the program's coil"));
  EXPECT_NEAR(*file.items[0].clock_s, 1772706030.176, 1e-3);
  EXPECT_FALSE(file.items[1].mri_place);
}

}  // namespace
}  // namespace facenav::interop
