#include "facenav/core/child_process.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "support/test_data.h"

namespace facenav {
namespace {

using testing::TemporaryFolder;

ChildOptions silent() {
  ChildOptions options;
  options.output = ChildOptions::Output::nowhere;
  return options;
}

TEST(ChildProcess, RunsWorkThatLeavesFiles) {
  const TemporaryFolder folder;
  const auto end = ChildProcess::run([&] { std::ofstream(folder.path() / "a") << ::getpid(); }).wait();
  EXPECT_TRUE(end.isDone());
  EXPECT_NE(readWholeFile(folder.path() / "a"), std::to_string(::getpid()));
  EXPECT_GT(end.peak_mib, 0);
}

TEST(ChildProcess, TellsWhatItsWorkThrew) {
  const std::string words(100'000, 'w');  // exceeds a pipe's buffer
  const auto end = ChildProcess::run([&] { throw Error(words); }, silent()).wait();
  EXPECT_EQ(end.exit_status, 1);
  EXPECT_EQ(end.failure, words);
}

TEST(ChildProcess, ACrashTakesNothingElseDown) {
  auto options = silent();
  options.may_crash = true;
  const auto end = ChildProcess::run([] { ::raise(SIGSEGV); }, options).wait();
  EXPECT_EQ(end.signal, SIGSEGV);
  EXPECT_EQ(end.exit_status, -1);
  EXPECT_FALSE(end.isDone());
}

TEST(ChildProcess, IsKilledAtItsTimeLimit) {
  auto options = silent();
  options.may_crash = true;
  options.time_limit_s = 1;
  const auto end =
      ChildProcess::run([] { std::this_thread::sleep_for(std::chrono::seconds(60)); }, options).wait();
  EXPECT_EQ(end.signal, SIGALRM);
}

TEST(ChildProcess, NeverOutlivesItsObject) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "late";
  {
    const auto child = ChildProcess::run([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(300));
      std::ofstream(file) << "x";
    });
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(ChildProcess, StartsAnotherProgramWithItsOutputInAPrivateFile) {
  const TemporaryFolder folder;
  ChildOptions options;
  options.output = ChildOptions::Output::file;
  options.output_file = folder.path() / "log";
  const auto end = ChildProcess::start({"sh", "-c", "echo out; echo err >&2; exit 3"}, options).wait();
  EXPECT_EQ(end.exit_status, 3);
  EXPECT_EQ(readWholeFile(options.output_file), "out\nerr\n");
  struct stat status {};
  ASSERT_EQ(::stat(options.output_file.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777u, 0600u);
}

TEST(ChildProcess, SaysWhichProgramIsNotInstalled) {
  try {
    ChildProcess::start({"no-such-program-of-facenav"});
    FAIL() << "started";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("no-such-program-of-facenav"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("No such file"), std::string::npos);
  }
}

TEST(ChildProcess, EndsByTermAndByKillWhereThatIsIgnored) {
  EXPECT_EQ(ChildProcess::start({"sleep", "60"}).end().signal, SIGTERM);
  const TemporaryFolder folder;
  const auto ready = folder.path() / "ready";
  auto stubborn = ChildProcess::start(
      {"sh", "-c", "trap '' TERM; touch " + ready.string() + "; while :; do sleep 0.05; done"});
  while (!std::filesystem::exists(ready)) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(stubborn.end(std::chrono::milliseconds(100)).signal, SIGKILL);
}

TEST(ChildProcess, ManyAtATimeFromManyThreadsEnd) {
  std::vector<std::thread> threads;
  std::atomic<int> done{0};
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&] {
      for (int i = 0; i < 10; ++i) done += ChildProcess::run([] {}, silent()).wait().isDone();
    });
  for (auto& thread : threads) thread.join();
  EXPECT_EQ(done, 40);
}

}  // namespace
}  // namespace facenav
