#include "facenav/casefile/protocol.h"

#include <gmock/gmock.h>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "support/test_data.h"

namespace facenav::casefile {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

Protocol tenHertz() {
  Protocol protocol;
  protocol.name = "M1 10 Hz";
  protocol.version = 2;
  protocol.dose.pulses = 3000;
  protocol.dose.trains = 60;
  protocol.dose.frequency_hz = 10;
  protocol.dose.pause_s = 25.5;
  protocol.dose.threshold_pct = 80;
  protocol.sessions = 15;
  protocol.note = "hand area";
  return protocol;
}

std::string refusalOf(const std::string& json) {
  const facenav::testing::TemporaryFolder folder;
  writeWholeFile(folder.path() / "p.json", json);
  try {
    readProtocol(folder.path() / "p.json");
  } catch (const Error& error) {
    return error.what();
  }
  return "read";
}

TEST(Protocol, IsReadBackAsItWasWritten) {
  const facenav::testing::TemporaryFolder folder;
  writeProtocol(tenHertz(), folder.path() / "p.json");
  const Protocol read = readProtocol(folder.path() / "p.json");
  EXPECT_EQ(read, tenHertz());
  EXPECT_FALSE(read.dose.output_pct) << "what is not stated stays unstated";
}

TEST(Protocol, TheTemplateIsAProtocolThatNoCaseTakesUnchanged) {
  const facenav::testing::TemporaryFolder folder;
  const auto path = folder.path() / "p.json";
  writeProtocolTemplate(path);
  Protocol protocol = readProtocol(path);
  EXPECT_TRUE(protocol.dose.output_pct && protocol.dose.threshold_pct && protocol.sessions);
  EXPECT_THROW(setProtocol(folder.path(), protocol), Error);
  EXPECT_THROW(writeProtocolTemplate(path), Error) << "nothing is overwritten";
  protocol.name = "ours";
  EXPECT_NO_THROW(setProtocol(folder.path(), protocol));
}

TEST(Protocol, RefusesNamesWithControlCharactersAndEndlessOnes) {
  EXPECT_THAT(refusalOf(R"({"name": "a\u001b[2J", "version": 1, "pulses": 20})"), HasSubstr("control"));
  EXPECT_THAT(refusalOf(R"({"name": ")" + std::string(500, 'x') + R"(", "version": 1, "pulses": 20})"),
              HasSubstr("longer"));
}

TEST(Protocol, NeedsNameVersionAndPulsesAlone) {
  EXPECT_EQ(refusalOf(R"({"name": "single", "version": 1, "pulses": 20})"), "read");
  EXPECT_THAT(refusalOf(R"({"version": 1, "pulses": 20})"), HasSubstr("name"));
  EXPECT_THAT(refusalOf(R"({"name": "a", "pulses": 20})"), HasSubstr("version"));
  EXPECT_THAT(refusalOf(R"({"name": "a", "version": 1})"), HasSubstr("pulses"));
}

TEST(Protocol, RefusesNumbersThatNoStimulatorGives) {
  const auto with = [](const std::string& member) {
    return refusalOf(R"({"name": "a", "version": 1, "pulses": 100, )" + member + "}");
  };
  EXPECT_THAT(with(R"("frequency_hz": 1000)"), HasSubstr("frequency_hz is 1000"));
  EXPECT_THAT(with(R"("output_pct": 101)"), HasSubstr("output_pct"));
  EXPECT_THAT(with(R"("trains": 101)"), HasSubstr("trains"));
  EXPECT_THAT(with(R"("pause_s": -1)"), HasSubstr("pause_s"));
  EXPECT_THAT(with(R"("threshold_pct": "80")"), HasSubstr("number"));
}

TEST(Protocol, LastsAsLongAsItsTrainsAndPauses) {
  // 60 trains of 50 pulses at 10 Hz: 49 gaps of 0.1 s each, and 59 pauses of 25.5 s.
  EXPECT_NEAR(*tenHertz().dose.duration_s(), 60 * 4.9 + 59 * 25.5, 1e-9);
  EXPECT_EQ(tenHertz().dose.pulsesInTrain(), 50);
  guidance::Dose uneven;
  uneven.pulses = 10;
  uneven.trains = 4;  // 3 + 3 + 3 + 1
  uneven.frequency_hz = 1;
  uneven.pause_s = 10;
  EXPECT_NEAR(*uneven.duration_s(), 2 + 2 + 2 + 0 + 3 * 10, 1e-9);
  uneven.frequency_hz = 0;
  EXPECT_FALSE(uneven.duration_s());
}

TEST(CaseProtocol, StaysWithTheCaseAndOnlyItsOwnerReadsIt) {
  const facenav::testing::TemporaryFolder folder;
  EXPECT_FALSE(protocolOf(folder.path()));
  setProtocol(folder.path(), tenHertz());
  EXPECT_EQ(*protocolOf(folder.path()), tenHertz());
  EXPECT_EQ(fs::status(folder.path() / "protocol.json").permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
  removeProtocol(folder.path());
  EXPECT_FALSE(protocolOf(folder.path()));
  removeProtocol(folder.path());  // nothing to remove is no error
}

TEST(CaseProtocol, OtherNumbersNeedAnotherVersion) {
  const facenav::testing::TemporaryFolder folder;
  setProtocol(folder.path(), tenHertz());
  Protocol changed = tenHertz();
  changed.dose.pulses = 2000;
  EXPECT_THROW(setProtocol(folder.path(), changed), Error);
  EXPECT_EQ(protocolOf(folder.path())->dose.pulses, 3000);
  changed.version = 3;
  setProtocol(folder.path(), changed);
  EXPECT_EQ(protocolOf(folder.path())->dose.pulses, 2000);
}

}  // namespace
}  // namespace facenav::casefile
