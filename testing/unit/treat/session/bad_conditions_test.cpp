// A session while the disk is full, its folder is removed, and the clock is set back: each is reported, the
// session continues, and every pulse is stored once.

#include <gmock/gmock.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "facenav/casefile/kept_session.h"
#include "facenav/casefile/poses_csv.h"
#include "facenav/core/csv_table.h"
#include "facenav/session/treatment_log.h"
#include "session_fakes.h"
#include "support/test_data.h"

namespace facenav::session {
namespace {

namespace fs = std::filesystem;

std::shared_ptr<Session> endless() {
  const RigidTransform<Camera, Marker> marker(Eigen::Quaterniond::Identity(), {0, 0, 500});
  auto navigator =
      std::make_unique<Navigator>(fakes::setup(), std::make_unique<fakes::Head>([](std::int64_t) {
                                    return std::optional(RigidTransform<Camera, Head>());
                                  }),
                                  std::make_unique<fakes::Coil>(marker));
  navigator->setTarget(fakes::targetAt(marker.reframe<Camera, Coil>()));
  return std::make_shared<Session>(std::make_unique<fakes::Source>(1000000, 0.005), std::move(navigator),
                                   SessionOptions{});
}

template <class Condition>
bool comes(Condition condition) {
  for (int i = 0; i < 10000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

void addPulses(TreatmentLog& log, int count) {
  for (int i = 0; i < count; ++i) {
    links::PulseTrigger pulse;
    pulse.source = "train";
    pulse.dead_time_s = 0.001;
    log.addPulse(pulse);
    std::this_thread::sleep_for(std::chrono::milliseconds(8));
  }
}

/// Fault of a session that must contain `pulses` pulses, each once; empty if there is none.
std::string faultOf(const fs::path& session, int pulses, const char* event) {
  const auto kept = casefile::readSession(session);
  if (!kept.pulses.problems.empty()) return kept.pulses.problems.front();
  if (int(kept.pulses.pulses.size()) != pulses)
    return std::to_string(kept.pulses.pulses.size()) + " pulses are kept";
  double last_s = 0;
  int number = 0;
  for (const auto& reviewed : kept.pulses.pulses) {
    if (reviewed.pulse.number != ++number || reviewed.pulse.steady_s <= last_s)
      return "pulses are out of order";
    last_s = reviewed.pulse.steady_s;
  }
  bool is_said = false, has_ended = false;
  for (const auto& e : kept.events) {
    is_said |= e.event == event;
    has_ended |= e.event == "session ended";
  }
  if (!is_said) return std::string("there is no event ") + event;
  if (!has_ended) return "the end is missing";
  const CsvTable guidance(session / "guidance.csv");  // refuses a torn line
  const auto poses = casefile::readPoses(session / "poses.csv");
  return guidance.rows() > 5 && poses.size() > 10 ? "" : "there are few frames";
}

/// Fills the disk for a while. Returns the fault in words, or nothing.
std::string fillDisk(const fs::path& disk) {
  fs::create_directories(disk / "case");
  fs::path place;
  {
    auto running = endless();
    TreatmentLog log(running, disk / "case");
    place = log.folder();
    running->start();
    addPulses(log, 5);
    if (!comes([&] { return log.pulses() == 5; })) return "the first pulses are not kept";
    {
      std::ofstream ballast(disk / "ballast");
      const std::string block(4096, 'x');
      while (ballast.write(block.data(), std::streamsize(block.size())).flush()) {
      }
    }
    if (!comes([&] { return !log.failure().empty(); })) return "a full disk is not said";
    const std::string said = log.failure();
    addPulses(log, 5);
    const auto frame = running->latest()->frame;
    if (!comes([&] { return running->latest()->frame > frame; })) return "tracking stopped";
    if (log.counts().on_target + log.counts().lost + log.counts().outside < 9)
      return "pulses are not counted";
    fs::remove(disk / "ballast");
    if (!comes([&] { return log.failure().empty(); })) return "it is not tried again";
    addPulses(log, 5);
    if (!comes([&] { return log.pulses() == 15; })) return "pulses are missing";
    if (said.find("space") == std::string::npos) return "said was only: " + said;
    running->stop();
  }
  return faultOf(place, 15, "log resumed");
}

/// Enters a user namespace, in which any user can mount. Returns false if that is not allowed.
bool hasOwnUsers() {
  const std::string user = std::to_string(::getuid()), group = std::to_string(::getgid());
  if (::unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) return false;
  const auto tell = [](const char* file, const std::string& words) {
    std::ofstream stream(file);
    stream << words;
    return bool(stream.flush());
  };
  return tell("/proc/self/setgroups", "deny") && tell("/proc/self/uid_map", "0 " + user + " 1") &&
         tell("/proc/self/gid_map", "0 " + group + " 1");
}

/// Runs in a child process that alone sees a small disk. Returns "skip: .." if that is not allowed.
std::string onSmallDisk(const fs::path& folder) {
  int ends[2];
  if (::pipe(ends) != 0) return "skip: no pipe";
  const pid_t child = ::fork();
  if (child == 0) {
    std::string words;
    const bool has_own = ::unshare(CLONE_NEWNS) == 0 || hasOwnUsers();
    ::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr);
    if (!has_own || ::mount("tmpfs", folder.c_str(), "tmpfs", 0, "size=512k,mode=700") != 0) {
      words = "skip: this user may make no small disk";
    } else {
      try {
        words = fillDisk(folder);
      } catch (const std::exception& error) {
        words = error.what();
      }
    }
    (void)!::write(ends[1], words.data(), words.size());
    ::_exit(0);
  }
  ::close(ends[1]);
  std::string words;
  char block[256];
  for (ssize_t got; (got = ::read(ends[0], block, sizeof block)) > 0;) words.append(block, std::size_t(got));
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  return status == 0 ? words : "the child died";
}

TEST(BadConditions, AFullDiskIsSaidAndNoPulseIsLostOrDoubled) {
  const testing::TemporaryFolder folder;
  const std::string words = onSmallDisk(folder.path());
  if (words.rfind("skip", 0) == 0) GTEST_SKIP() << words;
  EXPECT_EQ(words, "");
}

TEST(BadConditions, AFolderThatIsRemovedIsMadeAgainWithAllThatItHeld) {
  const testing::TemporaryFolder folder;
  fs::path place;
  {
    auto running = endless();
    TreatmentLog log(running, folder.path());
    place = log.folder();
    running->start();
    addPulses(log, 5);
    ASSERT_TRUE(comes([&] { return log.pulses() == 5; }));
    fakes::removeAll(place);
    EXPECT_TRUE(comes([&] { return log.failure().find("removed") != std::string::npos; })) << log.failure();
    addPulses(log, 5);
    EXPECT_TRUE(comes([&] { return log.failure().empty(); })) << log.failure();
    addPulses(log, 5);
    EXPECT_TRUE(comes([&] { return log.pulses() == 15; }));
    running->stop();
  }
  EXPECT_EQ(faultOf(place, 15, "log resumed"), "");
  const auto kept = casefile::readSession(place);
  EXPECT_EQ(kept.events.front().event, "session started") << "what was logged before is there";
  for (const auto& entry : fs::recursive_directory_iterator(folder.path()))
    EXPECT_EQ(entry.status().permissions() & (fs::perms::group_all | fs::perms::others_all), fs::perms::none)
        << entry.path();
}

TEST(BadConditions, AClockThatIsSetBackIsSaidAndTheOrderStays) {
  const testing::TemporaryFolder folder;
  fs::path place;
  std::atomic<int> set_back_s{0}, asked{0};
  {
    auto running = endless();
    TreatmentLogOptions options;
    options.clock = [&] {
      ++asked;
      return std::chrono::system_clock::now() - std::chrono::seconds(set_back_s);
    };
    TreatmentLog log(running, folder.path(), nullptr, options);
    place = log.folder();
    running->start();
    addPulses(log, 3);
    ASSERT_TRUE(comes([&] { return asked > 0; })) << "the clock is known before it is set";
    set_back_s = 3600;
    const int asked_before = asked;
    for (int i = 0; i < 3; ++i) {
      links::PulseTrigger pulse;
      pulse.dead_time_s = 0.001;
      pulse.utc -= std::chrono::hours(1);
      log.addPulse(pulse);
      std::this_thread::sleep_for(std::chrono::milliseconds(8));
    }
    EXPECT_TRUE(comes([&] { return log.pulses() == 6; }));
    EXPECT_EQ(log.failure(), "");
    // The first answer after the change is logged before the second is asked for.
    EXPECT_TRUE(comes([&] { return asked >= asked_before + 2 && running->latest()->frame > 20; }));
    running->stop();
  }
  EXPECT_EQ(faultOf(place, 6, "clock set"), "");
  std::string said;
  for (const auto& e : casefile::readSession(place).events)
    if (e.event == "clock set") said += e.detail;
  EXPECT_THAT(said, ::testing::HasSubstr("set back by 3600.0 s"));
}

}  // namespace
}  // namespace facenav::session
