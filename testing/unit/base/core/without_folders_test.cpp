#include "facenav/core/without_folders.h"

#include <gtest/gtest.h>

#include "facenav/core/error.h"

namespace facenav {
namespace {

TEST(WithoutFolders, EveryPathLosesItsFoldersAndTheWordsBetweenStay) {
  EXPECT_EQ(withoutFolders("copying /home/doe/a.csv to /media/doe/b.csv failed"),
            "copying a.csv to b.csv failed");
  EXPECT_EQ(withoutFolders("cannot copy [/home/doe/a] ['/home/doe/b c']"), "cannot copy [a] ['b c']");
  EXPECT_EQ(withoutFolders("/home/doe/a.png"), "a.png");
  EXPECT_EQ(withoutFolders("cases/doe/a.csv: damaged"), "a.csv: damaged");
  EXPECT_EQ(withoutFolders("../doe/a.csv, cases/doe/b.csv").find("doe"), std::string::npos);
  EXPECT_EQ(withoutFolders("rtsp://doe:secret@host/left is silent"), "rtsp:left is silent");
}

TEST(WithoutFolders, AFolderMayHoldBlanksAndCommas) {
  EXPECT_EQ(withoutFolders("cannot be read: /data/Doe, Jane M/left/5.png, check the disk"),
            "cannot be read: 5.png, check the disk");
}

TEST(WithoutFolders, AnErrorKeepsWhatHappenedAndWhatToDo) {
  const Error error("cannot be written", "/home/jane doe/case/protocol.json", "look into /tmp/log or ask");
  EXPECT_EQ(withoutFolders(std::string("its copy is not kept: ") + error.what()),
            "its copy is not kept: protocol.json: cannot be written; look into log or ask");
}

TEST(WithoutFolders, NumbersAndUnitsAreNoPaths) {
  for (const char* words :
       {"", "/", "pain 3/10, at 5 mm/s", "2.0 / 3.8 mm", "on 12/05/2026", "120/80 and/or"})
    EXPECT_EQ(withoutFolders(words), words);
}

TEST(WithoutFolders, ADeviceKeepsItsName) {
  EXPECT_EQ(withoutFolders("the camera was unplugged: Webcam (/dev/video2)"),
            "the camera was unplugged: Webcam (/dev/video2)");
}

}  // namespace
}  // namespace facenav
