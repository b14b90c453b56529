#include "facenav/review/review_editor.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "facenav/casefile/pulse_file.h"
#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "support/test_data.h"
#include "unit/case/casefile/made_pulse.h"

namespace facenav::steps {
namespace {

class ReviewEditorTest : public ::testing::Test {
 protected:
  ReviewEditorTest() {
    casefile::PulseFile file(folder_.path());
    for (int i = 1; i <= 4; ++i) {
      auto pulse = casefile::madePulse(i);
      if (i == 2) pulse.mep_uv = 80.0, pulse.latency_ms = 22.0;
      file.keep(pulse);
    }
    editor_.open(folder_.path());
  }
  std::string excluded() const {
    std::string words;
    for (const auto& reviewed : casefile::readSessionPulses(folder_.path()).pulses)
      if (reviewed.is_excluded) words += std::to_string(reviewed.pulse.number) + reviewed.note + " ";
    return words;
  }
  casefile::Pulse second() const { return casefile::readSessionPulses(folder_.path()).pulses[1].pulse; }
  testing::TemporaryFolder folder_;
  ReviewEditor editor_;
};

TEST_F(ReviewEditorTest, EveryChangeCanBeTakenBackAndMadeAgain) {
  editor_.exclude({1, 3}, "moved", "AB");
  EXPECT_EQ(editor_.undoWords(), "exclude 2 pulses");
  editor_.include({3}, "AB");
  EXPECT_EQ(excluded(), "1moved ");
  editor_.undo();
  EXPECT_EQ(excluded(), "1moved 3moved ") << "with its reason";
  editor_.undo();
  EXPECT_EQ(excluded(), "");
  EXPECT_FALSE(editor_.canUndo());
  editor_.redo();
  editor_.redo();
  EXPECT_EQ(excluded(), "1moved ");
  EXPECT_FALSE(editor_.canRedo());
}

TEST_F(ReviewEditorTest, AnMepThatIsTakenBackIsTheOneFromBefore) {
  editor_.setMeps({{2, 400.0, {}, "typed", ""}, {4, 50.0, {}, "typed", ""}});
  EXPECT_EQ(second().mep_uv, 400.0);
  editor_.undo();
  EXPECT_EQ(second().mep_uv, 80.0);
  EXPECT_EQ(second().latency_ms, 22.0);
  EXPECT_FALSE(casefile::readSessionPulses(folder_.path()).pulses[3].pulse.mep_uv);
}

TEST_F(ReviewEditorTest, WhatCannotBeWrittenIsNoStep) {
  EXPECT_THROW(editor_.exclude({1, 9}, "moved", ""), Error);
  EXPECT_THROW(editor_.exclude({1}, " ", ""), Error);
  EXPECT_FALSE(editor_.canUndo());
  EXPECT_EQ(excluded(), "");
}

TEST_F(ReviewEditorTest, ANewChangeForgetsWhatWasUndoneAndTheFileKeepsAll) {
  editor_.exclude({1}, "first", "");
  editor_.undo();
  editor_.exclude({2}, "second", "");
  EXPECT_FALSE(editor_.canRedo());
  const std::string history = readWholeFile(folder_.path() / "pulse_edits.jsonl");
  EXPECT_EQ(std::count(history.begin(), history.end(), '\n'), 3);
}

}  // namespace
}  // namespace facenav::steps
