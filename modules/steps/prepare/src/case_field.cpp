#include "facenav/prepare/case_field.h"

#include <cmath>
#include <cstdint>
#include <unordered_set>

#include "facenav/casefile/sha256.h"
#include "facenav/core/error.h"
#include "facenav/efield/brain_surface.h"
#include "facenav/efield/head_model.h"

namespace facenav::steps {
namespace {

constexpr std::size_t kPoints = 20500;  // at most; a pose costs time in proportion
constexpr double kFinestCube_mm = 1.5, kCubeStep = 1.08;

/// Name of a model; its number changes with the model's settings or meshes.
const char* nameOf(FieldTier tier) {
  return tier == FieldTier::four_shells ? "four shells 2" : "three shells 2";
}

/// What a model is made from: settings and the hashes of the case's files.
std::string modelOf(const casefile::CaseStore& store, FieldTier tier) {
  std::string model = nameOf(tier);
  for (const char* name : {"brain_mask.nii.gz", "head_mask.nii.gz", "scalp.vtp", "cortex.vtp"})
    model += " " + casefile::sha256OfFile(store.folder() / name);
  return model;
}

std::vector<std::size_t> onePerCube(const surface::TriangleMesh& cortex, double cube_mm) {
  std::unordered_set<std::uint64_t> taken;
  taken.reserve(cortex.vertices_mm.size());
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < cortex.vertices_mm.size(); ++i) {
    std::uint64_t cube = 0;  // 21 bits an axis
    for (int axis = 0; axis < 3; ++axis)
      cube = cube << 21 |
             (std::uint64_t(std::int64_t(std::floor(cortex.vertices_mm[i][axis] / cube_mm))) & 0x1fffff);
    if (taken.insert(cube).second) chosen.push_back(i);
  }
  return chosen;
}

}  // namespace

std::filesystem::path fieldFile(const casefile::CaseStore& store, FieldTier tier) {
  FACENAV_EXPECT(tier != FieldTier::local_sphere, "a model that is kept");
  return store.folder() /
         (tier == FieldTier::four_shells ? "electric_field_fluid.bin" : "electric_field.bin");
}

bool canHaveField(const casefile::CaseStore& store) {
  if (!store.hasMri()) return false;
  for (const char* name : {"brain_mask.nii.gz", "head_mask.nii.gz", "scalp.vtp", "cortex.vtp"})
    if (!std::filesystem::exists(store.folder() / name)) return false;
  return true;
}

std::vector<std::size_t> fieldVertices(const surface::TriangleMesh& cortex) {
  for (double cube_mm = kFinestCube_mm;; cube_mm *= kCubeStep) {
    std::vector<std::size_t> chosen = onePerCube(cortex, cube_mm);
    if (chosen.size() <= kPoints) return chosen;
  }
}

efield::CortexField buildField(const casefile::CaseStore& store, TaskMonitor& monitor, FieldTier tier,
                               const FieldMesh& mesh) {
  if (!store.hasMri()) throw Error("the case has no MRI", {}, "prepare a case from an MRI");
  const auto brain = store.brainMask();
  const auto cortex = store.cortex();
  if (!brain || !cortex)
    throw Error("the case has no brain", {}, "the electric field needs one; correct the brain mask");
  const std::string model = modelOf(store, tier);
  monitor.report("electric field: surfaces", 0.0);
  efield::HeadModel head =
      efield::buildHeadModel(*brain, store.headMask(), store.scalp().mesh, mesh.divisions);
  monitor.report("electric field: surfaces", 0.3);
  if (tier == FieldTier::four_shells)
    head.brain = efield::brainSurface(cortex->mesh, head.inner_skull, {mesh.most_brain_vertices});
  const std::vector<std::size_t> vertices = fieldVertices(cortex->mesh);
  Eigen::Matrix3Xd points_mm(3, Eigen::Index(vertices.size()));
  for (std::size_t i = 0; i < vertices.size(); ++i)
    points_mm.col(Eigen::Index(i)) = cortex->mesh.vertices_mm[vertices[i]];
  efield::FieldSolver solver(std::move(head), {}, monitor);
  efield::CortexField field = efield::makeCortexField(std::move(solver), points_mm, monitor);
  efield::writeCortexField(field, model, fieldFile(store, tier));
  return field;
}

bool hasField(const casefile::CaseStore& store, FieldTier tier) {
  if (!std::filesystem::exists(fieldFile(store, tier)) || !canHaveField(store)) return false;
  return efield::modelOfFile(fieldFile(store, tier)) == modelOf(store, tier);
}

std::optional<efield::CortexField> keptField(const casefile::CaseStore& store, FieldTier tier) {
  if (!hasField(store, tier)) return std::nullopt;
  return efield::readCortexField(fieldFile(store, tier), modelOf(store, tier));
}

}  // namespace facenav::steps
