#include "facenav/scene/png.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "image_bridge.h"

namespace facenav::scene {

namespace {

/// PNG bytes, made in memory: on a full disk VTK would write many lines to the terminal.
std::vector<std::uint8_t> encoded(const RgbImage& image, int compression) {
  vtkNew<vtkPNGWriter> writer;
  writer->WriteToMemoryOn();
  writer->SetInputData(toVtkImage(image));
  writer->SetCompressionLevel(compression);
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  const unsigned char* first = bytes->GetPointer(0);
  return {first, first + bytes->GetNumberOfValues()};
}

}  // namespace

void writePng(const RgbImage& image, const std::filesystem::path& path, FileAccess access) {
  if (image.empty()) throw Error("the picture is empty", path.string());
  constexpr int kFast = 3;
  const auto bytes = encoded(image, kFast);
  writeWholeFile(path, std::string(bytes.begin(), bytes.end()), access);
}

std::vector<std::uint8_t> pngOf(const RgbImage& image) {
  constexpr int kUsual = 6;
  if (image.empty()) throw Error("the picture is empty");
  return encoded(image, kUsual);
}

}  // namespace facenav::scene
