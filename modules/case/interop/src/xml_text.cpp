#include "xml_text.h"

#include <sstream>

#include "facenav/core/number_text.h"
#include "text.h"

namespace facenav::interop {

pugi::xml_node rootOf(pugi::xml_document& document, const Source& source) {
  const auto result = document.load_buffer(source.content.data(), source.content.size());
  if (!result)
    refuseFile(source.path, formatted("byte %lld", (long long)result.offset),
               std::string("is damaged XML: ") + result.description(), "copy or export it again");
  const auto root = document.document_element();
  if (!root) refuseFile(source.path, "", "is XML without an element", "copy or export it again");
  return root;
}

void setText(pugi::xml_node node, const char* name, const std::string& value) {
  node.append_attribute(name).set_value(value.c_str());
}

std::string xmlText(const pugi::xml_document& document, bool has_declaration, const char* indent) {
  std::ostringstream stream;
  if (has_declaration) stream << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  document.save(stream, indent, pugi::format_indent | pugi::format_no_declaration, pugi::encoding_utf8);
  return stream.str();
}

std::string digitsOf(double clock_s) {
  std::string digits;
  for (const char c : dateOf(clock_s) + timeOf(clock_s))
    if (c >= '0' && c <= '9') digits += c;
  return digits;
}

}  // namespace facenav::interop
