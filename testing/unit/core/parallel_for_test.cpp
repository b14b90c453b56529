#include "facenav/core/parallel_for.h"

#include <gtest/gtest.h>

#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
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
        if (item == 40) std::this_thread::sleep_for(std::chrono::milliseconds(2));  // the slower one
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

}  // namespace
}  // namespace facenav
