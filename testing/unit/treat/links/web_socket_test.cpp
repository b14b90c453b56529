#include "live/web_socket.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/relay_mutations.h"

namespace facenav::links {
namespace {

using ::testing::HasSubstr;

const std::string kKey = "dGhlIHNhbXBsZSBub25jZQ==";  // of RFC 6455, section 1.3

std::string answer(const std::string& accept = "s3pPLMBiTxaQ9kYGzzhZRbK+xOo=") {
  return "HTTP/1.1 101 Switching Protocols\r\nupgrade: WebSocket\r\nConnection: Upgrade\r\n"
         "SEC-WebSocket-accept:  " +
         accept + "\r\n\r\n";
}

WebSocketReader opened() {
  WebSocketReader reader(kKey);
  const std::string text = answer();
  reader.add(text.data(), text.size());
  return reader;
}

std::string faultOf(const std::string& bytes) {
  WebSocketReader reader = opened();
  reader.add(bytes.data(), bytes.size());
  EXPECT_FALSE(reader.next());
  return reader.fault();
}

TEST(WebSocket, HasTheBytesOfTheStandard) {
  EXPECT_EQ(webSocketAccept(kKey), "s3pPLMBiTxaQ9kYGzzhZRbK+xOo=");
  EXPECT_EQ(webSocketFrame(WebSocketKind::text, "Hello", 0x37fa213d),
            "\x81\x85\x37\xfa\x21\x3d\x7f\x9f\x4d\x51\x58");
  EXPECT_EQ(webSocketFrame(WebSocketKind::text, std::string(256, 'a'), 0).substr(0, 4),
            std::string("\x81\xFE\x01\x00", 4));
  EXPECT_EQ(webSocketFrame(WebSocketKind::text, std::string(65536, 'a'), 0).substr(0, 10),
            std::string("\x81\xFF\x00\x00\x00\x00\x00\x01\x00\x00", 10));
}

TEST(WebSocket, ReadsMessagesInAnyPieces) {
  const std::string bytes = answer() +
                            std::string("\x81\x05Hello\x01\x03Hel\x89\x02hi\x80\x02lo\x82\x7E\x01\x00", 25) +
                            std::string(256, 'b');
  for (const std::size_t piece : {std::size_t(1), std::size_t(3), bytes.size()}) {
    WebSocketReader reader(kKey);
    std::vector<WebSocketMessage> messages;
    for (std::size_t at = 0; at < bytes.size(); at += piece) {
      reader.add(bytes.data() + at, std::min(piece, bytes.size() - at));
      while (auto message = reader.next()) messages.push_back(*message);
    }
    ASSERT_EQ(messages.size(), 4u) << piece << reader.fault();
    EXPECT_EQ(messages[0].content, "Hello");
    EXPECT_EQ(messages[1].kind, WebSocketKind::ping) << "between the parts of a message";
    EXPECT_EQ(messages[2].content, "Hello");
    EXPECT_EQ(messages[3].content.size(), 256u);
  }
}

TEST(WebSocket, RefusesWhatIsNoRelayOrNoMessage) {
  const std::pair<std::string, std::string> kAnswers[] = {
      {"SSH-2.0-OpenSSH_9.2\r\n", "no web server"},
      {"HTTP/1.1 404 Not Found\r\n\r\n", "HTTP 404"},
      {"HTTP/1.1 200 OK\r\nUpgrade: websocket\r\n\r\n", "HTTP 200"},
      {answer("bm8="), "another client"},
      {"HTTP/1.1 101 X\r\n" + std::string(9000, 'x'), "no web server"}};
  for (const auto& [text, words] : kAnswers) {
    WebSocketReader reader(kKey);
    reader.add(text.data(), text.size());
    EXPECT_THAT(reader.fault(), HasSubstr(words));
    EXPECT_FALSE(reader.next());
    EXPECT_EQ(reader.held(), 0u);
  }
  EXPECT_THAT(faultOf(std::string("\xC1\x01x", 3)), HasSubstr("extension"));
  EXPECT_THAT(faultOf(std::string("\x81\x81\x01\x02\x03\x04x", 7)), HasSubstr("masks"));
  EXPECT_THAT(faultOf(std::string("\x81\x7F\x7F\xFF\xFF\xFF\xFF\xFF\xFF\xFF", 10)), HasSubstr("too long"));
  EXPECT_THAT(faultOf(std::string("\x80\x01x", 3)), HasSubstr("broken"));
  EXPECT_THAT(faultOf(std::string("\x09\x00", 2)), HasSubstr("broken"));
  EXPECT_THAT(faultOf(std::string("\x83\x00", 2)), HasSubstr("unknown kind"));
}

TEST(WebSocket, DamagedStreamsDoNoHarm) {
  const auto found = testing::readRelayMutations(20000, 4848);
  EXPECT_GT(found.messages, 20000);
  EXPECT_GT(found.events, 2000);
  EXPECT_LT(found.most_held, 4096u);
}

}  // namespace
}  // namespace facenav::links
