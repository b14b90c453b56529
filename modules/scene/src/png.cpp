#include "facenav/scene/png.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>

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

}  // namespace facenav::scene
