#pragma once
// Fast compression for files that are written while a user waits: zlib's format, written by libdeflate in a
// third of the time. (VTK's XML files are split into blocks of 32 KB, and zlib initialises itself again for
// each block.)

#include <vtkDataCompressor.h>
#include <vtkSmartPointer.h>

#include <cstddef>
#include <vector>

namespace facenav::volume {

/// Compressor for a VTK XML writer (SetCompressor). Its files name vtkZLibDataCompressor, so every reader
/// accepts them.
vtkSmartPointer<vtkDataCompressor> fastCompressor();

/// Compresses `size` bytes to the content of a .gz file. Throws Error if memory runs out.
std::vector<unsigned char> gzipped(const void* bytes, std::size_t size);

}  // namespace facenav::volume
