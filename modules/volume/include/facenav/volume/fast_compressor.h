#pragma once
// Compression for what is written while a user waits: zlib's own format by libdeflate, a third of the time.
// VTK's XML files are cut into blocks of 32 KB, for each of which zlib sets itself up anew.

#include <vtkDataCompressor.h>
#include <vtkSmartPointer.h>

#include <cstddef>
#include <vector>

namespace facenav::volume {

/// For a VTK XML writer (SetCompressor): its files say vtkZLibDataCompressor, and every reader takes them.
vtkSmartPointer<vtkDataCompressor> fastCompressor();

/// `size` bytes as the content of a .gz file. Throws Error when memory runs out.
std::vector<unsigned char> gzipped(const void* bytes, std::size_t size);

}  // namespace facenav::volume
