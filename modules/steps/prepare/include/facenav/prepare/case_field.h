#pragma once
// The electric field's model of a case: built from its masks, skin and cortex, and kept as
// electric_field.bin. It takes some seconds on two cores, so it is built in the background after prepare. The
// file names the files it was made from by their hashes: a corrected brain mask or another scalp makes it
// void.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "facenav/casefile/case_store.h"
#include "facenav/core/task_monitor.h"
#include "facenav/efield/cortex_field.h"

namespace facenav::steps {

/// Path of the file in the case; it may be missing.
std::filesystem::path fieldFile(const casefile::CaseStore& store);

/// Numbers of the cortex' vertices at which the field is given, about 20,000, evenly spread: the first vertex
/// in each cube of a grid. The order is that of CortexField::points_mm.
std::vector<std::size_t> fieldVertices(const surface::TriangleMesh& cortex);

/// True if the case has what the model is built from: MRI, masks, skin and cortex.
bool canHaveField(const casefile::CaseStore& store);

/// Builds the field's model from the case and writes its file, whole or not at all. Throws Error: no MRI, no
/// brain mask or cortex, a head that gives no model (efield/head_model.h); Cancelled.
efield::CortexField buildField(const casefile::CaseStore& store, TaskMonitor& monitor);

/// The kept model; nullopt if there is none, or if it was made from other files than the case's present ones.
/// Throws Error if the file is damaged.
std::optional<efield::CortexField> keptField(const casefile::CaseStore& store);

}  // namespace facenav::steps
