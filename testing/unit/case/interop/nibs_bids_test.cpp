// NIBS-BIDS in and out: units, spaces, the sign of y, lists of coils, other T1s.

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "facenav/core/number_text.h"
#include "support/refusal.h"
#include "two_forms.h"

namespace facenav::interop {
namespace {

using facenav::testing::refusalOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using namespace interop::testing;
using Files = std::map<std::string, std::string>;

constexpr const char* kStem = "sub-01_task-rest_";

std::string changed(std::string content, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = content.find(from, at)) != std::string::npos; at += to.size())
    content.replace(at, from.size(), to);
  return content;
}

Answers asWritten() {
  Answers answers;
  answers.keeps_handle = true;
  return answers;
}

class NibsBids : public ::testing::Test {
 protected:
  NibsBids() {
    for (const char* suffix : {"markers.tsv", "events.tsv", "nibs.tsv", "nibs.json", "coordsystem.json"})
      files_[suffix] = readWholeFile(made(kStem + std::string(suffix)));
  }
  std::filesystem::path write(const std::string& name, const std::string& content) {
    const auto path = folder_.path() / name;
    std::filesystem::create_directories(path.parent_path());
    writeWholeFile(path, content);
    return path;
  }
  OtherFile read(const Answers& answers = asWritten(), const CaseHead& head = madeHead()) {
    write("dataset_description.json", "{}");
    for (const auto& [suffix, content] : files_) write("sub-01/nibs/" + (kStem + suffix), content);
    return readChecked(folder_.path(), head, answers);
  }
  Files files_;
  facenav::testing::TemporaryFolder folder_;
};

TEST_F(NibsBids, TheMadeSetGivesTargetsAndPulses) {
  const auto file = read();
  EXPECT_EQ(file.format, "nibs-bids");
  EXPECT_EQ(apart(file, truth()).compared, 4);
  EXPECT_LT(apart(file, truth()).mm, 1e-4);
  EXPECT_LT(apart(file, truth()).deg, 1e-3);
  int pulses = 0, lost = 0;
  for (const auto& item : file.items) {
    pulses += item.kind == Kind::pulse;
    lost += item.kind == Kind::pulse && !item.mri_T_coil;
  }
  EXPECT_EQ(pulses, 12);
  EXPECT_EQ(lost, 1);
  const auto& second = itemNamed(file, "pulse 2");
  EXPECT_EQ(second.target, "DLPFC L");
  EXPECT_EQ(second.onset_s, 3.151);
  EXPECT_EQ(second.intensity_pct, 55);
  EXPECT_EQ(second.session, "task-rest");
  EXPECT_EQ(readChecked(folder_.path() / "sub-01/nibs/sub-01_task-rest_markers.tsv", madeHead()).items.size(),
            16u)
      << "the table alone finds its neighbours";
}

TEST_F(NibsBids, TheSignOfYIsShownInWordsAndAsked) {
  const auto asked = read({});
  const auto& vertex = itemNamed(asked, "Vertex");
  EXPECT_FALSE(vertex.mri_T_coil);
  EXPECT_EQ(
      vertex.refusal,
      "as written its handle points to the back of the head, flipped to the front of the head: give --y-sign "
      "as-written or --y-sign flipped");
  Answers flipped;
  flipped.flips_handle = true;
  const auto turned = read(flipped);
  const auto& pose = *itemNamed(turned, "Vertex").mri_T_coil;
  EXPECT_LT((pose.rotation().col(1) + truth().at("Vertex").rotation().col(1)).norm(), 1e-3);
  EXPECT_THAT(itemNamed(turned, "Vertex").notes, Contains(HasSubstr("points to the front")));
  EXPECT_THAT(itemNamed(read(), "M1 hand L").notes,
              Contains("its handle points to the back and left of the head, downwards"));
}

