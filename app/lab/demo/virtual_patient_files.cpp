#include "demo/virtual_patient_files.h"

#include "facenav/dicom/series.h"
#include "facenav/room/minc_volume.h"
#include "facenav/volume/nifti.h"

namespace facenav::app {
namespace fs = std::filesystem;

VirtualPatientFiles virtualPatientFiles(const Context& context) {
  const fs::path folder = context.cacheFolder() / "virtual_patient";
  const VirtualPatientFiles files{folder / "mri.nii.gz", folder / "dicom"};
  if (fs::exists(files.nifti) && fs::exists(files.dicom_folder)) return files;
  const fs::path fetched = context.cacheFolder() / "brainbrowser";
  const fs::path header = fetched / "structural1.mnc.header.gz", raw = fetched / "structural1.mnc.raw.gz";
  if (!fs::exists(header) || !fs::exists(raw))
    throw Error("the virtual patient's MRI is not here", fetched.string(),
                "in a checkout './facenav.sh demo' fetches it; else put structural1.mnc.header.gz and "
                "structural1.mnc.raw.gz of npm's brainbrowser 2.3.0 there");
  const auto mri = room::readMincVolume(header, raw);
  fs::create_directories(folder);
  volume::writeNifti(mri, files.nifti);
  fs::remove_all(files.dicom_folder);
  dicom::writeSeries(mri, files.dicom_folder, {});
  return files;
}

}  // namespace facenav::app
