#include "msh_reader.h"

#include <cmath>
#include <cstring>
#include <optional>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"

namespace facenav::efield {
namespace {

constexpr std::size_t kMost = 200'000'000;  // nodes, elements or values that a file may announce
constexpr int kTriangle = 2, kTetrahedron = 4;

/// Nodes of an element, by gmsh's number of its type; 0: not known.
int nodesOf(int type) {
  switch (type) {
    case 1:
      return 2;  // line
    case kTriangle:
      return 3;
    case 3:
      return 4;  // quadrangle
    case kTetrahedron:
      return 4;
    case 5:
      return 8;  // hexahedron
    case 6:
      return 6;  // prism
    case 7:
      return 5;  // pyramid
    case 8:
      return 3;  // line, triangle and tetrahedron of second order
    case 9:
      return 6;
    case 11:
      return 10;
    case 15:
      return 1;  // point
    default:
      return 0;
  }
}

/// Reads numbers one after the other, as text or binary. Throws Error at the file's end.
class Reader {
 public:
  Reader(std::string content, const std::filesystem::path& path)
      : content_(std::move(content)), path_(path) {}

  bool is_binary = false;

  /// Name of the next section; nothing at the end.
  std::optional<std::string> section() {
    while (at_ < content_.size()) {
      const std::string text = line();
      if (!text.empty() && text[0] == '$' && text.rfind("$End", 0) != 0) return text.substr(1);
    }
    return std::nullopt;
  }
  /// Goes to the end of a section whose content is not read.
  void skip(const std::string& section) {
    const auto end = content_.find("$End" + section, at_);
    if (end != std::string::npos) at_ = end;
  }
  std::string line() {
    if (at_ >= content_.size()) refuse("ends too early");
    const auto end = std::min(content_.find('\n', at_), content_.size());
    std::string text = content_.substr(at_, end - at_);
    at_ = end + 1;
    while (!text.empty() && (text.back() == '\r' || text.back() == ' ')) text.pop_back();
    return text;
  }
  /// A number in text, also in a binary file.
  double textNumber() {
    char* end = nullptr;
    const char* begin = content_.c_str() + std::min(at_, content_.size());
    const double value = std::strtod(begin, &end);
    if (end == begin) refuse("holds a word where a number was expected");
    at_ += std::size_t(end - begin);
    return value;
  }
  int integer() { return is_binary ? raw<int>() : int(textNumber()); }
  double real() {
    const double value = is_binary ? raw<double>() : textNumber();
    if (!std::isfinite(value)) refuse("holds a value that is no number");
    return value;
  }
  std::size_t count() {
    const double value = textNumber();
    if (!(value >= 0 && value <= double(kMost))) refuse("announces an impossible number of entries");
    return std::size_t(value);
  }
  /// Ends the line of the last number of text.
  void endLine() {
    if (at_ < content_.size()) line();
  }
  [[noreturn]] void refuse(const std::string& what) const {
    throw Error("the mesh " + what, path_.string(), "export the field again");
  }

