#include "facenav/core/shown_address.h"

#include <gtest/gtest.h>

#include "facenav/core/error.h"
#include "facenav/core/log.h"

namespace facenav {
namespace {

TEST(ShownAddress, APasswordIsLeftOut) {
  EXPECT_EQ(shownAddress("rtsp://doe:secret@host/left"), "rtsp://doe@host/left");
  EXPECT_EQ(shownAddress("rtsp://doe:secret@host:554/left?channel=1"), "rtsp://doe@host:554/left?channel=1");
  EXPECT_EQ(shownAddress("RTSP://doe:12345@10.0.0.7/left"), "RTSP://doe@10.0.0.7/left");
  EXPECT_EQ(shownAddress("http://doe:@host"), "http://doe@host");
  EXPECT_EQ(shownAddress("rtsp://doe:secret@[fe80::1]:554/left"), "rtsp://doe@[fe80::1]:554/left");
}

TEST(ShownAddress, APasswordMayHoldTheSignsOfAnAddress) {
  for (const char* password : {"sec/ret", "sec@ret", "sec:ret", "s?e#c", "two words", "12ab", "5/5", "%40x"})
    EXPECT_EQ(shownAddress(std::string("rtsp://doe:") + password + "@host/left"),
              std::string(password) == "5/5" ? "rtsp://doe:5/5@host/left" : "rtsp://doe@host/left")
        << password << ": only a number and '/' is taken for a port";
}

TEST(ShownAddress, AForgottenSlashHidesNoPassword) {
  EXPECT_EQ(shownAddress("rtsp:/doe:secret@host"), "rtsp:/doe@host");
  EXPECT_EQ(shownAddress("rtsp:doe:secret@host"), "rtsp:doe@host");
  EXPECT_EQ(shownAddress("stream:rtsp://doe:secret@host"), "stream:rtsp://doe@host");
}

TEST(ShownAddress, ASecretValueOfAQueryIsLeftOut) {
  EXPECT_EQ(shownAddress("http://host/video?user=doe&pwd=secret&size=1"),
            "http://host/video?user=doe&pwd=&size=1");
  EXPECT_EQ(shownAddress("srt://host:9000?passphrase=secret"), "srt://host:9000?passphrase=");
  EXPECT_EQ(shownAddress("http://host/video?Password=a&token=b c"), "http://host/video?Password=&token= c");
}

TEST(ShownAddress, EveryAddressOfAMessageIsTakenAndTheWordsStay) {
  EXPECT_EQ(shownAddress("left rtsp://a:one@x/l: it is silent; right rtsp://b:two@y/r: it is late"),
            "left rtsp://a@x/l: it is silent; right rtsp://b@y/r: it is late");
}

TEST(ShownAddress, OtherWordsStay) {
  for (const char* words :
       {"", "rtsp://host:554/cam@1", "rtsp://doe@host/left", "v4l2:USB Camera@1-2", "v4l2:Camera@1-2",
        "/data/12:30/a@b", "http://host: it is silent; write to doe@host", "rtsp: is no address",
        "genicam:Basler@192.168.1.20", "http://[::1]:80/a@b", "left: /home/doe/a.mkv@2: not found"})
    EXPECT_EQ(shownAddress(words), words);
}

TEST(ShownAddress, NoErrorAndNoWarningShowsAPassword) {
  EXPECT_STREQ(Error("it is silent", "rtsp://doe:secret@host/left", "try rtsp://doe:secret@host").what(),
               "rtsp://doe@host/left: it is silent; try rtsp://doe@host");
  ::testing::internal::CaptureStderr();
  logWarning("rtsp://doe:secret@host/left is silent");
  logInfo("rtsp://doe:secret@host/left is open");
  logWarningOnce("rtsp://doe:secret@host/left is late");
  EXPECT_EQ(::testing::internal::GetCapturedStderr().find("secret"), std::string::npos);
}

}  // namespace
}  // namespace facenav
