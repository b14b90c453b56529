#include "ts_messages.h"

#include <map>

namespace facenav {
inline namespace core {
namespace {

/// The letter that an entity stands for; lupdate writes these alone.
std::string letterOf(const std::string& entity) {
  static const std::map<std::string, std::string> kNamed{
      {"amp", "&"}, {"lt", "<"}, {"gt", ">"}, {"quot", "\""}, {"apos", "'"}};
  if (const auto named = kNamed.find(entity); named != kNamed.end()) return named->second;
  return "&" + entity + ";";
}

std::string unescaped(const std::string& xml) {
  std::string text;
  for (std::size_t at = 0; at < xml.size();) {
    const auto end = xml[at] == '&' ? xml.find(';', at) : std::string::npos;
    if (end == std::string::npos) {
      text += xml[at++];
    } else {
      text += letterOf(xml.substr(at + 1, end - at - 1));
      at = end + 1;
    }
  }
  return text;
}

/// An opening tag, and what stands between it and the closing one.
struct Element {
  std::string name, attributes, inside;
  std::size_t inside_at, next;
};

/// The next opening tag from `at` on; its end where there is none.
Element elementFrom(const std::string& xml, std::size_t at) {
  const std::size_t none = std::string::npos;
  for (auto open = xml.find('<', at); open != none; open = xml.find('<', open + 1)) {
    const auto end = xml.find('>', open);
    if (end == none) break;
    if (xml[open + 1] == '/' || xml[open + 1] == '?' || xml[open + 1] == '!') continue;
    const std::string tag = xml.substr(open + 1, end - open - 1);
    const auto blank = tag.find(' ');
    Element element{
        tag.substr(0, blank), blank == none ? std::string() : tag.substr(blank), {}, end + 1, end + 1};
    const auto close = xml.find("</" + element.name + ">", end);
    if (close != none) element.inside = xml.substr(end + 1, close - end - 1);
    return element;
  }
  return {{}, {}, {}, none, none};
}

std::string attribute(const std::string& attributes, const std::string& name) {
  const auto at = attributes.find(" " + name + "=\"");
  if (at == std::string::npos) return {};
  const auto begin = at + name.size() + 3;
  return attributes.substr(begin, attributes.find('"', begin) - begin);
}

}  // namespace

TsFile readTs(const std::string& text) {
  TsFile file;
  std::string context, source;
  for (auto element = elementFrom(text, 0); element.next != std::string::npos;
       element = elementFrom(text, element.next)) {
    if (element.name == "TS") file.language = attribute(element.attributes, "language");
    if (element.name == "name") context = unescaped(element.inside);
    if (element.name == "source") source = unescaped(element.inside);
    if (element.name != "translation" || element.inside.find('<') != std::string::npos) continue;
    const bool is_finished = attribute(element.attributes, "type").empty() && !element.inside.empty();
    file.messages.push_back({context, source, unescaped(element.inside), is_finished});
  }
  return file;
}

}  // namespace core
}  // namespace facenav
