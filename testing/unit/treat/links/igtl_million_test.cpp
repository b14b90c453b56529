#include <gtest/gtest.h>

#include "support/igtl_mutations.h"

namespace facenav::links {
namespace {

TEST(IgtlReaderAtLength, AMillionDamagedMessagesDoNoHarm) {
  const auto found = testing::readMutations(1000000, 4747);
  EXPECT_GT(found.messages, 200000);
  EXPECT_GT(found.contents, 50000);
  EXPECT_LT(found.most_held, 4096u + kIgtlHeaderSize + 200);
}

}  // namespace
}  // namespace facenav::links
