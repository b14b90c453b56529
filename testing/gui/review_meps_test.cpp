// MEPs in Review: typed, imported by time, measured from a recording, and their map by the electric field.

#include <gmock/gmock.h>

#include <QSettings>
#include <fstream>

#include "facenav/casefile/session_pulses.h"
#include "facenav/efield/coil_file.h"
#include "facenav/treat/mep_by_field.h"
#include "review/field_map_presenter.h"
#include "review/pulse_table.h"
#include "review_fixtures.h"
#include "support/made_xdf.h"

namespace facenav::ui {
namespace {

using namespace review_fixtures;
using ::testing::HasSubstr;

TEST_F(ReviewTest, TheMapByFieldSaysWhatTheCommandSaysAndFollowsTheSession) {
  QSettings().clear();
  ReviewPresenter review(model_);
  FieldMapPresenter map(review, model_);
  review.refresh();
  waitForSession(review);
  EXPECT_EQ(map.words().toStdString(), "") << "off at first";
  map.setOn(true);
  EXPECT_THAT(map.words().toStdString(), HasSubstr("computing"));
  ASSERT_TRUE(fixtures::waitFor([&] { return map.shown() != nullptr; })) << map.words().toStdString();
  const steps::PoseFields fields(std::make_shared<const steps::ReadHead>(model_.current().store),
                                 efield::fieldCoil("figure8-70").dipoles);
  const auto known = steps::mepByField(fields, casefile::readSessionPulses(second_));
  for (const auto& line : steps::inWords(known, "figure8-70"))
    EXPECT_THAT(map.words().toStdString(), HasSubstr(line));
  EXPECT_EQ(map.shown()->r2.size(), review.session()->brain->mesh.vertices_mm.size());
  std::vector<int> numbers;
  for (int number = 1; number <= 30; ++number) numbers.push_back(number);
  review.exclude(numbers, "patient moved", "AB");
  EXPECT_TRUE(fixtures::waitFor([&] { return map.words().contains("too few"); }))
      << map.words().toStdString();
  EXPECT_EQ(map.shown(), nullptr) << "nothing of the old pulses";
  map.setOn(false);
  EXPECT_EQ(map.words().toStdString(), "");
}

TEST_F(ReviewTest, AnMepTypedIntoTheTableIsKeptAndOneThatIsNoNumberIsRefused) {
  ReviewPresenter review(model_);
  QString refused;
  QObject::connect(&review, &ReviewPresenter::refused, [&](const QString& words) { refused = words; });
  review.choose(QString::fromStdString(first_.filename().string()));
  waitForSession(review);
  PulseTable table(review);
  const auto cell = table.index(6, PulseTable::columnOf(report::PulseColumn::mep));
  EXPECT_TRUE(table.flags(cell) & Qt::ItemIsEditable);
  EXPECT_TRUE(table.setData(cell, "412,5", Qt::EditRole));
  ASSERT_TRUE(
      fixtures::waitFor([&] { return review.session()->kept.pulses.pulses[6].pulse.mep_uv == 412.5; }));
  EXPECT_EQ(casefile::readSessionPulses(first_).pulses[6].pulse.mep_uv, 412.5);
  EXPECT_TRUE(review.session()->map) << "computed again";
  table.setData(cell, "big", Qt::EditRole);
  EXPECT_THAT(refused.toStdString(), HasSubstr("'big' is no number"));
  EXPECT_EQ(casefile::readSessionPulses(first_).pulses[6].pulse.mep_uv, 412.5);
}

TEST_F(ReviewTest, MepsAreImportedByTimeAndTheOffsetIsSaid) {
  ReviewPresenter review(model_);
  QString said;
  QObject::connect(&review, &ReviewPresenter::said, [&](const QString& words) { said = words; });
  review.choose(QString::fromStdString(first_.filename().string()));
  waitForSession(review);
  const auto csv = folder_.path() / "emg.csv";
  std::ofstream(csv) << "t_s,mep_uv\n"
                     << 50.14 + 3.0 << ",120\n"  // pulse 1 is given in frame 7
                     << 50.44 + 3.0 << ",130\n";
  review.importMeps(QString::fromStdString(csv.string()), -3.0);
  ASSERT_TRUE(
      fixtures::waitFor([&] { return review.session()->kept.pulses.pulses[0].pulse.mep_uv.has_value(); }));
  EXPECT_EQ(review.session()->kept.pulses.pulses[0].pulse.mep_uv, 120.0);
  EXPECT_THAT(said.toStdString(), HasSubstr("clock offset -3.000 s (given: 2 of 2 rows fit)"));
}

TEST_F(ReviewTest, MepsAreMeasuredFromARecordingAndWhatWasTakenIsSaid) {
  ReviewPresenter review(model_);
  QString said, refused;
  QObject::connect(&review, &ReviewPresenter::said, [&](const QString& words) { said = words; });
  QObject::connect(&review, &ReviewPresenter::refused, [&](const QString& words) { refused = words; });
  review.choose(QString::fromStdString(first_.filename().string()));
  waitForSession(review);
  const auto path = folder_.path() / "emg.xdf";
  std::ofstream(path, std::ios::binary) << testing::twoPulsesXdf(50.14 + 3.0, 50.44 + 3.0);
  const auto file = QString::fromStdString(path.string());
  review.importMeps(file, -3.0, "; Other");
  EXPECT_THAT(refused.toStdString(), HasSubstr("no such markers: Pulses"));
  review.importMeps(file, -3.0);
  ASSERT_TRUE(
      fixtures::waitFor([&] { return review.session()->kept.pulses.pulses[0].pulse.mep_uv.has_value(); }));
  EXPECT_EQ(review.session()->kept.pulses.pulses[0].pulse.mep_uv, 120.0);
  EXPECT_THAT(said.toStdString(), HasSubstr("2 of 2 rows fit"));
  EXPECT_THAT(said.toStdString(), HasSubstr("EMG 'Amplifier', channel 1"));
}

}  // namespace
}  // namespace facenav::ui
