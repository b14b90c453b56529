#pragma once
// Scrubber: takes out of a text what may tell who a patient or a user is, before the text leaves this
// computer.

#include <set>
#include <string>

namespace facenav::app {

class Scrubber {
 public:
  /// Adds words that must not leave, such as a label: the whole text, and each of its words with at least
  /// three letters.
  void addSecret(const std::string& words);
  /// Replaces every secret by "[name]", whatever its case; one of up to five letters only as a whole word.
  std::string withoutSecrets(const std::string& text) const;
  /// Scrubs a line of a log or a message: quoted words (but commands of facenav), every clause with a path, a
  /// file, a host or an address in it, numbers of addresses, and the secrets. A clause ends at ": " or "; ".
  std::string scrubbed(const std::string& line) const;

 private:
  std::set<std::string> secrets_;  // lower case
};

}  // namespace facenav::app
