// Odd files of every format: one table of poses and of texts, one writer a format that knows nothing of ours.

#include <gmock/gmock.h>

#include "facenav/core/number_text.h"
#include "facenav/interop/axes.h"
#include "two_forms.h"

namespace facenav::interop {
namespace {

using ::testing::HasSubstr;
using namespace interop::testing;

/// Writes one target with this pose, also one that is none.
using Writer = std::function<std::string(const std::string& name, const Eigen::Matrix4d& ours)>;

std::string text(double value) { return std::isnan(value) ? "NaN" : formatted("%.9f", value); }

std::string joined(const std::vector<double>& values, const char* between) {
  std::string all;
  for (const double value : values) all += (all.empty() ? "" : between) + text(value);
  return all;
}

std::vector<double> rowsOf(const Eigen::Matrix4d& m, int rows) {
  std::vector<double> values;
  for (int i = 0; i < 4 * rows; ++i) values.push_back(m(i / 4, i % 4));
  return values;
}

std::string nested(const Eigen::Matrix4d& m) {
  std::string all;
  for (int row = 0; row < 4; ++row)
    all += (row == 0 ? "[" : ", [") + joined({m(row, 0), m(row, 1), m(row, 2), m(row, 3)}, ", ") + "]";
  return "[" + all + "]";
}

std::string columnsOf(const Eigen::Matrix4d& m, const char* between) {
  std::vector<double> values;
  for (const int column : {3, 0, 1, 2})
    for (int row = 0; row < 3; ++row) values.push_back(m(row, column));
  return joined(values, between);
}

std::string brainsight(const std::string& name, const Eigen::Matrix4d& ours) {
  return "# Version: 13\n# Coordinate system: NIfTI:Aligned\n# Target Name\tLoc. X\tLoc. Y\tLoc. "
         "Z\tm0n0\tm0n1\tm0n2\tm1n0\tm1n1\tm1n2\tm2n0\tm2n1\tm2n2\n" +
         name + "\t" + columnsOf(fromFaceNav(ours, CoilAxes::brainsight), "\t") + "\n";
}

std::string localite(const std::string& name, const Eigen::Matrix4d& ours) {
  const Eigen::Matrix4d m = fromFaceNav(ours, CoilAxes::localite);
  std::string cells;
  for (int i = 0; i < 16; ++i)
    cells += formatted(" data%d%d=\"", i / 4, i % 4) + text(m(i / 4, i % 4)) + "\"";
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<InstrumentMarkerList coordinateSpace=\"RAS\">\n"
         "<InstrumentMarker index=\"0\">\n<Marker set=\"true\" description=\"" +
         name + "\">\n<Matrix4D" + cells + "/>\n</Marker>\n</InstrumentMarker>\n</InstrumentMarkerList>\n";
}

std::string softaxic(const std::string& name, const Eigen::Matrix4d& ours) {
  const Eigen::Matrix4d m = fromFaceNav(ours, CoilAxes::softaxic);
  std::string cells;
  for (int i = 0; i < 9; ++i) cells += formatted(" m%d%d=\"", i / 3, i % 3) + text(m(i / 3, i % 3)) + "\"";
  for (int i = 0; i < 3; ++i) cells += std::string(" ") + "xyz"[i] + "=\"" + text(m(i, 3)) + "\"";
  return "<!DOCTYPE stmp>\n<stmp>\n<fmpm>\n<fmp id=\"" + name + "\">\n<fp" + cells +
         " id=\"1\" ts=\"0\"/>\n</fmp>\n</fmpm>\n</stmp>\n";
}

std::string visor2(const std::string& name, const Eigen::Matrix4d& ours) {
  std::string content = readWholeFile(made("ant_visor2.mrk"));
  content.resize(content.find("\"TargetMarkers\""));
  return content + "\"TargetMarkers\": [{\"CoilTarget\": {\"Name\": \"" + name +
         "\",\n\"CoilPose\": {\"RigidTransformMatrix4x4\": " + nested(ours) + "}}}]}\n";
}

std::string markups(const std::string& name, const Eigen::Matrix4d& ours) {
  const Eigen::Matrix4d m = lpsFromRas() * ours;
  return "{\"markups\": [{\"type\": \"Fiducial\",\n\"coordinateSystem\": \"LPS\", \"controlPoints\": "
         "[{\"label\": \"" +
         name + "\", \"position\": [" + joined({m(0, 3), m(1, 3), m(2, 3)}, ", ") + "], \"orientation\": [" +
         joined({m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1), m(2, 2)}, ", ") +
         "]}]}]}\n";
}

std::string navinibs(const std::string& name, const Eigen::Matrix4d& ours) {
  return "{\"targets\":\n[{\"key\": \"" + name +
         "\", \"coilToMRITransf\": " + nested(fromFaceNav(ours, CoilAxes::brainsight)) + "}]}\n";
}

std::string table(const std::string& name, const Eigen::Matrix4d& ours) {
  std::string header = "name";
  for (int i = 0; i < 12; ++i) header += formatted(",m%d%d", i / 4, i % 4);
  return header + "\n\"" + name + "\"," + joined(rowsOf(ours, 3), ",") + "\n";
}

std::string nibsBids(const std::string& name, const Eigen::Matrix4d& ours) {
  std::string header = "nibs_position_id\tposition_label";
  for (const char axis : {'x', 'y', 'z'}) header += std::string("\telement_centre_") + axis;
  for (const char of : {'x', 'y', 'z'})
    for (const char axis : {'x', 'y', 'z'}) header += formatted("\telement_%cdir_%c", of, axis);
  return header + "\np1\t" + name + "\t" + columnsOf(ours, "\t") + "\n";
}

const std::map<std::string, Writer> kWriters{
    {"brainsight", brainsight}, {"localite", localite}, {"softaxic", softaxic}, {"visor2", visor2},
    {"mrk.json", markups},      {"navinibs", navinibs}, {"csv", table},         {"nibs-bids", nibsBids}};

/// Reads content as a file beside what its format needs.
class OddFiles : public ::testing::Test {
 protected:
  OtherFile read(const std::string& content) {
    writeWholeFile(folder_.path() / "sub-01_task-a_coordsystem.json",
                   "{\"NIBSCoordinateSystem\": \"IndividualMRI\", \"NIBSCoordinateUnits\": \"mm\"}");
    const auto path = folder_.path() / "sub-01_task-a_markers.tsv";
    writeWholeFile(path, content);
    Answers answers;
    answers.keeps_handle = true;
    return readChecked(path, head_, answers);
  }
  /// The only item, or an item refused with the words of the whole file's refusal.
  Item only(const std::string& content) {
    try {
      return read(content).items.at(0);
    } catch (const Error& error) {
      Item item;
      item.refusal = error.what();
      return item;
    }
  }
  facenav::testing::TemporaryFolder folder_;
  CaseHead head_ = madeHead();
  Eigen::Matrix4d sound_ = truth().at("DLPFC L").matrix();
};

TEST_F(OddFiles, ASoundPoseComesInFromEachWriter) {
  for (const auto& [format, write] : kWriters) {
    const auto file = read(write("M1", sound_));
    EXPECT_EQ(file.format, format);
    ASSERT_TRUE(file.items.at(0).mri_T_coil) << format << ": " << file.items[0].refusal;
    EXPECT_LT((file.items[0].mri_T_coil->matrix() - sound_).cwiseAbs().maxCoeff(), 1e-6) << format;
  }
}

TEST_F(OddFiles, PosesThatAreNoneAreRefusedAndSmallShearIsMendedAndSaid) {
  struct Odd {
    const char* words;  // of the refusal; empty: taken
    std::function<void(Eigen::Matrix4d&)> change;
  };
  const Odd kOdd[] = {
      {"left-handed", [](auto& m) { m.col(0) *= -1; }},
      {"deg from right angles", [](auto& m) { m.col(0) = (m.col(0) + 0.04 * m.col(1)).normalized(); }},
      {"has the length", [](auto& m) { m.template block<3, 1>(0, 2) *= 1.2; }},
      {"no finite number", [](auto& m) { m(1, 3) = std::nan(""); }},
      {"no finite number", [](auto& m) { m(0, 1) = std::nan(""); }},
      {"from the middle of the head", [](auto& m) { m(2, 3) = 950; }},
      {"has the length", [](auto& m) { m.template topLeftCorner<3, 3>().setZero(); }},
      {"", [](auto& m) { m.template block<3, 1>(0, 0) += 0.006 * m.template block<3, 1>(0, 1); }}};
  for (const auto& [format, write] : kWriters)
    for (const auto& odd : kOdd) {
      Eigen::Matrix4d pose = sound_;
      odd.change(pose);
      const Item item = only(write("M1", pose));
      if (std::string(odd.words).empty()) {
        ASSERT_TRUE(item.mri_T_coil) << format << ": " << item.refusal;
        EXPECT_THAT(item.notes, ::testing::Contains(HasSubstr("made unit and orthogonal"))) << format;
        EXPECT_LT((item.mri_T_coil->matrix() - sound_).cwiseAbs().maxCoeff(), 0.006) << format;
      } else if (format != "mrk.json" || !std::isnan(pose.sum())) {
        EXPECT_THAT(item.refusal, HasSubstr(odd.words)) << format;
      } else {
        EXPECT_NE(item.refusal, "") << format << ": a list of numbers with NaN";
      }
    }
}

std::string changed(std::string content, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = content.find(from, at)) != std::string::npos; at += to.size())
    content.replace(at, from.size(), to);
  return content;
}

