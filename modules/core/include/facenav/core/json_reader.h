#pragma once
// JsonReader: a JSON file read strictly. Every value asked for that is missing or of the wrong kind throws an
// Error naming the file and the key ("targets[1].mri_T_target"); keys nobody asks for are ignored, as
// FORMATS.md wants.

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace facenav {
inline namespace core {

class JsonReader {
 public:
  /// Throws Error when the file is missing, not valid JSON (position named), or its root is no object.
  static JsonReader readFile(const std::filesystem::path& path);

  bool has(const std::string& key) const;
  /// The member `key` of an object. Throws Error when it is missing.
  JsonReader at(const std::string& key) const;
  /// The elements of a list. Throws Error when this is no list.
  std::vector<JsonReader> elements() const;
  /// The members of an object. Throws Error when this is no object.
  std::map<std::string, JsonReader> members() const;

  /// Finite number, else Error.
  double number() const;
  int integer() const;
  std::string text() const;
  /// Exactly `count` finite numbers, else Error.
  std::vector<double> numbers(std::size_t count) const;
  /// Throws Error("<what>", "<file>, key <key>"): for a value that is well-formed but wrong.
  [[noreturn]] void refuse(const std::string& what) const;

  ~JsonReader();
  JsonReader(const JsonReader&);

 private:
  struct Document;
  JsonReader(std::shared_ptr<const Document> document, const void* node, std::string key);
  std::shared_ptr<const Document> document_;
  const void* node_;
  std::string key_;
};

}  // namespace core
}  // namespace facenav
