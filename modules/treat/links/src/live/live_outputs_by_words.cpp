// openLiveOutput: which output the words name.

#include <charconv>

#include "datagram_output.h"
#include "facenav/core/error.h"
#include "igtl_server.h"
#include "invesalius_output.h"
#include "lsl_output.h"

namespace facenav::links {
namespace {

struct OutputWords {
  std::string kind, host = "127.0.0.1", stream = "FaceNav", robot;
  int port = kIgtlPort;
};

[[noreturn]] void refuseOutput(const std::string& words) {
  throw Error("unknown output '" + words + "'", {}, "use " + liveOutputWords());
}

/// Removes a trailing ":robot=192.168.0.9" of the relay's words and returns its address.
std::string takeRobot(std::string& words) {
  const auto at = words.find(":robot=");
  if (at == std::string::npos) return {};
  const std::string given = words, robot = words.substr(at + 7);
  words.resize(at);
  const bool is_relay = words.rfind("invesalius:", 0) == 0;
  if (!is_relay || robot.empty() || robot.find(':') != std::string::npos) refuseOutput(given);
  return robot;
}

/// Reads "lsl", "lsl:STREAM".
OutputWords streamFrom(const std::string& words) {
  OutputWords output;
  output.kind = "lsl";
  if (words == output.kind) return output;
  output.stream = words.substr(output.kind.size() + 1);
  if (output.stream.empty() || output.stream.find(':') != std::string::npos) refuseOutput(words);
  return output;
}

/// Reads "igtl", "igtl:18944", "osc:192.168.0.5:9000", "invesalius:5000:robot=192.168.0.9".
OutputWords outputFrom(std::string words) {
  OutputWords output;
  output.robot = takeRobot(words);
  const auto first = words.find(':'), last = words.rfind(':');
  output.kind = words.substr(0, first);
  if (output.kind == "lsl") return streamFrom(words);
  const bool is_server = output.kind == "igtl";
  if (!is_server && output.kind != "osc" && output.kind != "json" && output.kind != "invesalius")
    refuseOutput(words);
  if (first == std::string::npos) {
    if (!is_server) refuseOutput(words);
    return output;
  }
  if (first != last) output.host = words.substr(first + 1, last - first - 1);
  const char* const end = words.data() + words.size();
  const auto [stop, fault] = std::from_chars(words.data() + last + 1, end, output.port);
  const int lowest = is_server ? 0 : 1;
  if (fault != std::errc() || stop != end || output.port < lowest || output.port > 65535 ||
      output.host.empty() || output.host.find(':') != std::string::npos)
    refuseOutput(words);
  return output;
}

}  // namespace

std::string liveOutputWords() {
  return "igtl[:[ADDRESS:]PORT], osc:[HOST:]PORT, json:[HOST:]PORT, lsl[:STREAM], "
         "invesalius:[HOST:]PORT[:robot=ADDRESS]";
}

void requireLiveOutput(const std::string& words) { outputFrom(words); }

std::unique_ptr<LiveOutput> openLiveOutput(const std::string& words, LiveContent content,
                                           const LiveIncoming& incoming) {
  const auto output = outputFrom(words);
  if (output.kind == "igtl")
    return std::make_unique<IgtlServer>(words, IgtlPlaceToListen{output.host, output.port},
                                        std::move(content), incoming);
  if (output.kind == "lsl") return std::make_unique<LslOutput>(words, output.stream);
  if (output.kind == "invesalius")
    return std::make_unique<InvesaliusOutput>(words, RelayPlace{output.host, output.port, output.robot});
  const auto format = output.kind == "osc" ? DatagramFormat::osc : DatagramFormat::json;
  return std::make_unique<DatagramOutput>(words, format, PlaceToSend{output.host, output.port});
}

}  // namespace facenav::links
