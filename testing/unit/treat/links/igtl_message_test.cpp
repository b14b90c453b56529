#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "support/igtl_mutations.h"
#include "support/test_data.h"

namespace facenav::links {
namespace {

const std::filesystem::path kSamples =
    std::filesystem::path(FACENAV_SOURCE_DIR) / "testing/unit/treat/links/samples";

Bytes bytesOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<IgtlMessage> messagesIn(const Bytes& bytes) {
  IgtlReader reader;
  reader.add(bytes.data(), bytes.size());
  std::vector<IgtlMessage> messages;
  while (auto message = reader.next()) messages.push_back(*message);
  EXPECT_EQ(reader.damaged(), 0);
  EXPECT_EQ(reader.held(), 0u);
  return messages;
}

/// Poses of the samples: SubjectToTracker, Coil1ToTracker.
std::vector<Eigen::Isometry3d> truth() {
  std::ifstream file(kSamples / "openigtlink_truth.csv");
  std::vector<Eigen::Isometry3d> poses;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream numbers(line);
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 4; ++column) numbers >> pose.matrix()(row, column);
    poses.push_back(pose);
  }
  return poses;
}

/// Makes the message anew from what was read in it.
Bytes madeAgain(const IgtlMessage& read) {
  IgtlMessage message = read;
  const auto& content = read.content;
  if (read.type == "TRANSFORM") message.content = transformContent(*readTransform(content));
  if (read.type == "TDATA") message.content = toolsContent(*readTools(content));
  if (read.type == "QTDATA") message.content = placedToolsContent(*readPlacedTools(content));
  if (read.type == "POSITION") message.content = positionContent(*readPosition(content));
  if (read.type == "STATUS") message.content = statusContent(*readStatus(content));
  if (read.type == "STRING") message.content = stringContent(*readString(content));
  return encoded(message);
}

TEST(IgtlMessage, TheSamplesAreReadAndWrittenByteForByte) {
  for (const char* name : {"openigtlink_header1.bin", "openigtlink_header2.bin"}) {
    const Bytes bytes = bytesOf(kSamples / name);
    Bytes again;
    for (const auto& message : messagesIn(bytes)) {
      const Bytes one = madeAgain(message);
      again.insert(again.end(), one.begin(), one.end());
    }
    EXPECT_EQ(again, bytes) << name;
  }
}

TEST(IgtlMessage, TheSamplesOfHeader1HoldTheTruth) {
  const auto poses = truth();
  ASSERT_EQ(poses.size(), 2u);
  const auto messages = messagesIn(bytesOf(kSamples / "openigtlink_header1.bin"));
  ASSERT_EQ(messages.size(), 7u);
  EXPECT_EQ(messages[0].device, "SubjectToTracker");
  EXPECT_EQ(messages[1].device, "Coil1ToTracker");
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(messages[i].content, transformContent(poses[i]));
    EXPECT_LT((readTransform(messages[i].content)->matrix() - poses[i].matrix()).norm(), 1e-4);
    EXPECT_LT(((*readTools(messages[3].content))[i].pose.matrix() - poses[i].matrix()).norm(), 1e-4);
    const auto place = (*readPlacedTools(messages[4].content))[i].place;
    EXPECT_LT((place.position_mm - poses[i].translation()).norm(), 1e-4);
    EXPECT_LT((place.rotation.toRotationMatrix() - poses[i].linear()).norm(), 1e-6);
  }
  EXPECT_EQ(readStatus(messages[2].content)->text, "tracking");
  EXPECT_LT((readPosition(messages[5].content)->position_mm - poses[1].translation()).norm(), 1e-4);
  EXPECT_EQ(readString(messages[6].content)->text, "on_target");
  const auto time = std::chrono::duration<double>(timeOf(messages[0].stamp).time_since_epoch()).count();
  EXPECT_NEAR(time, 1772706030.125, 1e-6);
  EXPECT_EQ(igtlStamp(timeOf(messages[0].stamp)), messages[0].stamp);
}

TEST(IgtlMessage, TheSamplesOfHeader2HoldMetadataAndTheLongName) {
  const auto messages = messagesIn(bytesOf(kSamples / "openigtlink_header2.bin"));
  ASSERT_EQ(messages.size(), 3u);
  EXPECT_EQ(messages[0].header_version, 2);
  EXPECT_EQ(messages[0].id, 7u);
  EXPECT_EQ(messages[0].value("TransformValid"), "1");
  EXPECT_EQ(messages[1].value("TransformValid"), "0");
  EXPECT_EQ(messages[1].value("TransformStatus"), "OUT_OF_VIEW");
  EXPECT_EQ(messages[2].device, "CoilReferenceFrameToTracker");
}

/// The protocol's own vectors are third-party files, read where the shared data lies.
TEST(IgtlMessage, TheProtocolsOwnVectorsAreReadAndWrittenByteForByte) {
  const auto folder = testing::sharedData() / "interop/openigtlink";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not here";
  int vectors = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".bin") continue;
    ++vectors;
    const Bytes bytes = bytesOf(entry.path());
    const auto messages = messagesIn(bytes);
    ASSERT_EQ(messages.size(), 1u) << entry.path();
    EXPECT_EQ(madeAgain(messages[0]), bytes) << entry.path();
    EXPECT_EQ(messages[0].device, "DeviceName");
  }
  EXPECT_EQ(vectors, 6);
  const auto second = messagesIn(bytesOf(folder / "test_transform_message_Format2.bin"));
  EXPECT_EQ(second[0].value("Second patient age"), "25");
  const auto status = readStatus(messagesIn(bytesOf(folder / "test_status_message.bin"))[0].content);
  EXPECT_EQ(status->code, 15);
  EXPECT_EQ(status->subcode, 10);
  EXPECT_EQ(status->text, "Actuator A is disabled.");
}