 private:
  template <class T>
  T raw() {
    if (at_ + sizeof(T) > content_.size()) refuse("ends too early");
    T value;
    std::memcpy(&value, content_.data() + at_, sizeof(T));
    at_ += sizeof(T);
    return value;
  }
  std::string content_;
  std::filesystem::path path_;
  std::size_t at_ = 0;
};

void readFormat(Reader& reader) {
  const double version = reader.textNumber();
  const bool is_binary = reader.textNumber() != 0;
  const double bytes = reader.textNumber();
  if (version < 2 || version >= 3) reader.refuse("is not of gmsh's format 2");
  if (is_binary && bytes != sizeof(double)) reader.refuse("holds numbers of another size than 8 bytes");
  reader.endLine();
  reader.is_binary = is_binary;
  if (is_binary && reader.integer() != 1) reader.refuse("has the byte order of another machine");
}

void readNodes(Reader& reader, Msh& mesh) {
  const std::size_t count = reader.count();
  reader.endLine();
  for (std::size_t i = 0; i < count; ++i) {
    const int id = reader.integer();
    Eigen::Vector3d p;
    for (int c = 0; c < 3; ++c) p[c] = reader.real();
    mesh.nodes.add(id, p);
  }
  mesh.nodes.sort();
}

void readElement(Reader& reader, int id, int type, int tags, Msh& mesh) {
  MshElement element;
  element.corners = nodesOf(type);
  for (int t = 0; t < tags; ++t) {
    const int tag = reader.integer();
    if (t == 0) element.tag = tag;
  }
  for (int c = 0; c < element.corners; ++c) {
    const int node = reader.integer();
    if (c < 4) element.nodes[std::size_t(c)] = node;
  }
  if (type == kTriangle || type == kTetrahedron) mesh.elements.add(id, element);
}

void readElements(Reader& reader, Msh& mesh) {
  const std::size_t count = reader.count();
  reader.endLine();
  for (std::size_t read = 0; read < count;) {
    const int first = reader.integer(), second = reader.integer();
    // Text: id, type, tags. Binary: blocks of type, count, tags, each element beginning with its id.
    const int type = reader.is_binary ? first : second;
    const int together = reader.is_binary ? second : 1, tags = reader.integer();
    if (nodesOf(type) == 0 || together < 1 || tags < 0 || tags > 16)
      reader.refuse("holds elements of an unknown kind");
    for (int i = 0; i < together; ++i, ++read)
      readElement(reader, reader.is_binary ? reader.integer() : first, type, tags, mesh);
  }
  mesh.elements.sort();
}

void readData(Reader& reader, const std::vector<std::string>& wanted, const std::string& section,
              std::map<std::string, MshData>& blocks) {
  std::string name;
  const std::size_t names = reader.count();
  reader.endLine();
  for (std::size_t i = 0; i < names; ++i) {
    const std::string text = reader.line();
    if (i == 0) name = text.size() > 1 && text[0] == '"' ? text.substr(1, text.size() - 2) : text;
  }
  for (std::size_t reals = reader.count(); reals > 0; --reals) reader.textNumber();
  std::vector<std::size_t> integers(reader.count());
  for (auto& integer : integers) integer = reader.count();
  reader.endLine();
  if (integers.size() < 3) reader.refuse("holds data of an unknown kind");
  const bool is_read = integers[1] == 1 || integers[1] == 3;
  if (!is_read || std::find(wanted.begin(), wanted.end(), name) == wanted.end()) return reader.skip(section);
  MshData& block = blocks[name];
  block.components = int(integers[1]);
  for (std::size_t i = 0; i < integers[2]; ++i) {
    const int id = reader.integer();
    Eigen::Vector3d value = Eigen::Vector3d::Zero();
    for (int c = 0; c < block.components; ++c) value[c] = reader.real();
    block.values.add(id, value);
  }
  block.values.sort();
}

}  // namespace

Msh readMsh(const std::filesystem::path& path, const std::vector<std::string>& data_names) {
  Reader reader(readWholeFile(path), path);
  Msh mesh;
  bool has_format = false;
  while (const auto name = reader.section()) {
    if (*name == "MeshFormat") {
      readFormat(reader);
      has_format = true;
    } else if (!has_format) {
      if (*name != "Comments") reader.refuse("does not begin as a gmsh file");
      reader.skip(*name);
    } else if (*name == "Nodes") {
      readNodes(reader, mesh);
    } else if (*name == "Elements") {
      readElements(reader, mesh);
    } else if (*name == "NodeData") {
      readData(reader, data_names, *name, mesh.on_nodes);
    } else if (*name == "ElementData") {
      readData(reader, data_names, *name, mesh.on_elements);
    } else {
      reader.skip(*name);
    }
  }
  if (!has_format) reader.refuse("is no gmsh file");
  return mesh;
}

}  // namespace facenav::efield
