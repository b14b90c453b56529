#include "facenav/scene/display.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace facenav::scene {
namespace {

TEST(Display, OffersWhatTheScenesNeed) {
  if (!hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  EXPECT_EQ(openGlProblem(), "");
  EXPECT_TRUE(canDrawScenes());
}

/// In a process of its own: Mesa reads the version once.
TEST(DisplayDeathTest, AnOldOpenGlIsNamedInOneLine) {
  if (!hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  for (const char* version : {"2.1", "3.1"})
    EXPECT_EXIT(
        {
          ::setenv("MESA_GL_VERSION_OVERRIDE", version, 1);
          const std::string problem = openGlProblem();
          std::fprintf(stderr, "%s\n", problem.c_str());
          std::exit(canDrawScenes() ? 0 : 1);
        },
        ::testing::ExitedWithCode(1), "^this display offers no OpenGL 3.2[^\n]*\n$");
}

}  // namespace
}  // namespace facenav::scene
