// openLiveOutput: which output the words name.

#include <charconv>

#include "datagram_output.h"
#include "facenav/core/error.h"
#include "igtl_server.h"

namespace facenav::links {
namespace {

struct OutputWords {
  std::string kind, host = "127.0.0.1";
  int port = kIgtlPort;
};

[[noreturn]] void refuseOutput(const std::string& words) {
  throw Error("unknown output '" + words + "'", {}, "use " + liveOutputWords());
}

/// Reads "igtl", "igtl:18944", "osc:192.168.0.5:9000".
OutputWords outputFrom(const std::string& words) {
  OutputWords output;
  const auto first = words.find(':'), last = words.rfind(':');
  output.kind = words.substr(0, first);
  const bool is_server = output.kind == "igtl";
  if (!is_server && output.kind != "osc" && output.kind != "json") refuseOutput(words);
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

std::string liveOutputWords() { return "igtl[:[ADDRESS:]PORT], osc:[HOST:]PORT, json:[HOST:]PORT"; }

void requireLiveOutput(const std::string& words) { outputFrom(words); }

std::unique_ptr<LiveOutput> openLiveOutput(const std::string& words, LiveContent content,
                                           const LiveIncoming& incoming) {
  const auto output = outputFrom(words);
  if (output.kind == "igtl")
    return std::make_unique<IgtlServer>(words, IgtlPlaceToListen{output.host, output.port},
                                        std::move(content), incoming);
  const auto format = output.kind == "osc" ? DatagramFormat::osc : DatagramFormat::json;
  return std::make_unique<DatagramOutput>(words, format, PlaceToSend{output.host, output.port});
}

}  // namespace facenav::links
