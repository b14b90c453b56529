// Many files on all cores: the report does not depend on which core was faster.

#include "bytes/for_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <numeric>
#include <thread>

#include "bytes/file_prefix.h"
#include "facenav/core/error.h"
#include "support/test_data.h"

namespace facenav::testing {
namespace {

TEST(ForFiles, EveryFileIsVisitedOnce) {
  TaskMonitor monitor;
  std::vector<int> visits(1000, 0);
  dicom::forFiles(visits.size(), monitor, "step", [&](std::size_t f, std::size_t) { ++visits[f]; });
  EXPECT_EQ(std::accumulate(visits.begin(), visits.end(), 0), 1000);
  EXPECT_EQ(*std::max_element(visits.begin(), visits.end()), 1);
  dicom::forFiles(0, monitor, "step", [](std::size_t, std::size_t) { FAIL(); });
}

TEST(ForFiles, TheFirstFileThatFailsIsReported) {
  for (int run = 0; run < 20; ++run) {
    TaskMonitor monitor;
    try {
      dicom::forFiles(200, monitor, "step", [](std::size_t f, std::size_t) {
        if (f == 40) std::this_thread::sleep_for(std::chrono::milliseconds(2));  // a slow item
        if (f >= 40) throw Error("fault " + std::to_string(f));
      });
      FAIL() << "no fault was reported";
    } catch (const Error& error) {
      EXPECT_STREQ(error.what(), "fault 40");
    }
  }
}

TEST(ForFiles, CancelStopsWithinAFewFiles) {
  TaskMonitor monitor;
  std::atomic<int> visited{0};
  const auto work = [&](std::size_t, std::size_t) {
    std::this_thread::sleep_for(std::chrono::microseconds(200));
    if (++visited == 100) monitor.cancel();
  };
  EXPECT_THROW(dicom::forFiles(100'000, monitor, "step", work), Cancelled);
  EXPECT_LT(visited, 1000);
}

TEST(FilePrefix, CopyReadsAnywhereWithoutKeepingIt) {
  const TemporaryFolder folder;
  std::string content(100'000, ' ');
  for (std::size_t i = 0; i < content.size(); ++i) content[i] = char(i * 7);
  std::ofstream(folder.path() / "a", std::ios::binary) << content;
  dicom::FilePrefix file(folder.path() / "a");
  ASSERT_TRUE(file.ensure(10));
  const std::size_t kept = file.bytes().size();
  for (const auto& [offset, length] :
       {std::pair<std::size_t, std::size_t>{0, 10}, {5, 50'000}, {90'000, 10'000}}) {
    std::string copy(length, '\0');
    EXPECT_TRUE(file.copy(offset, length, copy.data()));
    EXPECT_EQ(copy, content.substr(offset, length));
  }
  char byte;
  EXPECT_FALSE(file.copy(100'000, 1, &byte));
  EXPECT_FALSE(file.copy(~std::uint64_t(0), 2, &byte));
  EXPECT_EQ(file.bytes().size(), kept);
}

}  // namespace
}  // namespace facenav::testing
