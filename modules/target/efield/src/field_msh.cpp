#include "facenav/efield/field_msh.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "msh/msh_reader.h"

namespace facenav::efield {
namespace {

// SimNIBS's tags.
constexpr int kWhiteVolume = 1, kGreyVolume = 2, kGreySurface = 1002, kScalpSurface = 1005;
constexpr int kTriangle = 2;  // gmsh's number of the type
// SimNIBS 4, 3, and its meshes of the central surface.
const std::vector<std::string> kFieldNames{"E", "magnE", "normE", "E_magn", "E_norm"};

using Ids = std::vector<int>;

/// Ids of the elements of some kind.
template <class Predicate>
Ids elementsWhere(const Msh& mesh, Predicate is_wanted) {
  Ids ids;
  for (const auto& [id, element] : mesh.elements.all())
    if (is_wanted(element)) ids.push_back(id);
  return ids;
}

bool isTriangle(const MshElement& element) { return element.corners == 3; }

Ids trianglesOf(const Msh& mesh, int tag) {
  return elementsWhere(mesh, [&](const MshElement& e) { return isTriangle(e) && e.tag == tag; });
}

Ids tetrahedraOf(const Msh& mesh, std::initializer_list<int> tags) {
  return elementsWhere(mesh, [&](const MshElement& e) {
    return !isTriangle(e) && std::find(tags.begin(), tags.end(), e.tag) != tags.end();
  });
}

/// Block of a field, and whether it is on nodes.
struct FoundField {
  const MshData* data = nullptr;
  bool is_on_nodes = false;
};

FoundField fieldOf(const Msh& mesh, const std::filesystem::path& path) {
  for (const auto& name : kFieldNames) {
    if (const auto at = mesh.on_nodes.find(name); at != mesh.on_nodes.end()) return {&at->second, true};
    if (const auto at = mesh.on_elements.find(name); at != mesh.on_elements.end()) return {&at->second};
  }
  throw Error("the mesh holds no field named E or magnE", path.string(), "export the field with the mesh");
}

std::vector<Eigen::Vector3d> cornersOf(const Msh& mesh, const MshElement& element,
                                       const std::filesystem::path& path) {
  std::vector<Eigen::Vector3d> corners;
  for (int c = 0; c < element.corners; ++c) {
    const auto* node = mesh.nodes.find(element.nodes[std::size_t(c)]);
    if (!node)
      throw Error("the mesh has an element of a node that is not there", path.string(),
                  "export the field again");
    corners.push_back(*node);
  }
  return corners;
}

/// Area in mm2 or volume in mm3.
double sizeOf(const std::vector<Eigen::Vector3d>& p) {
  const Eigen::Vector3d across = (p[1] - p[0]).cross(p[2] - p[0]);
  return p.size() == 3 ? across.norm() / 2 : std::abs(across.dot(p[3] - p[0])) / 6;
}

/// Places with values, as they are collected.
class Collected {
 public:
  explicit Collected(const MshData& data) : data_(data) {}
  void add(int id, const Eigen::Vector3d& place_mm, double weight) {
    const auto* value = data_.values.find(id);
    if (!value) return;
    places_.push_back(place_mm);
    values_.push_back(*value);
    weights_.push_back(weight);
  }
  bool empty() const { return places_.empty(); }
  FieldSamples samples() const {
    FieldSamples samples;
    if (empty()) return samples;
    const auto count = Eigen::Index(places_.size());
    samples.points_mm = Eigen::Map<const Eigen::Matrix3Xd>(places_[0].data(), 3, count);
    const Eigen::Matrix3Xd field = Eigen::Map<const Eigen::Matrix3Xd>(values_[0].data(), 3, count);
    samples.magnitude = field.colwise().norm().transpose();
    samples.weight = Eigen::Map<const Eigen::VectorXd>(weights_.data(), count);
    if (data_.components == 3) samples.field = field;
    return samples;
  }

