#pragma once
// Another program's surface or lines through VTK's readers, in RAS mm. Private to surface.

#include <vtkSmartPointer.h>

#include <filesystem>

class vtkPolyData;

namespace facenav::surface {

/// Reads a file in the format of its name's ending. Throws Error naming the file.
vtkSmartPointer<vtkPolyData> readForeignPolyData(const std::filesystem::path& path);

}  // namespace facenav::surface
