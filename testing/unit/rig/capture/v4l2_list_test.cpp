// The list of Video4Linux cameras and its words.

#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>

#include "support/v4l2_tree.h"
#include "v4l2_bench.h"

namespace facenav::capture {
namespace {

using ::testing::HasSubstr;

// ---- The list of what is connected, from trees like /sys and /proc.

class V4l2List : public ::testing::Test {
 protected:
  void add(const std::string& video, const std::string& model, const std::string& port,
           const std::string& serial, const std::string& index = "0") {
    tree_.add(video, model, port, serial, index);
  }
  std::filesystem::path root() const { return tree_.root(); }
  std::vector<FoundCamera> list() const { return tree_.list(); }
  testing::V4l2Tree tree_;
  FakeV4l2* kernel_ = &tree_.kernel();
};

TEST_F(V4l2List, NamesWhatGivesPicturesInTheOrderOfItsNumbers) {
  add("video10", "Right camera", "1-2", "B");
  add("video2", "Left camera", "1-1", "A");
  add("video3", "Left camera", "1-1x", "A", "1");  // its metadata
  std::filesystem::create_directories(root() / "sys" / "v4l-subdev0");
  const auto found = list();
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(stableName(found[0].identity), "v4l2:Left camera#A");
  EXPECT_EQ(found[0].identity.address, "/dev/video2");
  EXPECT_EQ(found[1].identity.port, "1-2");
  EXPECT_TRUE(adviceOn(found).empty());
  EXPECT_EQ(findCamera(found, "10").serial, "B");
  EXPECT_EQ(findCamera(found, "video2").serial, "A");
  EXPECT_EQ(findCamera(found, "v4l2:Right camera#B").address, "/dev/video10");
}

TEST_F(V4l2List, NoCameraAndOneCameraAreSaidInPlainWords) {
  EXPECT_THAT(adviceOn(list()),
              ::testing::ElementsAre("no camera found: plug two cameras in and look again"));
  add("video0", "Webcam", "1-1", "A");
  EXPECT_THAT(adviceOn(list()), ::testing::ElementsAre(HasSubstr("one camera only: two are needed")));
  std::string words;
  EXPECT_EQ(faultOf([&] { findCamera(list(), "video5"); }, &words), CameraFault::missing);
  EXPECT_THAT(words, HasSubstr("connected: Webcam, serial number A (/dev/video0)"));
}

TEST_F(V4l2List, TwoEqualOnesWithoutSerialNumbersAreToldApartByTheirPorts) {
  add("video0", "USB Camera", "1-1", "");
  add("video2", "USB Camera", "1-2", "");
  const auto found = list();
  EXPECT_EQ(stableName(found[0].identity), "v4l2:USB Camera@1-1");
  EXPECT_FALSE(isSameCamera(found[0].identity, found[1].identity));
  EXPECT_THAT(adviceOn(found),
              ::testing::ElementsAre(HasSubstr("two equal cameras without serial numbers (USB Camera)")));
  auto moved = found[0].identity;
  moved.port = "1-3";
  std::string words;
  EXPECT_EQ(faultOf([&] { findCamera(found, moved); }, &words), CameraFault::missing);
  EXPECT_THAT(words, HasSubstr("in another port"));
}

TEST_F(V4l2List, ASerialNumberThatAllPiecesShareTellsNothing) {
  add("video0", "USB Camera", "1-1", "SN0001");
  add("video2", "USB Camera", "1-2", "SN0001");
  EXPECT_EQ(stableName(list()[0].identity), "v4l2:USB Camera@1-1");
  EXPECT_EQ(adviceOn(list()).size(), 1u);
}

TEST_F(V4l2List, ACameraInUseIsNamedWithTheProgramThatHasIt) {
  add("video0", "Webcam", "1-1", "A");
  add("video2", "Webcam", "1-2", "B");
  kernel_->cameras["/dev/video2"]->is_busy = true;
  EXPECT_THAT(adviceOn(list()),
              ::testing::ElementsAre(HasSubstr("in use by another program: close that program")));
  tree_.use("video2", "cheese", "4711");
  const auto found = list();
  EXPECT_EQ(found[0].use, FoundCamera::Use::free);
  EXPECT_EQ(found[1].use, FoundCamera::Use::in_use);
  EXPECT_THAT(inWords(found[1]), HasSubstr("in use by cheese (process 4711)"));
  std::filesystem::create_directories(root() / "proc" / std::to_string(::getpid()) / "fd");
  std::filesystem::create_symlink("/dev/video2", root() / "proc" / std::to_string(::getpid()) / "fd" / "9");
  EXPECT_EQ(list()[1].use, FoundCamera::Use::free);  // this program uses it for its own pictures
  kernel_->cameras["/dev/video0"]->open_error = EACCES;
  EXPECT_THAT(adviceOn(list())[0], HasSubstr("this user may not open it: ask your administrator"));
}

}  // namespace
}  // namespace facenav::capture