TEST(IgtlMessage, EveryContentComesBack) {
  for (const auto& message : testing::igtlMessages()) {
    const auto back = messagesIn(encoded(message));
    ASSERT_EQ(back.size(), 1u) << message.type;
    EXPECT_EQ(back[0].type, message.type);
    EXPECT_EQ(back[0].device, message.device);
    EXPECT_EQ(back[0].content, message.content) << message.type;
    EXPECT_EQ(back[0].value("TransformStatus"), message.value("TransformStatus"));
  }
}

TEST(IgtlMessage, AnImageInLpsIsTurnedToRas) {
  IgtlImage image;
  image.size = {2, 3, 4};
  image.steps_mm = Eigen::Vector3d(1, 1.5, 2).asDiagonal();
  image.centre_mm = {5, 6, 7};
  for (int n = 0; n < 24; ++n) image.voxels.push_back(float(n));
  Bytes content = imageContent(image);
  content[5] = 2;  // LPS
  const auto back = readImage(content);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->voxels, image.voxels);
  EXPECT_EQ(back->centre_mm, Eigen::Vector3d(-5, -6, 7));
  EXPECT_EQ(back->steps_mm.diagonal(), Eigen::Vector3d(-1, -1.5, 2));
}

TEST(IgtlMessage, ImagesOfOtherNumbersAreRead) {
  IgtlImage image;
  image.size = {2, 1, 1};
  image.voxels = {0, 0};
  Bytes content = imageContent(image);
  content.resize(72);
  content[3] = 4, content[4] = 1;  // 16 bits with sign, big-endian
  for (const int byte : {0xFF, 0xFE, 0x01, 0x02}) content.push_back(std::uint8_t(byte));
  const auto back = readImage(content);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->voxels, (std::vector<float>{-2, 258}));
}

TEST(IgtlMessage, APositionMayLackItsRotationOrW) {
  Bytes content = positionContent({{1, 2, 3}, Eigen::Quaterniond(0.8, 0.6, 0, 0)});
  content.resize(24);
  EXPECT_NEAR(readPosition(content)->rotation.w(), 0.8, 1e-6);
  content.resize(12);
  EXPECT_EQ(readPosition(content)->rotation.w(), 1);
  content.resize(11);
  EXPECT_FALSE(readPosition(content));
}

TEST(IgtlMessage, ContentThatIsNoNumberOrPointsNowhereIsRefused) {
  Bytes content = transformContent(Eigen::Isometry3d::Identity());
  content[0] = 0x7F, content[1] = 0xC0;  // not a number
  EXPECT_FALSE(readTransform(content));
  IgtlSurface surface{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 3}}};
  EXPECT_FALSE(readSurface(surfaceContent(surface)));
}

TEST(IgtlReader, AWrongCrcCostsThatMessageOnly) {
  Bytes bytes = bytesOf(kSamples / "openigtlink_header1.bin");
  bytes[kIgtlHeaderSize + 3] ^= 1;
  IgtlReader reader;
  reader.add(bytes.data(), bytes.size());
  int messages = 0;
  while (reader.next()) ++messages;
  EXPECT_EQ(messages, 6);
  EXPECT_EQ(reader.damaged(), 1);
}

TEST(IgtlReader, ALongBodyIsPassedOverWithoutBeingHeld) {
  IgtlMessage message;
  message.type = "VIDEO";
  message.content.assign(1 << 20, 7);
  Bytes bytes = encoded(message);
  message.type = "STRING";
  message.content = stringContent({"after it"});
  const Bytes after = encoded(message);
  bytes.insert(bytes.end(), after.begin(), after.end());
  IgtlReader reader(4096);
  std::mt19937 random(1);
  const auto found = testing::readAll(reader, bytes, random);
  EXPECT_EQ(found.messages, 1);
  EXPECT_EQ(found.contents, 1);
  EXPECT_EQ(reader.passedOver(), 1);
  EXPECT_LT(found.most_held, 1000u);
}

TEST(IgtlReader, AnotherProtocolIsBroken) {
  const std::string web = "GET / HTTP/1.1\r\nHost: localhost\r\nAccept: everything that there is\r\n\r\n";
  IgtlReader reader;
  reader.add(reinterpret_cast<const std::uint8_t*>(web.data()), web.size());
  EXPECT_FALSE(reader.next());
  EXPECT_TRUE(reader.isBroken());
  EXPECT_EQ(reader.held(), 0u);
}

TEST(IgtlReader, AHundredThousandDamagedMessagesDoNoHarm) {
  const auto found = testing::readMutations(100000, 47);
  EXPECT_GT(found.messages, 20000);  // the damage gets past the CRC
  EXPECT_GT(found.contents, 5000);
  EXPECT_LT(found.most_held, 4096u + kIgtlHeaderSize + 200);
}

}  // namespace
}  // namespace facenav::links
