#pragma once
// JsonReader: strict reader of a JSON file. If a requested value is missing or has the wrong type, it throws
// an Error that names the file and the key ("targets[1].mri_T_target"). Keys that nobody requests are
// ignored, as resources/doc/formats.md specifies.

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
  /// Throws Error if the file is missing, is not valid JSON (the message gives the position), or its root is
  /// not an object.
  static JsonReader readFile(const std::filesystem::path& path);
  /// Reads a JSON text; errors name it as `where`. Throws Error as readFile() does.
  static JsonReader readText(const std::string& text, const std::filesystem::path& where);

  bool has(const std::string& key) const;
  /// True for a text, and for null.
  bool isText() const;
  bool isNull() const;
  /// The member `key` of an object. Throws Error if it is missing; for a file the message names the page of
  /// formats.
  JsonReader at(const std::string& key) const;
  /// The elements of a list. Throws Error if this is not a list.
  std::vector<JsonReader> elements() const;
  /// The members of an object. Throws Error if this is not an object.
  std::map<std::string, JsonReader> members() const;

  /// A finite number of usable size (number_text.h); throws Error otherwise.
  double number() const;
  int integer() const;
  std::string text() const;
  /// Exactly `count` finite numbers; throws Error otherwise.
  std::vector<double> numbers(std::size_t count) const;
  /// Throws Error("<what>", "<file>, key <key>"), for a value of the right type with a wrong content.
  [[noreturn]] void refuse(const std::string& what) const;

  ~JsonReader();
  JsonReader(const JsonReader&);

 private:
  struct Document;
  static JsonReader readDocument(const std::string& text, const std::filesystem::path& path, bool is_file);
  JsonReader(std::shared_ptr<const Document> document, const void* node, std::string key);
  std::shared_ptr<const Document> document_;
  const void* node_;
  std::string key_;
};

}  // namespace core
}  // namespace facenav
