#include "facenav/core/latest_value.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace facenav {
namespace {

using namespace std::chrono_literals;

TEST(LatestValue, KeepsTheNewestAndCountsWhatNobodyTook) {
  LatestValue<int> value;
  EXPECT_EQ(value.latest(), nullptr);
  value.publish(std::make_shared<int>(1));
  value.publish(std::make_shared<int>(2));
  EXPECT_EQ(*value.latest(), 2);
  EXPECT_EQ(value.dropped(), 1u);
  EXPECT_EQ(*value.take(0ms), 2);
  EXPECT_EQ(value.take(1ms), nullptr);  // taken once
  EXPECT_EQ(*value.latest(), 2);        // latest() does not take it
}

TEST(LatestValue, ManyMayWaitForANewerOneAndNobodyTakesIt) {
  LatestValue<int> value;
  EXPECT_EQ(value.newerThan(nullptr, 1ms), nullptr);
  std::thread publisher([&] { value.publish(std::make_shared<int>(7)); });
  const auto first = value.newerThan(nullptr, 10s);
  publisher.join();
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(*first, 7);
  EXPECT_EQ(value.newerThan(nullptr, 0ms), first) << "for another one it is new";
  EXPECT_EQ(value.newerThan(first, 1ms), nullptr);
  EXPECT_EQ(value.take(0ms), first);
}

TEST(LatestValue, CloseWakesTheWaiter) {
  LatestValue<int> value;
  std::thread closer([&] { value.close(); });
  EXPECT_EQ(value.take(10s), nullptr);
  closer.join();
  EXPECT_TRUE(value.isClosed());
}

TEST(LatestValue, TakenAndDroppedAccountForAllPublishedAcrossThreads) {
  constexpr int kCount = 20000;
  LatestValue<int> value;
  std::vector<int> taken;
  std::thread reader([&] {
    while (const auto next = value.take(10s)) taken.push_back(*next);
  });
  for (int i = 0; i < kCount; ++i) value.publish(std::make_shared<int>(i));
  value.close();  // an untaken value can still be taken
  reader.join();
  EXPECT_EQ(taken.size() + value.dropped(), std::size_t(kCount));
  for (std::size_t i = 1; i < taken.size(); ++i) EXPECT_LT(taken[i - 1], taken[i]);  // never an older value
  EXPECT_EQ(taken.back(), kCount - 1);
}

}  // namespace
}  // namespace facenav
