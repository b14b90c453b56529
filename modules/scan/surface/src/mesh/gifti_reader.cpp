#include "gifti_reader.h"

#include <vtkBase64Utilities.h>
#include <zlib.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <pugixml.hpp>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"

namespace facenav::surface {
namespace {

constexpr std::size_t kMostInflation = 1100;  // zlib makes no more than 1032 bytes of one

/// Holds one array of the file that is read.
struct ArraySource {
  pugi::xml_node node;
  std::filesystem::path path;
  std::string type;
  std::size_t count = 0, each_bytes = 0;

  std::string attribute(const char* name) const { return node.attribute(name).as_string(); }
  [[noreturn]] void refuse(const std::string& words) const {
    throw Error(words, path.string(), "export it again");
  }
};

std::size_t bytesOf(const ArraySource& source) {
  if (source.type == "NIFTI_TYPE_UINT8") return 1;
  if (source.type == "NIFTI_TYPE_FLOAT32" || source.type == "NIFTI_TYPE_INT32") return 4;
  if (source.type == "NIFTI_TYPE_FLOAT64") return 8;
  source.refuse("the GIFTI file holds numbers of an unknown type");
}

std::string fromBase64(const ArraySource& source) {
  std::string text = source.node.child("Data").text().get();
  text.erase(std::remove_if(text.begin(), text.end(), [](unsigned char c) { return std::isspace(c) != 0; }),
             text.end());
  std::string bytes(text.size(), '\0');
  const std::size_t size =
      vtkBase64Utilities::DecodeSafely(reinterpret_cast<const unsigned char*>(text.data()), text.size(),
                                       reinterpret_cast<unsigned char*>(bytes.data()), bytes.size());
  const std::size_t padding = text.size() - std::min(text.size(), text.find_last_not_of('=') + 1);
  if (text.empty() || text.size() % 4 != 0 || size + padding != text.size() / 4 * 3)
    source.refuse("the GIFTI file's data are damaged");
  bytes.resize(size);
  return bytes;
}

std::string inflated(const ArraySource& source, const std::string& packed) {
  if (source.count * source.each_bytes > kMostInflation * packed.size())
    source.refuse("the GIFTI file's data end too early");
  std::string bytes(source.count * source.each_bytes, '\0');
  uLongf size = uLongf(bytes.size());
  if (::uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size,
                   reinterpret_cast<const Bytef*>(packed.data()), uLong(packed.size())) != Z_OK)
    source.refuse("the GIFTI file's data are damaged");
  bytes.resize(size);
  return bytes;
}

/// Bytes of the file that the array names, beside the GIFTI file.
std::string fromOtherFile(const ArraySource& source) {
  const std::filesystem::path name = source.attribute("ExternalFileName");
  std::ifstream stream(source.path.parent_path() / name, std::ios::binary);
  stream.seekg(std::streamoff(source.node.attribute("ExternalFileOffset").as_llong()));
  if (name.empty() || !stream) source.refuse("the file with the GIFTI file's data cannot be read");
  std::string bytes((std::istreambuf_iterator<char>(stream)), {});
  bytes.resize(std::min(bytes.size(), source.count * source.each_bytes));
  return bytes;
}

template <class Number>
double numberAt(const char* bytes, bool is_swapped) {
  char own[sizeof(Number)];
  std::copy(bytes, bytes + sizeof own, own);
  if (is_swapped) std::reverse(own, own + sizeof own);
  Number number;
  std::memcpy(&number, own, sizeof number);
  return double(number);
}

std::vector<double> numbersOf(const ArraySource& source, const std::string& bytes) {
  if (bytes.size() != source.count * source.each_bytes) source.refuse("the GIFTI file's data end too early");
  const bool is_swapped = source.attribute("Endian") == "BigEndian";
  std::vector<double> numbers(source.count);
  for (std::size_t i = 0; i < source.count; ++i) {
    const char* at = bytes.data() + i * source.each_bytes;
    numbers[i] = source.type == "NIFTI_TYPE_FLOAT32"   ? numberAt<float>(at, is_swapped)
                 : source.type == "NIFTI_TYPE_FLOAT64" ? numberAt<double>(at, is_swapped)
                 : source.type == "NIFTI_TYPE_INT32"   ? numberAt<std::int32_t>(at, is_swapped)
                                                       : numberAt<std::uint8_t>(at, is_swapped);
  }
  return numbers;
}

std::vector<double> typedNumbers(const ArraySource& source) {
  const std::string text = source.node.child("Data").text().get();
  std::vector<double> numbers;
  for (const char *at = text.data(), *end = at + text.size();;) {
    while (at != end && std::isspace(static_cast<unsigned char>(*at))) ++at;
    if (at == end) break;
    double number = 0;
    const auto read = std::from_chars(at, end, number);
    if (read.ec != std::errc()) source.refuse("the GIFTI file holds a value that is no number");
    numbers.push_back(number);
    at = read.ptr;
  }
  if (numbers.size() != source.count) source.refuse("the GIFTI file's data end too early");
  return numbers;
}

std::vector<double> decoded(const ArraySource& source) {
  const std::string encoding = source.attribute("Encoding");
  if (encoding == "ASCII") return typedNumbers(source);
  if (encoding == "Base64Binary") return numbersOf(source, fromBase64(source));
  if (encoding == "GZipBase64Binary") return numbersOf(source, inflated(source, fromBase64(source)));
  if (encoding == "ExternalFileBinary") return numbersOf(source, fromOtherFile(source));
  source.refuse("the GIFTI file's data are of an unknown encoding");
}

GiftiArray arrayOf(const pugi::xml_node& node, const std::filesystem::path& path) {
  ArraySource source{node, path, node.attribute("DataType").as_string()};
  source.each_bytes = bytesOf(source);
  GiftiArray array;
  array.intent = source.attribute("Intent");
  for (const auto& system : node.children("CoordinateSystemTransformMatrix"))
    array.dataspaces.push_back(system.child("DataSpace").text().get());
  const int dimensions = node.attribute("Dimensionality").as_int();
  constexpr long long kMost = 1LL << 31;
  const long long rows = node.attribute("Dim0").as_llong(),
                  columns = dimensions == 2 ? node.attribute("Dim1").as_llong() : 1;
  if (dimensions < 1 || dimensions > 2 || rows < 0 || columns < 1 || rows > kMost / columns)
    source.refuse("the GIFTI file holds an array that is no table");
  array.rows = std::size_t(rows), array.columns = std::size_t(columns);
  source.count = array.rows * array.columns;
  array.values = decoded(source);
  if (source.attribute("ArrayIndexingOrder") == "ColumnMajorOrder") {
    const auto by_columns = array.values;
    for (std::size_t row = 0; row < array.rows; ++row)
      for (std::size_t column = 0; column < array.columns; ++column)
        array.values[row * array.columns + column] = by_columns[column * array.rows + row];
  }
  return array;
}

}  // namespace

std::vector<GiftiArray> readGifti(const std::filesystem::path& path) {
  const std::string content = readWholeFile(path);
  pugi::xml_document document;
  const auto parsed = document.load_buffer(content.data(), content.size());
  const auto root = document.child("GIFTI");
  if (!parsed || !root) throw Error("is no readable GIFTI file", path.string(), "export it again");
  std::vector<GiftiArray> arrays;
  for (const auto& node : root.children("DataArray")) arrays.push_back(arrayOf(node, path));
  return arrays;
}

}  // namespace facenav::surface
