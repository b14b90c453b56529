#include "ts_messages.h"

#include <pugixml.hpp>

namespace facenav {
inline namespace core {
namespace {

bool hasElements(const pugi::xml_node& node) {
  for (const auto& child : node)
    if (child.type() == pugi::node_element) return true;
  return false;
}

}  // namespace

TsFile readTs(const std::string& text) {
  pugi::xml_document document;
  document.load_buffer(text.data(), text.size());  // reads up to a fault, if there is one
  const auto root = document.child("TS");
  TsFile file{root.attribute("language").value(), {}};
  for (const auto& context : root.children("context"))
    for (const auto& message : context.children("message")) {
      const auto translation = message.child("translation");
      if (hasElements(translation)) continue;  // plural forms
      const std::string words = translation.child_value();
      file.messages.push_back({context.child_value("name"), message.child_value("source"), words,
                               !translation.attribute("type") && !words.empty()});
    }
  return file;
}

}  // namespace core
}  // namespace facenav
