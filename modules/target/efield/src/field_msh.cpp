#include "facenav/efield/field_msh.h"

#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"

namespace facenav::efield {
namespace {

constexpr int kGreySurface = 1002, kGreyVolume = 2;  // SimNIBS's tags
constexpr int kTriangle = 2, kTetrahedron = 4, kPoint = 15;
constexpr std::size_t kMost = 200'000'000;  // nodes, elements or values that a file may announce

struct Element {
  int type = 0, tag = 0;
  std::array<int, 4> nodes{};  // ids
  int corners() const { return type == kTetrahedron ? 4 : 3; }
};

/// One block of data, on nodes or elements.
struct DataBlock {
  int components = 0;
  std::map<int, Eigen::Vector3d> values;  // by id
};

struct Mesh {
  std::map<int, Eigen::Vector3d> nodes;
  std::map<int, Element> elements;
  std::map<std::string, DataBlock> on_nodes, on_elements;
};

/// Reads numbers one after the other, as text or binary. Throws Error at the file's end.
class Reader {
 public:
  Reader(std::string content, const std::filesystem::path& path)
      : content_(std::move(content)), path_(path) {}

  bool is_binary = false;

  std::optional<std::string> section() {
    while (at_ < content_.size()) {
      const std::string text = line();
      if (!text.empty() && text[0] == '$' && text.rfind("$End", 0) != 0) return text.substr(1);
    }
    return std::nullopt;
  }
  std::string line() {
    if (at_ >= content_.size()) refuse("ends too early");
    const auto end = std::min(content_.find('\n', at_), content_.size());
    std::string text = content_.substr(at_, end - at_);
    at_ = end + 1;
    if (!text.empty() && text.back() == '\r') text.pop_back();
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
  reader.is_binary = reader.textNumber() != 0;
  if (version < 2 || version >= 3) reader.refuse("is not of gmsh's format 2");
  reader.endLine();
}

void readNodes(Reader& reader, Mesh& mesh) {
  const std::size_t count = reader.count();
  reader.endLine();
  for (std::size_t i = 0; i < count; ++i) {
    const int id = reader.integer();
    Eigen::Vector3d p;
    for (int c = 0; c < 3; ++c) p[c] = reader.real();
    mesh.nodes[id] = p;
  }
}

Element elementOf(Reader& reader, int type, int tags) {
  Element element;
  element.type = type;
  for (int t = 0; t < tags; ++t) {
    const int tag = reader.integer();
    if (t == 0) element.tag = tag;
  }
  if (type == kPoint) return reader.integer(), element;
  for (int c = 0; c < element.corners(); ++c) element.nodes[std::size_t(c)] = reader.integer();
  return element;
}

void readElements(Reader& reader, Mesh& mesh) {
  const std::size_t count = reader.count();
  reader.endLine();
  for (std::size_t read = 0; read < count;) {
    const int first = reader.integer(), second = reader.integer();
    // Text: id, type, tags. Binary: blocks of type, count, tags, each element beginning with its id.
    const int type = reader.is_binary ? first : second;
    const int together = reader.is_binary ? second : 1, tags = reader.integer();
    if ((type != kTriangle && type != kTetrahedron && type != kPoint) || together < 1 || tags < 0 ||
        tags > 16)
      reader.refuse("holds elements other than triangles and tetrahedra");
    for (int i = 0; i < together; ++i, ++read) {
      const int id = reader.is_binary ? reader.integer() : first;
      mesh.elements[id] = elementOf(reader, type, tags);
    }
  }
}

void readData(Reader& reader, std::map<std::string, DataBlock>& blocks) {
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
  if (integers.size() < 3 || (integers[1] != 1 && integers[1] != 3))
    reader.refuse("holds data of an unknown kind");
  DataBlock& block = blocks[name];
  block.components = int(integers[1]);
  for (std::size_t i = 0; i < integers[2]; ++i) {
    const int id = reader.integer();
    Eigen::Vector3d value = Eigen::Vector3d::Zero();
    for (int c = 0; c < block.components; ++c) value[c] = reader.real();
    block.values[id] = value;
  }
}

Mesh readMsh(Reader& reader) {
  Mesh mesh;
  bool has_format = false;
  while (const auto name = reader.section()) {
    if (*name == "MeshFormat") {
      readFormat(reader);
      has_format = true;
    } else if (!has_format) {
      reader.refuse("does not begin as a gmsh file");
    } else if (*name == "Nodes") {
      readNodes(reader, mesh);
    } else if (*name == "Elements") {
      readElements(reader, mesh);
    } else if (*name == "NodeData") {
      readData(reader, mesh.on_nodes);
    } else if (*name == "ElementData") {
      readData(reader, mesh.on_elements);
    }
  }
  if (!has_format) reader.refuse("is no gmsh file");
  return mesh;
}

/// Ids of the elements that count: grey matter's surface, else its volume, else all.
std::vector<int> greyElements(const Mesh& mesh) {
  std::vector<int> surface, volume, all;
  for (const auto& [id, element] : mesh.elements) {
    if (element.type == kPoint) continue;
    all.push_back(id);
    if (element.type == kTriangle && element.tag == kGreySurface) surface.push_back(id);
    if (element.type == kTetrahedron && element.tag == kGreyVolume) volume.push_back(id);
  }
  return !surface.empty() ? surface : !volume.empty() ? volume : all;
}

using Place = std::pair<int, Eigen::Vector3d>;  // id and place

std::vector<Place> nodePlaces(const Mesh& mesh, const Reader& reader) {
  std::map<int, Eigen::Vector3d> places;
  for (const int id : greyElements(mesh)) {
    const Element& element = mesh.elements.at(id);
    if (element.type != kTriangle) return {mesh.nodes.begin(), mesh.nodes.end()};
    for (int c = 0; c < 3; ++c) {
      const auto node = mesh.nodes.find(element.nodes[std::size_t(c)]);
      if (node == mesh.nodes.end()) reader.refuse("has a triangle of a node that is not there");
      places.insert(*node);
    }
  }
  if (places.empty()) return {mesh.nodes.begin(), mesh.nodes.end()};
  return {places.begin(), places.end()};
}

std::vector<Place> elementPlaces(const Mesh& mesh, const Reader& reader) {
  std::vector<Place> places;
  for (const int id : greyElements(mesh)) {
    const Element& element = mesh.elements.at(id);
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (int c = 0; c < element.corners(); ++c) {
      const auto node = mesh.nodes.find(element.nodes[std::size_t(c)]);
      if (node == mesh.nodes.end()) reader.refuse("has an element of a node that is not there");
      middle += node->second / element.corners();
    }
    places.emplace_back(id, middle);
  }
  return places;
}

FieldSamples samplesOf(const DataBlock& block, const std::vector<Place>& places, const Reader& reader) {
  std::vector<Eigen::Vector3d> points, values;
  for (const auto& [id, place] : places)
    if (const auto found = block.values.find(id); found != block.values.end()) {
      points.push_back(place);
      values.push_back(found->second);
    }
  if (points.empty()) reader.refuse("holds no value of the field on the grey matter");
  const auto count = Eigen::Index(points.size());
  FieldSamples samples;
  samples.points_mm = Eigen::Map<const Eigen::Matrix3Xd>(points[0].data(), 3, count);
  const Eigen::Matrix3Xd field = Eigen::Map<const Eigen::Matrix3Xd>(values[0].data(), 3, count);
  samples.magnitude = field.colwise().norm().transpose();
  if (block.components == 3) samples.field = field;
  return samples;
}

template <class T>
void put(std::string& content, T value) {
  content.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void putData(std::string& content, const std::string& name, const Eigen::MatrixXd& values) {
  content += "$NodeData\n1\n\"" + name + "\"\n1\n0\n4\n0\n" + std::to_string(values.rows()) + "\n" +
             std::to_string(values.cols()) + "\n0\n";
  for (Eigen::Index i = 0; i < values.cols(); ++i) {
    put(content, int(i + 1));
    for (Eigen::Index c = 0; c < values.rows(); ++c) put(content, values(c, i));
  }
  content += "\n$EndNodeData\n";
}

}  // namespace

void writeFieldMsh(const surface::TriangleMesh& mesh, const Eigen::Matrix3Xd& field,
                   const std::filesystem::path& path, FileAccess access) {
  FACENAV_EXPECT(field.cols() == Eigen::Index(mesh.vertices_mm.size()), "one vector a vertex");
  std::string content = "$MeshFormat\n2.2 1 8\n";
  put(content, int(1));
  content += "\n$EndMeshFormat\n$Nodes\n" + std::to_string(mesh.vertices_mm.size()) + "\n";
  int id = 0;
  for (const auto& p : mesh.vertices_mm) {
    put(content, ++id);
    for (int c = 0; c < 3; ++c) put(content, p[c]);
  }
  content += "\n$EndNodes\n$Elements\n" + std::to_string(mesh.triangles.size()) + "\n";
  for (const int word : {kTriangle, int(mesh.triangles.size()), 2}) put(content, word);
  id = 0;
  for (const auto& t : mesh.triangles)
    for (const int word : {++id, kGreySurface, kGreySurface, t[0] + 1, t[1] + 1, t[2] + 1})
      put(content, word);
  content += "\n$EndElements\n";
  putData(content, "E", field);
  putData(content, "magnE", field.colwise().norm());
  writeWholeFile(path, content, access);
}

FieldSamples readFieldMsh(const std::filesystem::path& path) {
  Reader reader(readWholeFile(path), path);
  const Mesh mesh = readMsh(reader);
  for (const char* name : {"E", "magnE"}) {
    if (const auto block = mesh.on_nodes.find(name); block != mesh.on_nodes.end())
      return samplesOf(block->second, nodePlaces(mesh, reader), reader);
    if (const auto block = mesh.on_elements.find(name); block != mesh.on_elements.end())
      return samplesOf(block->second, elementPlaces(mesh, reader), reader);
  }
  throw Error("the mesh holds no field named E or magnE", path.string(), "export the field with the mesh");
}

}  // namespace facenav::efield