TEST_F(NibsBids, UnitsAreStatedOrRefused) {
  std::string& system = files_["coordsystem.json"];
  const std::string mm = system;
  system = changed(mm, "\"NIBSCoordinateUnits\": \"mm\"", "\"NIBSCoordinateUnits\": \"m\"");
  EXPECT_THAT(itemNamed(read(), "M1 hand L").refusal, HasSubstr("from the middle of the head"))
      << "mm under the name of m";
  auto& markers = files_["markers.tsv"];
  markers = changed(markers, "1.5000\t-16.7481\t113.8999", "0.0015\t-0.0167481\t0.1138999");
  EXPECT_LT(poseError(*itemNamed(read(), "Vertex").mri_T_coil, truth().at("Vertex")).translation_mm, 1e-4);
  system = changed(mm, "\"NIBSCoordinateUnits\": \"mm\"", "\"NIBSCoordinateUnits\": \"n/a\"");
  EXPECT_THAT(refusalOf([&] { read(); }), HasSubstr("unit of its coordinates is not stated"));
  files_["markers.json"] = "{\"element_centre_x\": {\"Units\": \"m\"}}";
  EXPECT_TRUE(itemNamed(read(), "Vertex").mri_T_coil);
  system = mm;
  EXPECT_THAT(refusalOf([&] { read(); }), HasSubstr("'mm' by coordsystem.json and 'm' by markers.json"));
}

TEST_F(NibsBids, SpacesOfTemplatesAreRefusedAndUnknownOnesAsked) {
  const std::string own = files_["coordsystem.json"];
  const auto refusalIn = [&](const std::string& system) {
    files_["coordsystem.json"] = changed(own, "IndividualMRI", system);
    return itemNamed(read(), "Vertex").refusal;
  };
  for (const char* system : {"MNI152NLin2009cAsym", "ICBM452AirSpace", "fsaverage", "Talairach"})
    EXPECT_THAT(refusalIn(system), HasSubstr("a template's")) << system;
  for (const char* system : {"Other", "CTF", "n/a"})
    EXPECT_THAT(refusalIn(system), HasSubstr("--space")) << system;
  EXPECT_EQ(refusalIn("individual"), "");
  files_.erase("coordsystem.json");
  std::filesystem::remove(folder_.path() / "sub-01/nibs/sub-01_task-rest_coordsystem.json");
  EXPECT_THAT(refusalOf([&] { read(); }), HasSubstr("NIBSCoordinateUnits"));
  write("task-rest_coordsystem.json", own);
  EXPECT_EQ(itemNamed(read(), "Vertex").refusal, "") << "a side file above applies, too";
}

TEST_F(NibsBids, ColumnsMoveAndMissingCellsAreNotNumbers) {
  files_ = {{"coordsystem.json", files_["coordsystem.json"]}};
  files_["markers.tsv"] =
      "element_zdir_x\telement_zdir_y\telement_zdir_z\tposition_label\telement_ydir_x\telement_ydir_y\t"
      "element_ydir_z\tnibs_position_id\telement_centre_z\telement_centre_y\telement_centre_x\ttarget_"
      "x\ttarget_y\t"
      "target_z\n"
      "0\t0\t-1\tno x\t0\t1\t0\ta\t90\t20\t10\tn/a\tn/a\tn/a\n"
      "0\t0\t-1\thole\t0\tn/a\t0\tb\t90\t20\t10\tn/a\tn/a\tn/a\n"
      "n/a\tn/a\tn/a\tplace\tn/a\tn/a\tn/a\tc\tn/a\tn/a\tn/a\t1\t2\t3\n";
  const auto file = read();
  ASSERT_TRUE(itemNamed(file, "no x").mri_T_coil) << itemNamed(file, "no x").refusal;
  EXPECT_NEAR((itemNamed(file, "no x").mri_T_coil->translation_mm() - Eigen::Vector3d(10, 20, 90)).norm(), 0,
              1e-9);
  EXPECT_THAT(itemNamed(file, "hole").refusal, HasSubstr("no finite number"));
  EXPECT_EQ(itemNamed(file, "place").mri_place->mm.z(), 3);
  files_["markers.tsv"] += "0\t0\t-1\tagain\t0\t1\t0\ta\t90\t20\t10\tn/a\tn/a\tn/a\n";
  EXPECT_THAT(refusalOf([&] { read(); }), HasSubstr("has the position 'a' a second time"));
  files_["markers.tsv"] += "0\t0\t-1\n";
  EXPECT_THAT(refusalOf([&] { read(); }), HasSubstr("has 3 cells, the header 14"));
}

