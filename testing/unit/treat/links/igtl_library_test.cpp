// The protocol's own library (Debian's libopenigtlink) as the peer: what it packs we read, what we write it
// unpacks, and it is a client of the server. It knows header 1 only.

#include <gtest/gtest.h>

#ifdef FACENAV_HAS_OPENIGTLINK
#include <igtlClientSocket.h>
#include <igtlImageMessage.h>
#include <igtlMessageHeader.h>
#include <igtlPointMessage.h>
#include <igtlPolyDataMessage.h>
#include <igtlPositionMessage.h>
#include <igtlQuaternionTrackingDataMessage.h>
#include <igtlStatusMessage.h>
#include <igtlStringMessage.h>
#include <igtlTrackingDataMessage.h>
#include <igtlTransformMessage.h>

#include <thread>

#include "facenav/links/igtl_content.h"
#include "facenav/links/igtl_reader.h"
#include "live/igtl_server.h"

namespace facenav::links {
namespace {

Eigen::Isometry3d somePose() {
  Eigen::Isometry3d pose(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, -2, 0.5).normalized()));
  pose.translation() = Eigen::Vector3d(12.5, -80, 640);
  return pose;
}

void fill(igtl::Matrix4x4& matrix, const Eigen::Isometry3d& pose) {
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) matrix[row][column] = float(pose.matrix()(row, column));
}

double difference(const igtl::Matrix4x4& matrix, const Eigen::Isometry3d& pose) {
  double largest = 0;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      largest = std::max(largest, std::abs(matrix[row][column] - pose.matrix()(row, column)));
  return largest;
}

/// The message as the library sends it.
template <class Message>
IgtlMessage packed(Message& message) {
  message.Pack();
  IgtlReader reader;
  reader.add(static_cast<const std::uint8_t*>(message.GetPackPointer()), std::size_t(message.GetPackSize()));
  const auto read = reader.next();
  EXPECT_TRUE(read);
  EXPECT_EQ(reader.held(), 0u);
  return read.value_or(IgtlMessage());
}

/// Our message as the library reads it; its CRC is checked.
template <class Message>
typename Message::Pointer unpacked(const std::string& type, const Bytes& content) {
  IgtlMessage sent;
  sent.type = type;
  sent.device = "FaceNav";
  sent.content = content;
  const Bytes bytes = encoded(sent);
  auto header = igtl::MessageHeader::New();
  header->InitPack();
  std::copy_n(bytes.begin(), kIgtlHeaderSize, static_cast<std::uint8_t*>(header->GetPackPointer()));
  header->Unpack();
  EXPECT_EQ(header->GetDeviceType(), type);
  auto message = Message::New();
  message->SetMessageHeader(header);
  message->AllocatePack();
  std::copy(bytes.begin() + kIgtlHeaderSize, bytes.end(),
            static_cast<std::uint8_t*>(message->GetPackBodyPointer()));
  EXPECT_TRUE(message->Unpack(1) & igtl::MessageHeader::UNPACK_BODY) << type;
  return message;
}

TEST(IgtlLibrary, PosesGoBothWays) {
  const auto pose = somePose();
  igtl::Matrix4x4 matrix;
  fill(matrix, pose);
  auto transform = igtl::TransformMessage::New();
  transform->SetDeviceName("Coil1ToTracker");
  transform->SetMatrix(matrix);
  const auto read = packed(*transform);
  EXPECT_EQ(read.device, "Coil1ToTracker");
  EXPECT_EQ(read.content, transformContent(pose));
  igtl::Matrix4x4 back;
  unpacked<igtl::TransformMessage>("TRANSFORM", transformContent(pose))->GetMatrix(back);
  EXPECT_LT(difference(back, pose), 1e-4);

  auto position = igtl::PositionMessage::New();
  position->SetPosition(1, 2, 3);
  position->SetQuaternion(0.5f, 0.5f, 0.5f, 0.5f);
  const auto place = readPosition(packed(*position).content);
  ASSERT_TRUE(place);
  EXPECT_EQ(place->position_mm, Eigen::Vector3d(1, 2, 3));
  float x, y, z;
  unpacked<igtl::PositionMessage>("POSITION", positionContent(placeOf(pose)))->GetPosition(&x, &y, &z);
  EXPECT_FLOAT_EQ(z, 640);
}

TEST(IgtlLibrary, ToolsGoBothWays) {
  const auto pose = somePose();
  igtl::Matrix4x4 matrix;
  fill(matrix, pose);
  auto tools = igtl::TrackingDataMessage::New();
  auto tool = igtl::TrackingDataElement::New();
  tool->SetName("Coil1");
  tool->SetType(igtl::TrackingDataElement::TYPE_6D);
  tool->SetMatrix(matrix);
  tools->AddTrackingDataElement(tool);
  Bytes sent = packed(*tools).content;
  ASSERT_EQ(sent.size(), 70u);
  sent[21] = 0;  // reserved; the library leaves it as it was in memory
  EXPECT_EQ(sent, toolsContent({{"Coil1", pose}}));
  const auto back = unpacked<igtl::TrackingDataMessage>("TDATA", toolsContent({{"A", pose}, {"B", pose}}));
  ASSERT_EQ(back->GetNumberOfTrackingDataElements(), 2);
  auto second = igtl::TrackingDataElement::New();
  back->GetTrackingDataElement(1, second);
  EXPECT_STREQ(second->GetName(), "B");
  second->GetMatrix(matrix);
  EXPECT_LT(difference(matrix, pose), 1e-4);
  const auto placed =
      unpacked<igtl::QuaternionTrackingDataMessage>("QTDATA", placedToolsContent({{"A", placeOf(pose)}}));
  ASSERT_EQ(placed->GetNumberOfQuaternionTrackingDataElements(), 1);
  auto first = igtl::QuaternionTrackingDataElement::New();
  placed->GetQuaternionTrackingDataElement(0, first);
  float x, y, z, w;
  first->GetQuaternion(&x, &y, &z, &w);
  EXPECT_NEAR(w, placeOf(pose).rotation.w(), 1e-6);
}

