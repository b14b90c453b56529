#include "facenav/core/registry.h"

#include <gmock/gmock.h>

namespace facenav {
namespace {

struct Shape {
  virtual ~Shape() = default;
  virtual int corners() const = 0;
};
template <int N>
struct Polygon : Shape {
  int corners() const override { return N; }
};

Registry<Shape> shapes() {
  Registry<Shape> registry("shape");
  registry.add("triangle", "three corners", [] { return std::make_unique<Polygon<3>>(); });
  registry.add("square", "four corners", [] { return std::make_unique<Polygon<4>>(); });
  return registry;
}

TEST(Registry, MakesWhatItsNameSays) {
  EXPECT_EQ(shapes().create("triangle")->corners(), 3);
  EXPECT_EQ(shapes().create("square")->corners(), 4);
}

TEST(Registry, FirstEntryIsTheDefault) { EXPECT_EQ(shapes().defaultName(), "triangle"); }

TEST(Registry, UnknownNameIsAnErrorThatListsTheKnownOnes) {
  try {
    shapes().create("circle");
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), ::testing::AllOf(::testing::HasSubstr("unknown shape 'circle'"),
                                               ::testing::HasSubstr("triangle, square")));
  }
}

TEST(Registry, EmptyOneHasNoDefault) {
  EXPECT_THROW(Registry<Shape>("shape").defaultName(), std::logic_error);
}

}  // namespace
}  // namespace facenav
