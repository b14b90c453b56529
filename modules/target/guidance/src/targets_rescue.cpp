#include "targets_rescue.h"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

#include "facenav/core/number_text.h"

namespace facenav::guidance {
namespace {

using Json = nlohmann::ordered_json;

bool isOfWord(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '+' || c == '-' || c == '.';
}

/// Returns the end of the text in quotes that begins at `begin`.
std::size_t endOfQuoted(const std::string& text, std::size_t begin) {
  std::size_t at = begin + 1;
  while (at < text.size() && text[at] != '"') at += text[at] == '\\' ? 2 : 1;
  return std::min(at + 1, text.size());
}

/// Replaces the words outside quotes that are neither a usable number nor a constant of JSON.
std::string withoutOddWords(const std::string& text) {
  std::string valid;
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t end = begin + 1;
    if (text[begin] == '"') end = endOfQuoted(text, begin);
    if (isOfWord(text[begin]))
      while (end < text.size() && isOfWord(text[end])) ++end;
    const std::string piece = text.substr(begin, end - begin);
    const bool is_odd =
        isOfWord(text[begin]) && piece != "true" && piece != "false" && piece != "null" && !numberIn(piece);
    valid += is_odd ? "null" : piece;
    begin = end;
  }
  return valid;
}

}  // namespace

std::string rescuedTargets(const std::string& text) {
  constexpr int kDepthOfTarget = 2;  // in the list of the root object
  Json targets = Json::array();
  const auto collect = [&](int depth, Json::parse_event_t event, Json& value) {
    if (event == Json::parse_event_t::object_end && depth == kDepthOfTarget && value.contains("name"))
      targets.push_back(value);
    return true;
  };
  const Json whole = Json::parse(withoutOddWords(text), collect, false);
  if (whole.is_object()) return whole.dump(1, ' ', false, Json::error_handler_t::replace);
  if (targets.empty()) return {};
  return Json{{"targets", targets}}.dump(1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace facenav::guidance
