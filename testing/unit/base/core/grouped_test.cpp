#include "facenav/core/grouped.h"

#include <gmock/gmock.h>

namespace facenav {
namespace {

using ::testing::ElementsAre;

TEST(Grouped, BringsItemsTogetherByOwnerInAscendingOrder) {
  const auto grouped = groupedByOwner({{2, 7}, {0, 5}, {2, 3}, {0, 5}, {0, 1}, {2, 7}}, 4);
  EXPECT_THAT(grouped.first, ElementsAre(0, 3, 3, 6, 6));
  EXPECT_THAT(grouped.all, ElementsAre(1, 5, 5, 3, 7, 7));
  const auto once = withoutRepetitions(grouped);
  EXPECT_THAT(once.first, ElementsAre(0, 2, 2, 4, 4));
  EXPECT_THAT(once.all, ElementsAre(1, 5, 3, 7));
}

TEST(Grouped, HoldsNothingOfNothing) {
  EXPECT_THAT(groupedByOwner({}, 0).first, ElementsAre(0));
  EXPECT_TRUE(withoutRepetitions(groupedByOwner({}, 2)).all.empty());
}

}  // namespace
}  // namespace facenav
