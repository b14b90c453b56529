#include "facenav/core/json_reader.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/core/whole_file.h"

namespace facenav {
inline namespace core {
namespace {

const nlohmann::json& json(const void* node) { return *static_cast<const nlohmann::json*>(node); }

}  // namespace

struct JsonReader::Document {
  std::filesystem::path path;
  nlohmann::json root;
  bool is_file = false;  // a whole file; else a line of one
};

JsonReader::JsonReader(std::shared_ptr<const Document> document, const void* node, std::string key)
    : document_(std::move(document)), node_(node), key_(std::move(key)) {}
JsonReader::JsonReader(const JsonReader&) = default;
JsonReader::~JsonReader() = default;

JsonReader JsonReader::readFile(const std::filesystem::path& path) {
  return readDocument(readWholeFile(path), path, true);
}

JsonReader JsonReader::readText(const std::string& text, const std::filesystem::path& path) {
  return readDocument(text, path, false);
}

JsonReader JsonReader::readDocument(const std::string& text, const std::filesystem::path& path,
                                    bool is_file) {
  auto document = std::make_shared<Document>();
  document->path = path;
  document->is_file = is_file;
  try {
    document->root = nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& fault) {
    throw Error("is not valid JSON (at byte " + std::to_string(fault.byte) + ")", path.string(),
                "restore the file or write it again");
  } catch (const nlohmann::json::exception&) {
    throw Error("is not valid JSON (a number out of range)", path.string(),
                "restore the file or write it again");
  }
  if (!document->root.is_object()) throw Error("a JSON object was expected", path.string());
  const void* root = &document->root;
  return JsonReader(std::move(document), root, "");
}

void JsonReader::refuse(const std::string& what) const {
  const std::string file = document_->path.string();
  throw Error(what, key_.empty() ? file : file + ", key '" + key_ + "'");
}

bool JsonReader::has(const std::string& key) const {
  return json(node_).is_object() && json(node_).contains(key);
}

bool JsonReader::isText() const { return json(node_).is_string(); }

bool JsonReader::isNull() const { return json(node_).is_null(); }

JsonReader JsonReader::at(const std::string& key) const {
  if (!json(node_).is_object()) refuse("an object was expected");
  const JsonReader child(document_, node_, key_.empty() ? key : key_ + "." + key);
  if (!json(node_).contains(key))
    child.refuse(document_->is_file ? "required key is missing; see resources/doc/formats.md"
                                    : "required key is missing");
  return JsonReader(document_, &json(node_).at(key), child.key_);
}

std::vector<JsonReader> JsonReader::elements() const {
  if (!json(node_).is_array()) refuse("a list was expected");
  std::vector<JsonReader> elements;
  for (const auto& element : json(node_))
    elements.push_back(JsonReader(document_, &element, key_ + "[" + std::to_string(elements.size()) + "]"));
  return elements;
}

std::map<std::string, JsonReader> JsonReader::members() const {
  if (!json(node_).is_object()) refuse("an object was expected");
  std::map<std::string, JsonReader> members;
  for (const auto& item : json(node_).items()) members.emplace(item.key(), at(item.key()));
  return members;
}

double JsonReader::number() const {
  if (!json(node_).is_number()) refuse("a number was expected");
  const double value = json(node_).get<double>();
  if (!std::isfinite(value)) refuse("a finite number was expected");
  if (!isUsableNumber(value)) refuse("the number is too large");
  return value;
}

int JsonReader::integer() const {
  const double value = number();
  if (value != std::floor(value) || std::abs(value) > 2e9) refuse("a whole number was expected");
  return int(value);
}

std::string JsonReader::text() const {
  if (!json(node_).is_string()) refuse("a text was expected");
  return json(node_).get<std::string>();
}

std::vector<double> JsonReader::numbers(std::size_t count) const {
  std::vector<double> values;
  if (!json(node_).is_array() || json(node_).size() != count)
    refuse("a list of " + std::to_string(count) + " numbers was expected");
  for (const auto& element : elements()) values.push_back(element.number());
  return values;
}

}  // namespace core
}  // namespace facenav
