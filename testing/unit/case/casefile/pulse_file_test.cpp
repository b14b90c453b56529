#include "facenav/casefile/pulse_file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <random>

#include "facenav/casefile/session_pulses.h"
#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "made_pulse.h"
#include "support/matchers.h"
#include "support/test_data.h"

namespace facenav::casefile {
namespace {

namespace fs = std::filesystem;
using facenav::testing::PoseNear;
using facenav::testing::TemporaryFolder;
using ::testing::HasSubstr;

std::vector<int> numbersIn(const fs::path& folder) {
  std::vector<int> numbers;
  for (const auto& reviewed : readSessionPulses(folder).pulses) numbers.push_back(reviewed.pulse.number);
  return numbers;
}

TEST(PulseFile, EveryFieldComesBackAsItWas) {
  const TemporaryFolder folder;
  Pulse pulse = madePulse(1, 3.5);
  pulse.gap_mm = 2.25, pulse.mep_uv = 120, pulse.latency_ms = 22.5, pulse.e_target_v_per_m = 91;
  PulseFile file(folder.path());
  file.keep(pulse);
  file.keep(madeLostPulse(2));
  const auto read = readSessionPulses(folder.path());
  EXPECT_TRUE(read.problems.empty());
  ASSERT_EQ(read.pulses.size(), 2u);
  Pulse back = read.pulses[0].pulse;
  ASSERT_TRUE(back.camera_T_mri && back.camera_T_coil && back.target);
  EXPECT_THAT(*back.camera_T_mri, PoseNear(*pulse.camera_T_mri, 1e-9, 1e-9));
  EXPECT_THAT(*back.camera_T_coil, PoseNear(*pulse.camera_T_coil, 1e-9, 1e-9));
  EXPECT_THAT(back.target->mri_T_target, PoseNear(pulse.target->mri_T_target, 1e-9, 1e-9));
  back.camera_T_mri = pulse.camera_T_mri;  // rotations are made orthonormal again: the last digit may differ
  back.camera_T_coil = pulse.camera_T_coil;
  back.target->mri_T_target = pulse.target->mri_T_target;
  EXPECT_EQ(toJsonLine(back), toJsonLine(pulse));
  EXPECT_DOUBLE_EQ(*back.latency_ms, 22.5);
  EXPECT_EQ(toJsonLine(read.pulses[1].pulse), toJsonLine(madeLostPulse(2)));
  EXPECT_FALSE(read.pulses[1].pulse.mri_T_coil());
  const auto all = fs::status(folder.path() / "pulses.jsonl").permissions();
  EXPECT_EQ(all, fs::perms::owner_read | fs::perms::owner_write);
}

TEST(PulseFile, NeverWritesOverAnotherSessionsPulses) {
  const TemporaryFolder folder;
  PulseFile(folder.path()).keep(madePulse(1));
  EXPECT_THROW(PulseFile{folder.path()}, Error);
  EXPECT_EQ(numbersIn(folder.path()), (std::vector<int>{1}));
}

TEST(PulseFile, ALineThatWasCutShortIsLeftOutAndSaid) {
  const TemporaryFolder folder;
  PulseFile(folder.path()).keep(madePulse(1));
  std::ofstream(folder.path() / "pulses.jsonl", std::ios::app) << toJsonLine(madePulse(2)).substr(0, 200);
  const auto read = readSessionPulses(folder.path());
  EXPECT_EQ(read.pulses.size(), 1u);
  ASSERT_EQ(read.problems.size(), 1u);
  EXPECT_THAT(read.problems[0], HasSubstr("line 2"));
  EXPECT_THAT(read.problems[0], HasSubstr("cut short"));
}

TEST(PulseFile, ADamagedLineLeavesTheOthersAndTheSameNumberCountsOnce) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "pulses.jsonl")
      << toJsonLine(madePulse(1)) << std::string(60, '\0') << "\n{\"pulse\":2}\n"
      << toJsonLine(madePulse(3)) << toJsonLine(madePulse(3));
  const auto read = readSessionPulses(folder.path());
  EXPECT_EQ(numbersIn(folder.path()), (std::vector<int>{1, 3}));
  ASSERT_EQ(read.problems.size(), 2u);
  EXPECT_THAT(read.problems[0], HasSubstr("line 2"));
  EXPECT_THAT(read.problems[1], HasSubstr("line 3"));
}

TEST(PulseFile, AFolderThatWasRemovedIsMadeAgainWithEveryPulse) {
  const TemporaryFolder folder;
  const fs::path session = folder.path() / "sessions/20261123T140509Z";
  fs::create_directories(session);
  PulseFile file(session);
  file.keep(madePulse(1));
  file.keep(madePulse(2));
  fs::remove_all(folder.path() / "sessions");
  file.keep(madePulse(3));
  EXPECT_EQ(numbersIn(session), (std::vector<int>{1, 2, 3}));
}

/// The limit on a file's size simulates a full disk: both refuse the part of a line that does not fit.
TEST(PulseFile, AFullDiskIsSaidAndLeavesWholeLines) {
  const TemporaryFolder folder;
  PulseFile file(folder.path());
  file.keep(madePulse(1));
  const auto size = fs::file_size(folder.path() / "pulses.jsonl");
  const auto ignored = ::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const rlimit full{rlim_t(size + 100), before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &full), 0);
  std::string said;
  try {
    file.keep(madePulse(2));
  } catch (const Error& error) {
    said = error.what();
  }
  ::setrlimit(RLIMIT_FSIZE, &before);
  ::signal(SIGXFSZ, ignored);
  EXPECT_THAT(said, HasSubstr("pulses.jsonl"));
  EXPECT_EQ(fs::file_size(folder.path() / "pulses.jsonl"), size) << "a part of the line is left";
  file.keep(madePulse(2));  // there is room again
  EXPECT_EQ(numbersIn(folder.path()), (std::vector<int>{1, 2}));
  EXPECT_TRUE(readSessionPulses(folder.path()).problems.empty());
}

/// Stores pulses in an endless loop, and reports each number once it is stored.
[[noreturn]] void keepPulses(const fs::path& folder, int said) {
  PulseFile file(folder);
  for (int number = 1;; ++number) {
    file.keep(madePulse(number));
    if (::write(said, &number, sizeof number) != sizeof number) ::_exit(1);
  }
}

TEST(PulseFile, ADeathAtAnyMomentLosesNoKeptPulseAndDoublesNone) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> moment_us(2000, 60000);
  int kept_in_all = 0;
  for (int death = 0; death < 20; ++death) {
    const TemporaryFolder folder;
    int said[2];
    ASSERT_EQ(::pipe(said), 0);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) keepPulses(folder.path(), said[1]);
    ::close(said[1]);
    ::usleep(useconds_t(moment_us(random)));
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
    int kept = 0;
    for (int number = 0; ::read(said[0], &number, sizeof number) == sizeof number;) kept = number;
    ::close(said[0]);
    const auto numbers = numbersIn(folder.path());
    ASSERT_GE(int(numbers.size()), kept);
    ASSERT_LE(int(numbers.size()), kept + 1) << "at most one was written but not yet said";
    for (std::size_t i = 0; i < numbers.size(); ++i) ASSERT_EQ(numbers[i], int(i) + 1);
    kept_in_all += kept;
  }
  EXPECT_GT(kept_in_all, 20) << "the deaths came before any pulse";
}

}  // namespace
}  // namespace facenav::casefile
