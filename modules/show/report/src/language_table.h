#pragma once
// The catalogues of resources/languages, which the build compiles in. Private to report.

#include <string_view>
#include <vector>

namespace facenav::report {

struct LanguageFile {
  std::string_view code, catalogue;  // "ja", the text of its .ts file
};

const std::vector<LanguageFile>& languageTable();

}  // namespace facenav::report