TEST_F(OddFiles, LineEndsMarksAndOpenEndsChangeNothing) {
  for (const auto& [format, write] : kWriters) {
    const std::string content = write("M1", sound_);
    for (const auto& odd :
         {changed(content, "\n", "\r\n"), changed(content, "\n", "\r"), "\xEF\xBB\xBF" + content,
          content.substr(0, content.size() - 1), content + "\n\n"}) {
      const Item item = only(odd);
      ASSERT_TRUE(item.mri_T_coil) << format << ": " << item.refusal;
      EXPECT_EQ(item.name, "M1") << format;
    }
  }
}

TEST_F(OddFiles, DecimalCommasAreNamedNotMisread) {
  for (const char* format : {"brainsight", "localite", "softaxic", "nibs-bids"}) {
    std::string content = kWriters.at(format)("M1", sound_);
    for (std::size_t i = 1; i + 1 < content.size(); ++i)
      if (content[i] == '.' && std::isdigit(content[i - 1]) && std::isdigit(content[i + 1])) content[i] = ',';
    content = changed(content, "version=\"1,0\"", "version=\"1.0\"");
    EXPECT_THAT(only(content).refusal, HasSubstr("decimal commas")) << format;
  }
}

TEST_F(OddFiles, NamesOfEveryScriptStayAndLineBreaksBecomeBlanks) {
  for (const char* name : {"左手 運動野", "рука 'M1'", "يد", "main gauche, «M1»", "e\xCC\x81 combined"})
    for (const auto& [format, write] : kWriters) EXPECT_EQ(only(write(name, sound_)).name, name) << format;
  for (const char* format : {"visor2", "mrk.json", "navinibs"})
    EXPECT_EQ(only(kWriters.at(format)("M1\\n\\thand \\\"L\\\"", sound_)).name, "M1  hand \"L\"") << format;
  for (const char* format : {"localite", "softaxic"})
    EXPECT_EQ(only(kWriters.at(format)("M1&#10;hand &quot;L&quot; &lt;", sound_)).name, "M1 hand \"L\" <");
}

