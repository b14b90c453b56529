#pragma once
// A head's mesh with an electric field, laid out as SimNIBS writes it: a ball of scalp, tetrahedra of white
// and grey matter in the brain, the field on all elements.

#include <functional>
#include <string>

#include "support/ball_mesh.h"

namespace facenav::testing {

struct FieldMeshLayout {
  bool is_binary = true;
  bool ends_lines = false;               // before $EndNodes and $EndElements; SimNIBS does not
  bool has_vectors = true;               // "E" beside "magnE"
  double scalp_mm = 90, brain_mm = 70;   // radii
  int first_id = 1;                      // of nodes and elements
  Eigen::Vector3d shift_mm = {0, 0, 0};  // of the whole head
};

/// V/m at a place before the shift.
using MadeField = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;

/// Writes numbers as text or binary.
class MeshText {
 public:
  explicit MeshText(bool is_binary) : is_binary_(is_binary) {}
  void integers(const std::vector<int>& values) {
    for (const int value : values) put(value, std::to_string(value));
  }
  void reals(const double* values, int count) {
    for (int i = 0; i < count; ++i) {
      char text[40];
      std::snprintf(text, sizeof text, "%.16g", values[i]);
      put(values[i], text);
    }
  }
  void line(const std::string& text) { content += text + "\n"; }
  void endEntry() {
    if (!is_binary_) content.back() = '\n';
  }
  std::string content;

 private:
  template <class T>
  void put(T value, const std::string& text) {
    if (is_binary_)
      content.append(reinterpret_cast<const char*>(&value), sizeof value);
    else
      content += text + " ";
  }
  bool is_binary_;
};

struct MadeElements {
  std::vector<Eigen::Vector3d> nodes;
  std::vector<std::vector<int>> elements;  // numbers of nodes
  std::vector<int> tags;
};

inline MadeElements elementsOf(const FieldMeshLayout& layout) {
  const auto scalp = ballMesh(layout.scalp_mm);
  MadeElements made{scalp.vertices_mm, {}, {}};
  for (const auto& t : scalp.triangles) {
    made.elements.push_back({t[0], t[1], t[2]});
    made.tags.push_back(1005);
  }
  constexpr double kStep_mm = 5;
  for (double x = -layout.brain_mm; x <= layout.brain_mm; x += kStep_mm)
    for (double y = -layout.brain_mm; y <= layout.brain_mm; y += kStep_mm)
      for (double z = -layout.brain_mm; z <= layout.brain_mm; z += kStep_mm) {
        const Eigen::Vector3d p(x, y, z);
        if (p.norm() > layout.brain_mm) continue;
        const int first = int(made.nodes.size());
        for (const Eigen::Vector3d& d : {Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(1, -1, -1),
                                         Eigen::Vector3d(-1, 1, -1), Eigen::Vector3d(-1, -1, 1)})
          made.nodes.push_back(p + d);  // the middle is p
        made.elements.push_back({first, first + 1, first + 2, first + 3});
        made.tags.push_back(p.norm() > 0.7 * layout.brain_mm ? 2 : 1);
      }
  return made;
}

inline void putFieldData(MeshText& text, const std::string& name, int components, const MadeElements& made,
                         const FieldMeshLayout& layout, const MadeField& field) {
  text.line("$ElementData\n1\n\"" + name + "\"\n1\n0.0\n4\n0\n" + std::to_string(components) + "\n" +
            std::to_string(made.elements.size()) + "\n0");
  for (std::size_t i = 0; i < made.elements.size(); ++i) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const int node : made.elements[i])
      middle += made.nodes[std::size_t(node)] / double(made.elements[i].size());
    const Eigen::Vector3d value = field(middle);
    const double norm = value.norm();
    text.integers({int(i) + layout.first_id});
    text.reals(components == 3 ? value.data() : &norm, components);
    text.endEntry();
  }
  text.line("$EndElementData");
}

inline std::string madeFieldMesh(const FieldMeshLayout& layout, const MadeField& field) {
  const MadeElements made = elementsOf(layout);
  MeshText text(layout.is_binary);
  text.line(layout.is_binary ? "$MeshFormat\n2.2 1 8" : "$MeshFormat\n2.2 0 8");
  if (layout.is_binary) {
    text.integers({1});
    text.line("");
  }
  text.line("$EndMeshFormat\n$Nodes\n" + std::to_string(made.nodes.size()));
  for (std::size_t i = 0; i < made.nodes.size(); ++i) {
    const Eigen::Vector3d p = made.nodes[i] + layout.shift_mm;
    text.integers({int(i) + layout.first_id});
    text.reals(p.data(), 3);
    text.endEntry();
  }
  if (layout.is_binary && layout.ends_lines) text.line("");
  text.line("$EndNodes\n$Elements\n" + std::to_string(made.elements.size()));
  for (std::size_t i = 0; i < made.elements.size(); ++i) {
    const int type = made.elements[i].size() == 3 ? 2 : 4, id = int(i) + layout.first_id;
    if (layout.is_binary)
      text.integers({type, 1, 2, id});
    else
      text.integers({id, type, 2});
    text.integers({made.tags[i], made.tags[i]});
    for (const int node : made.elements[i]) text.integers({node + layout.first_id});
    text.endEntry();
  }
  if (layout.is_binary && layout.ends_lines) text.line("");
  text.line("$EndElements");
  if (layout.has_vectors) putFieldData(text, "E", 3, made, layout, field);
  putFieldData(text, "magnE", 1, made, layout, field);
  return text.content;
}

}  // namespace facenav::testing
