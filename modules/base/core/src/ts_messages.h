#pragma once
// Reads the messages of a .ts file (Qt Linguist), as lupdate writes it. Private to core.

#include <string>
#include <vector>

namespace facenav {
inline namespace core {

struct TsMessage {
  std::string context, source, translation;
  bool is_finished;
};

struct TsFile {
  std::string language;  // "ja"
  std::vector<TsMessage> messages;
};

/// Reads the text of a file, up to a fault if it has one. Messages with plural forms are left out: modules
/// write none.
TsFile readTs(const std::string& text);

}  // namespace core
}  // namespace facenav
