#include "facenav/efield/coil_file.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "coil_readers.h"
#include "facenav/core/error.h"
#include "facenav/core/number_text.h"
#include "facenav/efield/built_in_coils.h"
#include "facenav/efield/thinned_coil.h"
#include "facenav/volume/nifti.h"
#include "facenav/volume/nifti_forms.h"

namespace facenav::efield {
namespace {

// A coil of 5 mm to 1 m; its moments at 1 A are those of one turn of 4 mm to 100 turns of 0.3 m.
constexpr double kSmallestCoil_mm = 5, kLargestCoil_mm = 1000;
constexpr double kWeakest_Am2 = 1e-5, kStrongest_Am2 = 10;
constexpr double kWeakest_Tm = 1e-10, kStrongest_Tm = 1e-3;
constexpr double kLargestGrid_mm = 3000;

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return text;
}

bool endsIn(const std::filesystem::path& path, const std::string& ending) {
  const std::string name = lower(path.filename().string());
  return name.size() > ending.size() && name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
}

[[noreturn]] void refuseSize(const std::string& what, const std::filesystem::path& path, bool is_large,
                             const std::string& unit) {
  throw Error(what, path.string(),
              std::string("it looks a thousand times too ") + (is_large ? "large" : "small") +
                  ": write positions in " + unit + ", and moments in A m2 for 1 A");
}

void requireCoilSized(const Eigen::Matrix3Xd& places_mm, const std::filesystem::path& path) {
  if (places_mm.cols() < 2) return;
  const Eigen::Vector3d size_mm = places_mm.rowwise().maxCoeff() - places_mm.rowwise().minCoeff();
  const double largest_mm = std::max(size_mm.maxCoeff(), places_mm.colwise().norm().maxCoeff());
  const std::string unit = endsIn(path, ".ccd") ? "metres" : "mm";
  if (largest_mm > kLargestCoil_mm || largest_mm < kSmallestCoil_mm)
    refuseSize(formatted("a coil of %.3g mm is no coil for a head", largest_mm), path,
               largest_mm > kLargestCoil_mm, unit);
}

void requireMoments(const CoilDipoles& dipoles, const std::filesystem::path& path) {
  const double sum = dipoles.moments_Am2.colwise().norm().sum();
  if (dipoles.positions_mm.cols() == 0) return;
  if (!(sum > 0)) throw Error("all dipoles are 0: no current flows", path.string(), "check the coil's file");
  if (sum < kWeakest_Am2 || sum > kStrongest_Am2)
    refuseSize(formatted("moments of %.3g A m2 for 1 A are no coil's", sum), path, sum > kStrongest_Am2,
               endsIn(path, ".ccd") ? "metres" : "mm");
}

void requireSound(const PotentialGrid& grid, const std::filesystem::path& path) {
  if (!grid.potential_Tm.allFinite())
    throw Error("the coil's field holds a value that is no number", path.string(), "export it again");
  const Eigen::Vector3d size_mm = grid.coil_from_voxel.linear().cwiseAbs() *
                                  Eigen::Vector3d(grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1);
  if (!(size_mm.maxCoeff() >= kSmallestCoil_mm && size_mm.maxCoeff() <= kLargestGrid_mm))
    throw Error(formatted("a coil's field sampled over %.3g mm is none for a head", size_mm.maxCoeff()),
                path.string(), "the grid must be in mm: check whether metres and mm are exchanged");
  const double largest = grid.potential_Tm.colwise().norm().maxCoeff();
  if (!(largest >= kWeakest_Tm && largest <= kStrongest_Tm))
    throw Error(formatted("a vector potential of %.3g T m for 1 A is no coil's", largest), path.string(),
                "the values must be T m per ampere: check the file's units");
}

/// A line if the two maps of the grid's header differ, else nothing.
std::optional<std::string> formsNote(const std::filesystem::path& path) {
  constexpr double kSame_mm = 0.1;
  const auto forms = volume::readNiftiForms(path);
  if (!forms.sform || !forms.qform) return std::nullopt;
  const auto& size = forms.grid.size;
  double apart_mm = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d ijk(corner & 1 ? size[0] - 1 : 0, corner & 2 ? size[1] - 1 : 0,
                              corner & 4 ? size[2] - 1 : 0);
    apart_mm = std::max(apart_mm, (*forms.sform * ijk - *forms.qform * ijk).norm());
  }
  if (apart_mm <= kSame_mm) return std::nullopt;
  return formatted(
      "sform and qform of the coil's grid differ by up to %.1f mm: the %s is used, as SimNIBS does", apart_mm,
      forms.used.c_str());
}

}  // namespace

