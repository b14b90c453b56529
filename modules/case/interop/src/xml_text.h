#pragma once
// XML of other programs' files, by pugixml: it expands no entities that a document defines.

#include <pugixml.hpp>
#include <string>

#include "facenav/interop/formats.h"

namespace facenav::interop {

/// Parses the content into `document` and returns its root element. Throws Error with the place of the fault.
pugi::xml_node rootOf(pugi::xml_document& document, const Source& source);
/// Appends an attribute; pugixml escapes it.
void setText(pugi::xml_node node, const char* name, const std::string& value);
/// The document with its declaration, UTF-8, four blanks a level.
std::string xmlText(const pugi::xml_document& document, bool has_declaration = true,
                    const char* indent = "    ");
/// The 17 digits of a time in Localite's file names: 20260305102030125.
std::string digitsOf(double clock_s);

}  // namespace facenav::interop