 private:
  const MshData& data_;
  std::vector<Eigen::Vector3d> places_, values_;
  std::vector<double> weights_;
};

/// Nodes of the elements; all nodes if there are no elements.
std::set<int> nodesOf(const Msh& mesh, const Ids& elements) {
  std::set<int> nodes;
  for (const int id : elements) {
    const MshElement& element = *mesh.elements.find(id);
    nodes.insert(element.nodes.begin(), element.nodes.begin() + element.corners);
  }
  if (elements.empty())
    for (const auto& [id, place] : mesh.nodes.all()) nodes.insert(id);
  return nodes;
}

FieldSamples samplesOn(const Msh& mesh, const FoundField& field, const Ids& elements,
                       const std::filesystem::path& path) {
  Collected collected(*field.data);
  if (field.is_on_nodes) {
    for (const int id : nodesOf(mesh, elements))
      if (const auto* place = mesh.nodes.find(id)) collected.add(id, *place, 1);
  } else {
    for (const int id : elements) {
      const auto corners = cornersOf(mesh, *mesh.elements.find(id), path);
      Eigen::Vector3d middle = Eigen::Vector3d::Zero();
      for (const auto& corner : corners) middle += corner / double(corners.size());
      collected.add(id, middle, sizeOf(corners));
    }
  }
  return collected.samples();
}

/// Takes the grey matter's surface if it has values, else its volume, else all.
FieldSamples greySamples(const Msh& mesh, const FoundField& field, const std::filesystem::path& path) {
  for (const Ids& ids : {trianglesOf(mesh, kGreySurface), tetrahedraOf(mesh, {kGreyVolume})}) {
    if (ids.empty()) continue;
    auto samples = samplesOn(mesh, field, ids, path);
    if (samples.magnitude.size() > 0) return samples;
  }
  auto samples = samplesOn(mesh, field, elementsWhere(mesh, [](const MshElement&) { return true; }), path);
  if (samples.magnitude.size() > 0) return samples;
  throw Error("the mesh holds no value of the field on the grey matter", path.string(),
              "export the field again");
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

/// Header and nodes.
std::string startWith(const Eigen::Ref<const Eigen::Matrix3Xd>& places_mm) {
  std::string content = "$MeshFormat\n2.2 1 8\n";
  put(content, int(1));
  content += "\n$EndMeshFormat\n$Nodes\n" + std::to_string(places_mm.cols()) + "\n";
  for (Eigen::Index i = 0; i < places_mm.cols(); ++i) {
    put(content, int(i + 1));
    for (int c = 0; c < 3; ++c) put(content, places_mm(c, i));
  }
  return content + "\n$EndNodes\n";
}

}  // namespace

void writeFieldMsh(const surface::TriangleMesh& mesh, const Eigen::Matrix3Xd& field,
                   const std::filesystem::path& path, FileAccess access) {
  FACENAV_EXPECT(field.cols() == Eigen::Index(mesh.vertices_mm.size()), "one vector a vertex");
  const Eigen::Map<const Eigen::Matrix3Xd> places(
      mesh.vertices_mm.empty() ? nullptr : mesh.vertices_mm[0].data(), 3, field.cols());
  std::string content = startWith(places);
  content += "$Elements\n" + std::to_string(mesh.triangles.size()) + "\n";
  for (const int word : {kTriangle, int(mesh.triangles.size()), 2}) put(content, word);
  int id = 0;
  for (const auto& t : mesh.triangles)
    for (const int word : {++id, kGreySurface, kGreySurface, t[0] + 1, t[1] + 1, t[2] + 1})
      put(content, word);
  content += "\n$EndElements\n";
  putData(content, "E", field);
  putData(content, "magnE", field.colwise().norm());
  writeWholeFile(path, content, access);
}

void writeFieldPointsMsh(const FieldSamples& samples, const std::filesystem::path& path, FileAccess access) {
  std::string content = startWith(samples.points_mm);
  if (samples.field.cols() > 0) putData(content, "E", samples.field);
  putData(content, "magnE", samples.magnitude.transpose());
  writeWholeFile(path, content, access);
}

FieldSamples readFieldMsh(const std::filesystem::path& path) {
  const Msh mesh = readMsh(path, kFieldNames);
  return greySamples(mesh, fieldOf(mesh, path), path);
}

HeadFieldSamples readHeadFieldMsh(const std::filesystem::path& path) {
  const Msh mesh = readMsh(path, kFieldNames);
  const FoundField field = fieldOf(mesh, path);
  HeadFieldSamples result;
  const Ids grey = tetrahedraOf(mesh, {kGreyVolume});
  if (!grey.empty()) result.grey = samplesOn(mesh, field, grey, path);
  result.fills_brain = result.grey.magnitude.size() > 0;
  if (!result.fills_brain) result.grey = greySamples(mesh, field, path);
  result.brain = result.fills_brain
                     ? samplesOn(mesh, field, tetrahedraOf(mesh, {kWhiteVolume, kGreyVolume}), path)
                     : result.grey;
  const Ids scalp = trianglesOf(mesh, kScalpSurface);
  if (scalp.empty()) return result;
  for (const int node : nodesOf(mesh, scalp))
    if (const auto* place = mesh.nodes.find(node)) result.scalp_mm.push_back(*place);
  return result;
}

}  // namespace facenav::efield