TEST(IgtlLibrary, WordsAndPointsGoBothWays) {
  auto status = igtl::StatusMessage::New();
  status->SetCode(igtl::StatusMessage::STATUS_DISABLED);
  status->SetSubCode(-3);
  status->SetErrorName("OFF");
  status->SetStatusString("switched off");
  const auto read = readStatus(packed(*status).content);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->code, 15);
  EXPECT_EQ(read->subcode, -3);
  EXPECT_EQ(read->text, "switched off");
  const auto words = unpacked<igtl::StatusMessage>("STATUS", statusContent({1, 5, "OK", "tracking"}));
  EXPECT_EQ(words->GetSubCode(), 5);
  EXPECT_STREQ(words->GetStatusString(), "tracking");
  EXPECT_STREQ(unpacked<igtl::StringMessage>("STRING", stringContent({"on_target"}))->GetString(),
               "on_target");
  IgtlPoint point;
  point.name = "M1";
  point.position_mm = {-38, -22, 58};
  const auto points = unpacked<igtl::PointMessage>("POINT", pointsContent({point}));
  ASSERT_EQ(points->GetNumberOfPointElement(), 1);
  auto first = igtl::PointElement::New();
  points->GetPointElement(0, first);
  EXPECT_STREQ(first->GetName(), "M1");
  igtlFloat32 at[3];
  first->GetPosition(at);
  EXPECT_FLOAT_EQ(at[2], 58);
}

TEST(IgtlLibrary, SurfacesAndImagesAreRead) {
  const IgtlSurface surface{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 2.5f}}, {{0, 1, 2}, {0, 2, 3}}};
  const auto mesh = unpacked<igtl::PolyDataMessage>("POLYDATA", surfaceContent(surface));
  ASSERT_EQ(mesh->GetPoints()->GetNumberOfPoints(), 4);
  igtlFloat32 point[3];
  mesh->GetPoints()->GetPoint(3, point);
  EXPECT_FLOAT_EQ(point[2], 2.5);
  ASSERT_EQ(mesh->GetPolygons()->GetNumberOfCells(), 2u);
  IgtlImage image;
  image.size = {2, 3, 4};
  image.steps_mm = Eigen::Vector3d(1, 1.5, 2).asDiagonal();
  image.centre_mm = {5, 6, 7};
  for (int n = 0; n < 24; ++n) image.voxels.push_back(float(n));
  const auto seen = unpacked<igtl::ImageMessage>("IMAGE", imageContent(image));
  int size[3];
  seen->GetDimensions(size);
  EXPECT_EQ(size[2], 4);
  EXPECT_EQ(seen->GetScalarType(), int(igtl::ImageMessage::TYPE_FLOAT32));
  EXPECT_EQ(seen->GetCoordinateSystem(), int(igtl::ImageMessage::COORDINATE_RAS));
  igtl::Matrix4x4 matrix;
  seen->GetMatrix(matrix);
  EXPECT_FLOAT_EQ(matrix[1][3], 6);
  EXPECT_EQ(static_cast<const float*>(seen->GetScalarPointer())[23], 23);
}

TEST(IgtlLibrary, ItsClientReadsOurServer) {
  IgtlServer server("igtl", {"127.0.0.1", 0}, {});
  auto client = igtl::ClientSocket::New();
  ASSERT_EQ(client->ConnectToServer("127.0.0.1", server.port()), 0);
  client->SetReceiveTimeout(5000);
  while (server.report().receivers.empty()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  auto frame = std::make_shared<LiveFrame>();
  frame->utc = std::chrono::system_clock::time_point(std::chrono::milliseconds(1772706030125));
  frame->poses = {{"SubjectToTracker", somePose()}};
  server.publish(frame);
  auto header = igtl::MessageHeader::New();
  header->InitPack();
  ASSERT_EQ(client->Receive(header->GetPackPointer(), header->GetPackSize()), int(kIgtlHeaderSize));
  header->Unpack();
  EXPECT_STREQ(header->GetDeviceName(), "SubjectToTracker");
  igtlUint32 s, fraction;
  header->GetTimeStamp(&s, &fraction);
  EXPECT_EQ(s, 1772706030u);
  auto message = igtl::TransformMessage::New();
  message->SetMessageHeader(header);
  message->AllocatePack();
  ASSERT_EQ(client->Receive(message->GetPackBodyPointer(), message->GetPackBodySize()), 48);
  ASSERT_TRUE(message->Unpack(1) & igtl::MessageHeader::UNPACK_BODY);
  igtl::Matrix4x4 matrix;
  message->GetMatrix(matrix);
  EXPECT_LT(difference(matrix, somePose()), 1e-4);
  client->CloseSocket();
}

}  // namespace
}  // namespace facenav::links

#else

TEST(IgtlLibrary, PosesGoBothWays) { GTEST_SKIP() << "libopenigtlink-dev is not installed"; }

#endif