bool isCoilFieldName(const std::filesystem::path& path) {
  return endsIn(path, ".ccd") || endsIn(path, ".tcd") || endsIn(path, ".nii") || endsIn(path, ".nii.gz");
}

CoilSource readPotentialNifti(const std::filesystem::path& path) {
  const auto read = volume::readNiftiVectors(path);
  PotentialGrid grid;
  grid.file = path.string();
  grid.size = read.grid.size;
  grid.coil_from_voxel = read.grid.mri_from_voxel;
  grid.potential_Tm.resize(3, Eigen::Index(read.vectors.size()));
  for (std::size_t i = 0; i < read.vectors.size(); ++i)
    grid.potential_Tm.col(Eigen::Index(i)) = read.vectors[i].cast<double>();
  CoilSource source;
  source.dipoles.largest_didt_A_per_us = numberIn(pairValue(read.description, "dIdtmax")).value_or(0);
  source.dipoles.name = pairValue(read.description, "coilname");
  if (const auto note = formsNote(path)) source.notes.push_back(*note);
  source.grids.push_back(std::move(grid));
  return source;
}

CoilSource readCoilSource(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path))
    throw Error("no such coil", path.string(), "give figure8-70, round, or a .ccd, .tcd or .nii.gz file");
  if (!isCoilFieldName(path))
    throw Error("is no coil's field by its name", path.string(), "give a .ccd, .tcd, .nii or .nii.gz file");
  CoilSource source = endsIn(path, ".ccd")   ? readCcd(path)
                      : endsIn(path, ".tcd") ? readTcd(path)
                                             : readPotentialNifti(path);
  requireCoilSized(source.dipoles.positions_mm, path);
  requireMoments(source.dipoles, path);
  requireCoilSized(source.lines.positions_mm, path);
  for (const auto& grid : source.grids) requireSound(grid, path);
  if (source.dipoles.positions_mm.cols() + source.lines.positions_mm.cols() == 0 && source.grids.empty())
    throw Error("holds no part that carries current", path.string(), "choose another file of the coil");
  const double rate = source.dipoles.largest_didt_A_per_us;
  if (!(rate >= 0 && rate <= 1000))
    throw Error(formatted("a largest rate of the current of %.3g A/us is no stimulator's", rate),
                path.string(), "dIdtmax is in A/us, maxdIdt in A/s");
  if (source.dipoles.name.empty()) source.dipoles.name = path.filename().string();
  return source;
}

const std::vector<std::string>& builtInCoils() {
  static const std::vector<std::string> kNames{"figure8-70", "round"};
  return kNames;
}

FieldCoil fieldCoil(const std::string& name_or_file) {
  FieldCoil coil;
  if (name_or_file == builtInCoils()[0])
    coil.dipoles = figureEight70();
  else if (name_or_file == builtInCoils()[1])
    coil.dipoles = roundCoil();
  coil.dipoles_in_file = int(coil.dipoles.positions_mm.cols());
  if (coil.dipoles_in_file > 0) return coil;
  const auto source = readCoilSource(name_or_file);
  coil.notes = source.notes;
  const auto all = dipolesOf(source);
  coil.dipoles_in_file = int(all.positions_mm.cols());
  const auto thinned = thinnedCoil(all);
  coil.dipoles = thinned.coil;
  coil.thinning_error = thinned.relative_error;
  return coil;
}

}  // namespace facenav::efield