TEST_F(NibsBids, TwoCoilsOfOneEventAreTwoPulsesWithTheirStrengths) {
  files_["events.tsv"] =
      "onset\tduration\tnibs_event_id\tnibs_position_id\n1.5\t500\tpair\tpos1|pos2\n2\t0\tn/a\tpos3\n";
  files_["nibs.tsv"] =
      "nibs_event_id\tnibs_element_id\tstimulus_intensity\tpattern1_intensity\npair\tA|B\tn/a\t45|58\n";
  const auto file = read();
  EXPECT_EQ(itemNamed(file, "pulse 1").intensity_pct, 45);
  EXPECT_EQ(itemNamed(file, "pulse 2").intensity_pct, 58);
  EXPECT_EQ(itemNamed(file, "pulse 2").values.at("nibs_element_id"), "B");
  EXPECT_EQ(itemNamed(file, "pulse 2").target, "Vertex");
  EXPECT_EQ(apart(file, truth()).compared, 4 + 11)
      << "a train's places stay targets; pulses of no event, too";
  EXPECT_THAT(file.notes, Contains(HasSubstr("2 pulses stand for a train each")));
}

TEST_F(NibsBids, SeveralPeopleAreNotMixed) {
  write("sub-02/nibs/sub-02_task-rest_markers.tsv", files_["markers.tsv"]);
  EXPECT_THAT(refusalOf([&] { read(); }), HasSubstr("holds 2 people: sub-01, sub-02"));
  write("sub-02/nibs/sub-02_task-rest_coordsystem.json", files_["coordsystem.json"]);
  EXPECT_EQ(readOther(folder_.path() / "sub-02", nullptr).items.size(), 15u);
}

TEST_F(NibsBids, TheT1ThatItIsIntendedForIsFoundBesideIt) {
  EXPECT_THAT(read().notes, Contains(HasSubstr("is not beside it")));
  write("sub-01/anat/sub-01_T1w.nii.gz", readWholeFile(made("t1_lpi.nii.gz")));
  EXPECT_EQ(read().intended_t1, folder_.path() / "sub-01/anat/sub-01_T1w.nii.gz");
  files_["coordsystem.json"] = changed(files_["coordsystem.json"], "bids::sub-01/anat", "bids::../../etc");
  EXPECT_EQ(read().intended_t1, "");
}

TEST_F(NibsBids, AnAcquisitionTimeGivesPulsesTheirDateUnlessItHidesIt) {
  const std::string head = "filename\tacq_time\nnibs/sub-01_task-rest_nibs.tsv\t";
  write("sub-01/sub-01_scans.tsv", head + "2026-03-05T10:20:30\n");
  EXPECT_NEAR(*itemNamed(read(), "pulse 1").clock_s, 1772706030.051, 1e-3);
  write("sub-01/sub-01_scans.tsv", head + "1877-06-15T14:00:00\n");
  EXPECT_FALSE(itemNamed(read(), "pulse 1").clock_s);
}

/// Two targets, two sessions with a pulse each (one without a pose), a landmark.
Order orderOf(const T1& t1) {
  Order order;
  order.t1 = t1;
  order.software = "FaceNav 0.1.0";
  order.subject = "P017";
  for (const auto& [name, pose] : truth()) {
    Item item;
    item.name = name == "SMA" ? "左\tSMA \"a\"" : name;
    item.mri_T_coil = pose;
    order.items.push_back(item);
  }
  for (int i = 0; i < 3; ++i) {
    auto pulse =
        madePulse(i < 2 ? "20261127T140509Z" : "20261128T090000Z", "Vertex", 1795788309.25 + 3.5 * i);
    if (i != 1) pulse.mri_T_coil = truth().at("Vertex");
    order.items.push_back(pulse);
  }
  order.items.push_back(nasionAt(t1.grid.centre()));
  return order;
}

