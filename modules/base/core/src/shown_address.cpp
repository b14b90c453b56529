#include "facenav/core/shown_address.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace facenav {
inline namespace core {
namespace {

constexpr std::size_t kNone = std::string::npos;
constexpr const char* kEndOfAddress = " \t\r\n'\"";
/// Schemes that are recognised even if a slash was forgotten: "rtsp:/doe:secret@host".
constexpr std::array<std::string_view, 11> kSchemes = {"rtsp", "rtsps", "rtmp", "rtp", "http", "https",
                                                       "srt",  "udp",   "tcp",  "mms", "ftp"};
constexpr std::array<std::string_view, 16> kSecretKeys = {
    "pass", "passwd", "password", "passphrase", "pwd",       "pw",    "psw",          "loginpas",
    "key",  "secret", "auth",     "sig",        "signature", "token", "access_token", "apikey"};

bool isDigit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

std::string lower(std::string_view text) {
  std::string small(text);
  std::transform(small.begin(), small.end(), small.begin(), [](unsigned char c) { return std::tolower(c); });
  return small;
}

bool isScheme(const std::string& words, std::size_t colon) {
  std::size_t begin = colon;
  while (begin > 0 && std::isalpha(static_cast<unsigned char>(words[begin - 1]))) --begin;
  const std::string scheme = lower(std::string_view(words).substr(begin, colon - begin));
  return std::find(kSchemes.begin(), kSchemes.end(), scheme) != kSchemes.end();
}

/// Where the next address has its user's name or its host; none if there is no address from `at` on.
std::size_t nextAuthority(const std::string& words, std::size_t at) {
  for (std::size_t colon = words.find(':', at); colon != kNone; colon = words.find(':', colon + 1)) {
    if (words.compare(colon, 3, "://") == 0) return colon + 3;
    if (isScheme(words, colon) && colon + 1 < words.size() && words[colon + 1] != ' ')
      return std::min(words.find_first_not_of('/', colon + 1), words.size());
  }
  return kNone;
}

/// True for ":554/", ":554" at the end: the colon stands before a port.
bool isPort(const std::string& words, std::size_t colon) {
  std::size_t end = colon + 1;
  while (end < words.size() && isDigit(words[end])) ++end;
  return end > colon + 1 && (end == words.size() || words[end] != '@') &&
         (end == words.size() || !std::isalnum(static_cast<unsigned char>(words[end])));
}

/// Removes the password between the user's name and '@', if there is one.
void removePassword(std::string& words, std::size_t begin) {
  const std::size_t colon = words.find_first_of(std::string(":[/?#@") + kEndOfAddress, begin);
  if (colon == kNone || words[colon] != ':' || isPort(words, colon)) return;
  if (colon + 1 < words.size() && words[colon + 1] == ' ') return;  // "..//host: it is silent"
  const std::size_t next = words.find("://", colon);
  const std::size_t at = words.substr(0, next).rfind('@');
  if (at != kNone && at > colon) words.erase(colon, at - colon);
}

/// Empties the values of a query that are secret, from `begin` to the end of the address.
void removeSecretValues(std::string& words, std::size_t begin) {
  const auto end = [&] { return std::min(words.find_first_of(kEndOfAddress, begin), words.size()); };
  const std::size_t query = words.find('?', begin);
  if (query == kNone || query >= end()) return;
  for (std::size_t key = query + 1; key < end();) {
    const std::size_t equals = words.find('=', key);
    if (equals >= end()) return;
    const std::size_t after = std::min(words.find('&', key), end());
    const std::string name = lower(std::string_view(words).substr(key, equals - key));
    const bool is_secret = std::find(kSecretKeys.begin(), kSecretKeys.end(), name) != kSecretKeys.end();
    const bool has_value = equals < after;
    if (is_secret && has_value) words.erase(equals + 1, after - equals - 1);
    key = (is_secret && has_value ? equals + 1 : after) + 1;
  }
}

}  // namespace

std::string shownAddress(const std::string& words) {
  std::string shown = words;
  for (std::size_t at = nextAuthority(shown, 0); at != kNone; at = nextAuthority(shown, at)) {
    removePassword(shown, at);
    removeSecretValues(shown, at);
  }
  return shown;
}

}  // namespace core
}  // namespace facenav
