#include "facenav/scene/png.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "image_bridge.h"

namespace facenav::scene {

void writePng(const RgbImage& image, const std::filesystem::path& path, FileAccess access) {
  if (image.empty()) throw Error("the picture is empty", path.string());
  WholeFile file(path, access);
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(file.temporaryPath().c_str());
  writer->SetInputData(toVtkImage(image));
  writer->SetCompressionLevel(3);
  writer->Write();
  if (writer->GetErrorCode() != 0)
    throw Error("the picture could not be written", path.string(), "is the disk full?");
  file.commit();
}

std::vector<std::uint8_t> pngOf(const RgbImage& image) {
  if (image.empty()) throw Error("the picture is empty");
  vtkNew<vtkPNGWriter> writer;
  writer->WriteToMemoryOn();
  writer->SetInputData(toVtkImage(image));
  writer->SetCompressionLevel(6);
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  const unsigned char* first = bytes->GetPointer(0);
  return {first, first + bytes->GetNumberOfValues()};
}

}  // namespace facenav::scene
