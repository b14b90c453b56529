#include "facenav/core/json_reader.h"

#include <gtest/gtest.h>

#include "facenav/core/error.h"

namespace facenav {
namespace {

TEST(JsonReader, TakesOnlyNumbersThatCanBeUsed) {
  const auto json =
      JsonReader::readText(R"({"a": 1.5, "b": 1e30, "c": null, "d": [1, -1e30], "e": 1e300})", "t");
  EXPECT_EQ(json.at("a").number(), 1.5);
  for (const char* key : {"b", "c", "e"}) EXPECT_THROW(json.at(key).number(), Error) << key;
  EXPECT_THROW(json.at("d").numbers(2), Error);
  EXPECT_THROW(json.at("b").integer(), Error);
}

}  // namespace
}  // namespace facenav
