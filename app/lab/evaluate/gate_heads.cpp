#include "evaluate/gate_heads.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <random>

#include "evaluate/evaluation_head.h"
#include "facenav/core/error.h"
#include "facenav/evaluation/head_labels.h"

namespace facenav::app {
namespace fs = std::filesystem;
namespace {

constexpr double kTargetBehind_mm = 80.0;

/// The scan's skin in the world's shape; its planes move with their points.
surface::ScalpSurface shaped(surface::ScalpSurface scalp, const room::PersonShape& shape) {
  auto& mesh = scalp.mesh;
  for (auto& p_mm : mesh.vertices_mm) p_mm = shape(p_mm);
  for (auto& normal : mesh.normals) normal.setZero();
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3d& a = mesh.vertices_mm[std::size_t(t[0])];
    const Eigen::Vector3d facet =
        (mesh.vertices_mm[std::size_t(t[1])] - a).cross(mesh.vertices_mm[std::size_t(t[2])] - a);
    for (int corner = 0; corner < 3; ++corner) mesh.normals[std::size_t(t[corner])] += facet;
  }
  for (auto& normal : mesh.normals) normal.normalize();
  room::PersonShape plain = shape;
  plain.soft_mm = 0.0;
  for (auto& [point, normal] : scalp.field_of_view) {
    point.mm = plain(point.mm);
    normal.v = normal.v.cwiseQuotient(shape.scale).normalized();
  }
  return scalp;
}

/// True if the scan has a face and the room's landmarks lie on it: the nose's tip is the foremost place
/// between chin and bridge. The room finds landmarks on a rendering without eyes, and errs on some heads.
bool hasRightFace(const surface::ScalpSurface& scalp, const room::VirtualPatient& person) {
  constexpr double kTip_mm = 12.0, kMiddle_mm = 30.0;
  const auto& l = person.landmarks68_mm;
  if (!scalp.has_face || l.empty()) return false;
  Eigen::Vector3d foremost(0, -1e9, 0);
  for (const auto& p : person.skin.vertices_mm)
    if (p.z() > l[8].z() && p.z() < l[27].z() && std::abs(p.x() - l[30].x()) < kMiddle_mm &&
        p.y() > foremost.y())
      foremost = p;
  return (foremost - l[30]).norm() < kTip_mm;
}

}  // namespace

GateHeads::GateHeads(Context& context, fs::path labels) : context_(context), specs_{"patient"} {
  const bool is_given = !labels.empty();
  if (!is_given) labels = evaluation::sharedHeadLabels();
  if (!is_given && !fs::exists(labels)) return;
  for (const auto& file : evaluation::labelledHeads(labels)) specs_.push_back(file.string());
}

const GateHeads::Base& GateHeads::base(std::size_t number) {
  const auto found = bases_.find(number);
  if (found != bases_.end()) return found->second;
  auto head = makeEvaluationHead(context_, specs_[number]);
  const bool has_face = hasRightFace(head.scalp, *head.patient);
  if (!has_face)
    std::fprintf(stderr, "facenav: note: head %s is passed over: its face, or its nose, is not found\n",
                 specs_[number].c_str());
  return bases_[number] = {std::move(head.scalp), std::move(head.patient), has_face};
}

std::size_t GateHeads::numberOf(const room::World& world, std::size_t further) {
  std::size_t number = std::min(specs_.size() - 1, std::size_t(world.person.head * double(specs_.size())));
  // A head without a face is passed over: the scan ends above it, or the room's portrait would be misplaced.
  const auto passFaceless = [&] {
    for (std::size_t tried = 0; !base(number).has_face; ++tried) {
      if (tried == specs_.size())
        throw Error("no face is found in any head", specs_[number], "give other --labels");
      number = (number + 1) % specs_.size();
    }
  };
  passFaceless();
  for (; further > 0; --further) {
    number = (number + 1) % specs_.size();
    passFaceless();
  }
  return number;
}

std::string GateHeads::nameOf(std::size_t number) const {
  return fs::path(specs_[number]).stem().stem().string();
}

WorldScan GateHeads::makeScan(std::size_t number, const room::World& world) {
  const Base& head = base(number);
  const room::PersonShape shape = room::shapeOf(world, *head.person);
  const Eigen::Vector3d bridge_mm = shape(head.person->landmarks68_mm[27]);
  return {nameOf(number), shaped(head.scalp, shape),
          Point<Mri>(bridge_mm - kTargetBehind_mm * Eigen::Vector3d::UnitY())};
}

WorldHead GateHeads::of(const room::World& world, std::size_t further) {
  const std::size_t number = numberOf(world, further);
  return {makeScan(number, world),
          std::make_shared<const room::VirtualPatient>(room::personOf(world, *base(number).person))};
}

WorldScan GateHeads::scanOf(const room::World& world) { return makeScan(numberOf(world, 0), world); }

std::vector<WorldScan> GateHeads::strangersOf(const room::World& world, std::size_t count) {
  const std::string own = nameOf(numberOf(world, 0));
  std::vector<std::size_t> numbers(specs_.size());
  std::iota(numbers.begin(), numbers.end(), std::size_t(0));
  std::mt19937_64 random(world.seed);
  std::shuffle(numbers.begin(), numbers.end(), random);
  std::vector<WorldScan> scans;
  for (const std::size_t number : numbers)
    if (scans.size() < count && nameOf(number) != own && base(number).has_face)
      scans.push_back(makeScan(number, world));
  return scans;
}

}  // namespace facenav::app
