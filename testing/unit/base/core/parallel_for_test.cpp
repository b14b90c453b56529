#include "facenav/core/parallel_for.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace facenav {
namespace {

TEST(ParallelFor, EveryItemIsWorkedOnOnceByAWorkerOfItsOwn) {
  for (const std::size_t count : {0u, 1u, 2u, 1000u})
    for (const std::size_t workers : {1u, 2u, 7u}) {
      std::vector<std::atomic<int>> visits(count);
      std::vector<std::atomic<int>> busy(workers);
      parallelFor(count, workers, [&](std::size_t item, std::size_t worker) {
        ASSERT_LT(worker, workers);
        EXPECT_EQ(++busy[worker], 1) << "two threads under one number";
        ++visits[item];
        --busy[worker];
      });
      for (const auto& v : visits) EXPECT_EQ(v, 1);
    }
}

TEST(ParallelFor, WorkerZeroIsTheCaller) {
  const auto caller = std::this_thread::get_id();
  parallelFor(200, 4, [&](std::size_t, std::size_t worker) {
    EXPECT_TRUE(worker > 0 || std::this_thread::get_id() == caller);
  });
}

TEST(ParallelFor, TheFirstItemThatFailsIsReported) {
  for (int run = 0; run < 20; ++run) try {
      parallelFor(200, 4, [](std::size_t item, std::size_t) {
        if (item == 40) std::this_thread::sleep_for(std::chrono::milliseconds(2));  // slower than the others
        if (item >= 40) throw std::runtime_error("fault " + std::to_string(item));
      });
      FAIL() << "no fault was reported";
    } catch (const std::runtime_error& fault) {
      EXPECT_STREQ(fault.what(), "fault 40");
    }
}

TEST(ParallelFor, NothingIsBegunAfterAFault) {
  std::atomic<int> begun{0};
  const auto work = [&](std::size_t item, std::size_t) {
    ++begun;
    if (item == 10) throw std::runtime_error("fault");
    std::this_thread::sleep_for(std::chrono::microseconds(100));
  };
  EXPECT_THROW(parallelFor(100'000, 3, work), std::runtime_error);
  EXPECT_LT(begun, 1000);
}

TEST(ParallelFor, LoopsWithinLoopsAndBesideEachOtherEnd) {
  std::atomic<int> inner{0};
  const auto loops = [&] {
    parallelFor(8, 4, [&](std::size_t, std::size_t) {
      parallelFor(50, 4, [&](std::size_t, std::size_t) { ++inner; });
    });
  };
  std::thread beside(loops);
  loops();
  beside.join();
  EXPECT_EQ(inner, 2 * 8 * 50);
}

TEST(ParallelRanges, CoverEachItemOnce) {
  for (const int count : {0, 1, 2, 7, 100}) {
    std::vector<std::atomic<int>> met(std::size_t(count) + 20);
    parallelRanges(5, 5 + count, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) ++met[std::size_t(i)];
    });
    for (int i = 0; i < count + 20; ++i) EXPECT_EQ(met[std::size_t(i)], i >= 5 && i < 5 + count ? 1 : 0) << i;
  }
}

TEST(ParallelRanges, RunOnTheCallersThreadWhereOneCoreIsAskedFor) {
  const OneCoreOnly one_core;
  EXPECT_EQ(coreCount(), 1u);
  int calls = 0;
  std::set<std::thread::id> threads;
  parallelRanges(0, 100, [&](int begin, int end) {
    ++calls;
    threads.insert(std::this_thread::get_id());
    EXPECT_EQ(end - begin, 100);
  });
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(threads, std::set<std::thread::id>{std::this_thread::get_id()});
}

TEST(ParallelRanges, ThrowWhatAnItemThrew) {
  EXPECT_THROW(parallelRanges(0, 50,
                              [](int, int end) {
                                if (end == 50) throw std::runtime_error("last");
                              }),
               std::runtime_error);
}

TEST(ParallelFor, BackgroundWorkStaysInTheBackground) {
  constexpr int kNicer = 5;
  const int own = ::getpriority(PRIO_PROCESS, 0);
  if (own + kNicer > 19) GTEST_SKIP() << "runs at the lowest priority already";
  const auto niceValues = [](std::size_t workers) {  // lowest and highest nice value of the workers
    std::pair<int, int> met{100, -100};
    std::mutex mutex;
    parallelFor(workers * 20, workers, [&](std::size_t, std::size_t) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      const int nice = ::getpriority(PRIO_PROCESS, 0);
      const std::lock_guard<std::mutex> lock(mutex);
      met = {std::min(met.first, nice), std::max(met.second, nice)};
    });
    return met;
  };
  std::pair<int, int> background;
  std::thread nicer([&] {
    ASSERT_EQ(::setpriority(PRIO_PROCESS, 0, own + kNicer), 0);
    background = niceValues(4);
  });
  nicer.join();
  EXPECT_EQ(background, std::make_pair(own + kNicer, own + kNicer));
  EXPECT_EQ(niceValues(4), std::make_pair(own, own)) << "nor do the shared threads keep it";
}

}  // namespace
}  // namespace facenav
