#pragma once
// The electric field's models of a case: built from its masks, skin and cortex, and kept in its folder. Three
// shells take some seconds on two cores, so they are built in the background after prepare; four shells, with
// the fluid round the brain, take about a minute and are built when a person asks for them. A file names the
// files it was made from by their hashes: a corrected brain mask or another scalp makes it void.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "facenav/casefile/case_store.h"
#include "facenav/core/task_monitor.h"
#include "facenav/efield/cortex_field.h"

namespace facenav::steps {

/// Model of a head, from the quickest to the surest.
enum class FieldTier {
  local_sphere = 0,  // a sphere fitted to the skull under the coil; at once
  three_shells = 1,  // scalp, skull and brain of the case
  four_shells = 2,   // with the fluid round the brain
  imported = 3       // computed by another program, for one pose alone
};

constexpr double kFourShells_s = 60;  ///< about how long building them takes on two cores

/// Path of a model's file in the case; it may be missing. The local sphere has none.
std::filesystem::path fieldFile(const casefile::CaseStore& store, FieldTier tier = FieldTier::three_shells);

/// Numbers of the cortex' vertices at which the field is given, about 20,000, evenly spread: the first vertex
/// in each cube of a grid. The order is that of CortexField::points_mm.
std::vector<std::size_t> fieldVertices(const surface::TriangleMesh& cortex);

/// True if the case has what the models are built from: MRI, masks, skin and cortex.
bool canHaveField(const casefile::CaseStore& store);

/// Size of a model's meshes. Coarser ones than these serve tests.
struct FieldMesh {
  int divisions = 4;                // of the icosphere, for inner skull, outer skull and scalp
  int most_brain_vertices = 14000;  // of the brain's surface within the fluid
};

/// Builds a model from the case and writes its file, whole or not at all. Throws Error: no MRI, no brain mask
/// or cortex, a head that gives no model (efield/head_model.h, brain_surface.h); Cancelled.
efield::CortexField buildField(const casefile::CaseStore& store, TaskMonitor& monitor,
                               FieldTier tier = FieldTier::three_shells, const FieldMesh& mesh = {});

/// True if the case has the model, made from its present files. Throws Error if the file is damaged.
bool hasField(const casefile::CaseStore& store, FieldTier tier = FieldTier::three_shells);

/// The kept model; nullopt unless hasField(). Throws Error if the file is damaged.
std::optional<efield::CortexField> keptField(const casefile::CaseStore& store,
                                             FieldTier tier = FieldTier::three_shells);

}  // namespace facenav::steps