TEST_F(NibsBids, AWrittenSetComesBackWithoutAQuestionAndHoldsNoDates) {
  const auto t1 = writeTwoForms(folder_.path() / "t1.nii");
  const auto written = writtenFormat("nibs-bids").write_folder(orderOf(t1));
  std::string all;
  for (const auto& [name, content] : written.files) {
    write("set/" + name, content);
    all += content;
  }
  EXPECT_THAT(all, ::testing::Not(HasSubstr("2026-11")));
  EXPECT_THAT(all, ::testing::Not(HasSubstr("20261127")));
  const auto file = readChecked(folder_.path() / "set", headOf(t1));
  EXPECT_EQ(apart(file, truth()).compared, 3);
  EXPECT_LT(apart(file, truth()).mm, 1e-6);
  EXPECT_LT(apart(file, truth()).deg, 1e-6);
  EXPECT_EQ(itemNamed(file, "左 SMA \"a\"").refusal, "");
  std::vector<Item> pulses;
  for (const auto& item : file.items)
    if (item.kind == Kind::pulse) pulses.push_back(item);
  ASSERT_EQ(pulses.size(), 3u);
  EXPECT_EQ(pulses[0].session, "task-tms_run-01");
  EXPECT_EQ(pulses[2].session, "task-tms_run-02");
  EXPECT_FALSE(pulses[1].mri_T_coil);
  EXPECT_EQ(pulses[1].onset_s, 3.5);
  EXPECT_EQ(pulses[0].intensity_pct, 61.5);
  EXPECT_EQ(pulses[0].mep_uv, 412.25);
  EXPECT_EQ(pulses[0].target, "Vertex");
}

TEST_F(NibsBids, PulsesWithoutADateKeepTheirTimesSinceTheFirst) {
  Order order = orderOf(madeHead().t1);
  double onset_s = 12.5;
  for (auto& item : order.items) {
    item.clock_s.reset();
    if (item.kind == Kind::pulse) item.onset_s = onset_s++;
  }
  const auto written = writtenFormat("nibs-bids").write_folder(order);
  EXPECT_THAT(written.files.at("sub-P017/nibs/sub-P017_task-tms_run-01_events.tsv"),
              HasSubstr("\n1.000\t0\ttms-61.5\tn/a"));
}

TEST_F(NibsBids, ADataSetBelowTheChosenFolderIsFoundAndTwoAreNotMixed) {
  for (const auto& [suffix, content] : files_) write("a/b/sub-01/nibs/" + (kStem + suffix), content);
  write("a/b/dataset_description.json", "{}");
  write("a/b/sub-01/anat/sub-01_T1w.nii.gz", readWholeFile(made("t1_lpi.nii.gz")));
  EXPECT_EQ(readOther(folder_.path() / "a", nullptr).intended_t1,
            folder_.path() / "a/b/sub-01/anat/sub-01_T1w.nii.gz");
  write("a/c/dataset_description.json", "{}");
  write("a/c/sub-01/nibs/sub-01_task-rest_markers.tsv", files_["markers.tsv"]);
  EXPECT_THAT(refusalOf([&] { readOther(folder_.path() / "a", nullptr); }), HasSubstr("several data sets"));
}

TEST_F(NibsBids, EveryColumnIsDescribedAndEveryIdLeadsSomewhere) {
  const auto written = writtenFormat("nibs-bids").write_folder(orderOf(madeHead().t1));
  int tables = 0;
  for (const auto& [name, content] : written.files) {
    if (name.size() < 4 || name.substr(name.size() - 4) != ".tsv") continue;
    const auto json = nlohmann::json::parse(written.files.at(name.substr(0, name.size() - 4) + ".json"));
    std::istringstream header(content.substr(0, content.find('\n')));
    for (std::string column; std::getline(header, column, '\t');)
      EXPECT_TRUE(json.contains(column) && json[column].contains("Description")) << name << ": " << column;
    ++tables;
  }
  EXPECT_EQ(tables, 7);
  EXPECT_EQ(written.files.at(".bidsignore"), "**/nibs/\n");
}

}  // namespace
}  // namespace facenav::interop
