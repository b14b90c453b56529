#include "facenav/editing/mask_editor.h"

#include <gtest/gtest.h>

#include <mutex>
#include <random>

#include "facenav/core/error.h"
#include "facenav/editing/brush.h"
#include "facenav/editing/mask_autosave.h"
#include "made_masks.h"

namespace facenav::editing {
namespace {

using testing::ballMask;
using testing::obliqueGrid;
using volume::Mask;

Mask startMask() {
  const auto grid = obliqueGrid();
  return ballMask(grid, grid.centre(), 15);
}

MaskChange dab(const MaskEditor& editor, std::mt19937& random) {
  const auto& grid = editor.mask().grid;
  const auto place = grid.toMri({double(random() % 60), double(random() % 56), double(random() % 52)});
  return paint(editor.mask(), {place, place}, {1.0 + double(random() % 6), {}}, random() % 2 == 0);
}

TEST(MaskChange, PacksAndUnpacksToTheSameVoxels) {
  std::mt19937 random(4);
  for (int trial = 0; trial < 20; ++trial) {
    MaskChange change;
    std::uint32_t v = 0;
    for (int n = 0; n < 500; ++n) change.voxels.push_back(v += 1 + (random() % 3 ? 0 : random() % 5'000'000));
    MaskChange shuffled = change;
    std::shuffle(shuffled.voxels.begin(), shuffled.voxels.end(), random);
    EXPECT_EQ(unpack(pack(shuffled)).voxels, change.voxels);
  }
  EXPECT_TRUE(unpack(pack({})).empty());
}

TEST(MaskChange, ABrushDabPacksToAFewBytesPerRow) {
  volume::VoxelGrid grid;
  grid.size = {256, 256, 256};
  const Mask empty = testing::emptyMask(grid);
  const auto change = paint(empty, {grid.centre(), grid.centre()}, {10.0, {}}, true);
  EXPECT_LT(pack(change).bytes.size(), 4 * 330u);  // 317 rows; the mask itself has 16.8 million voxels
}

TEST(MaskEditor, UndoAndRedoGoThroughEveryStateAnyNumberOfTimes) {
  MaskEditor editor(startMask());
  std::mt19937 random(7);
  std::vector<std::vector<std::uint8_t>> states{editor.mask().voxels};
  for (int n = 0; n < 300; ++n) {
    const auto change = dab(editor, random);
    editor.apply("dab", change);
    if (!change.empty()) states.push_back(editor.mask().voxels);
  }
  ASSERT_GT(states.size(), 150u);
  for (int round = 0; round < 2; ++round) {
    for (std::size_t n = states.size() - 1; n-- > 0;) {
      ASSERT_EQ(editor.undo(), "dab");
      ASSERT_EQ(editor.mask().voxels, states[n]);
    }
    EXPECT_FALSE(editor.undo());
    EXPECT_FALSE(editor.isEdited());
    for (std::size_t n = 1; n < states.size(); ++n) {
      ASSERT_EQ(editor.redo(), "dab");
      ASSERT_EQ(editor.mask().voxels, states[n]);
    }
    EXPECT_FALSE(editor.redo());
  }
}

TEST(MaskEditor, AnEditAfterAnUndoForgetsWhatWasUndone) {
  MaskEditor editor(startMask());
  editor.apply("first", {{1, 2, 3}});
  editor.apply("second", {{4}});
  editor.undo();
  editor.apply("third", {{5}});
  EXPECT_EQ(editor.steps(), (std::vector<std::string>{"first", "third"}));
  EXPECT_FALSE(editor.canRedo());
  editor.apply("nothing", {});
  EXPECT_EQ(editor.done(), 2u);
}

TEST(MaskEditor, AStrokeIsOneStepHoweverItCrossesItself) {
  MaskEditor editor(startMask());
  const auto before = editor.mask().voxels;
  std::mt19937 random(11);
  editor.beginStroke("scribble");
  for (int n = 0; n < 50; ++n) editor.apply("dab", dab(editor, random));
  editor.endStroke();
  const auto after = editor.mask().voxels;
  EXPECT_EQ(editor.steps(), std::vector<std::string>{"scribble"});
  editor.undo();
  EXPECT_EQ(editor.mask().voxels, before);
  editor.redo();
  EXPECT_EQ(editor.mask().voxels, after);
}

TEST(MaskEditor, UndoInTheMiddleOfAStrokeTakesTheStrokeBack) {
  MaskEditor editor(startMask());
  const auto before = editor.mask().voxels;
  editor.beginStroke("brush");
  editor.apply("dab", {{1, 2, 3}});
  EXPECT_TRUE(editor.canUndo());
  EXPECT_EQ(editor.undo(), "brush");
  EXPECT_EQ(editor.mask().voxels, before);
  EXPECT_EQ(editor.redo(), "brush");
}

TEST(MaskEditor, KeepsTheAutomaticMaskAndGoesBackToItAsAnEdit) {
  const Mask automatic = startMask();
  Mask edited = automatic;
  edited.voxels[5] ^= 1;
  MaskEditor editor(automatic, edited);
  EXPECT_TRUE(editor.isEdited());
  EXPECT_EQ(editor.automatic().voxels, automatic.voxels);
  editor.resetToAutomatic();
  EXPECT_EQ(editor.mask().voxels, automatic.voxels);
  editor.undo();
  EXPECT_EQ(editor.mask().voxels, edited.voxels);
  Mask elsewhere = automatic;
  elsewhere.grid.mri_from_voxel.translation().x() += 1;
  EXPECT_THROW(MaskEditor(automatic, elsewhere), Error);
}

TEST(MaskAutosave, WritesTheLastStateOnceItRests) {
  MaskEditor editor(startMask());
  std::mutex guard;
  std::vector<std::vector<std::uint8_t>> files;
  MaskAutosave autosave(
      [&](const Mask& mask) {
        const std::lock_guard lock(guard);
        files.push_back(mask.voxels);
      },
      2, 15);
  autosave.tick(editor, 0);
  EXPECT_TRUE(autosave.isSaved(editor));  // no change yet
  editor.apply("edit", {{1}});
  autosave.tick(editor, 10.0);
  autosave.tick(editor, 11.0);
  EXPECT_FALSE(autosave.isSaved(editor));
  editor.apply("edit", {{2}});
  autosave.tick(editor, 11.5);
  autosave.tick(editor, 13.6);  // starts a write
  autosave.saveNow(editor);     // waits for it
  EXPECT_TRUE(autosave.isSaved(editor));
  ASSERT_EQ(files.size(), 1u);
  EXPECT_EQ(files[0], editor.mask().voxels);
}

TEST(MaskAutosave, WritesNowAndThenWhileSomeonePaintsWithoutRest) {
  MaskEditor editor(startMask());
  int files = 0;
  {
    MaskAutosave autosave([&](const Mask&) { ++files; }, 2, 15);
    for (int second = 0; second < 40; ++second) {
      editor.apply("edit", {{std::uint32_t(second)}});
      autosave.tick(editor, second);
      if (second == 20) autosave.saveNow(editor);
    }
  }
  EXPECT_GE(files, 2);
  EXPECT_LE(files, 4);
}

TEST(MaskAutosave, TellsOfAFailedWriteAndTriesAgain) {
  MaskEditor editor(startMask());
  int calls = 0;
  MaskAutosave autosave([&](const Mask&) {
    if (++calls == 1) throw Error("the disk is full");
  });
  editor.apply("edit", {{1}});
  EXPECT_THROW(autosave.saveNow(editor), Error);
  EXPECT_FALSE(autosave.isSaved(editor));
  autosave.saveNow(editor);
  EXPECT_TRUE(autosave.isSaved(editor));
}

}  // namespace
}  // namespace facenav::editing