TEST_F(OddFiles, UnknownVersionsAreNamed) {
  EXPECT_THAT(only(changed(brainsight("M1", sound_), "Version: 13", "Version: 16")).refusal,
              HasSubstr("version 16"));
  EXPECT_THAT(only("##INVESALIUS3_MARKER_FILE_6\nx\ty\n").refusal, HasSubstr("not read"));
}

TEST_F(OddFiles, ABrainsightFileWithASecondCoordinateSystemIsRefused) {
  const std::string first = brainsight("M1", sound_);
  EXPECT_EQ(read(first + first).items.size(), 1u) << "one target twice";
  EXPECT_THAT(only(first + changed(first, "Aligned", "MNI-152")).refusal,
              HasSubstr("second coordinate system"));
}

/// The other program's T1 is the case's in another world, stored in another order.
TEST_F(OddFiles, TheSamePoseComesInFromEachFormOfTheT1) {
  const T1 t1 = writeTwoForms(folder_.path() / "t1.nii");
  const auto head = headOf(t1);
  const Eigen::Matrix4d wanted = t1.grid.mri_from_voxel.matrix() * t1.qform->inverse().matrix() * sound_;
  Answers answers;
  answers.keeps_handle = true;
  answers.form = Form::qform;
  for (const auto& [format, write] : kWriters) {
    if (format == "nibs-bids") continue;  // needs its side file: NibsBids
    const auto file = readCheckedText(write("M1", sound_), head, answers);
    ASSERT_TRUE(file.items[0].mri_T_coil) << format << ": " << file.items[0].refusal;
    EXPECT_LT((file.items[0].mri_T_coil->translation_mm() - wanted.topRightCorner<3, 1>()).norm(), 1e-5)
        << format;
  }
}

}  // namespace
}  // namespace facenav::interop
