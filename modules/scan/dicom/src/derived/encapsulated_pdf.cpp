#include "facenav/core/error.h"
#include "facenav/core/whole_file.h"
#include "facenav/dicom/derived_objects.h"
#include "header/put_values.h"
#include "series/series_scan.h"
#include "source_elements.h"

namespace facenav::dicom {

void writeEncapsulatedPdf(const SeriesInfo& source, const std::string& pdf, const std::string& title,
                          const std::filesystem::path& file) {
  using gdcm::VR;
  constexpr const char* kEncapsulatedPdf = "1.2.840.10008.5.1.4.1.1.104.1";
  constexpr int kSeriesNumber = 9999;
  if (pdf.rfind("%PDF-", 0) != 0) throw Error("the document is no PDF");
  FACENAV_EXPECT(!source.files.empty(), "a series has files");
  std::vector<SliceHeader> headers;
  for (const auto& image : source.files) {
    auto header = readHeaderOf(image);
    if (!header) throw Error("is no DICOM file any more", image.string(), "read the folder again");
    headers.push_back(std::move(*header));
  }
  requireOneIdentity(headers);
  FilePrefix first(source.files.front());
  gdcm::DataSet data;
  copyPatientAndStudy(readElements(first), source, data);
  putOwnIdentity(data, kEncapsulatedPdf, newUid(), "DOC", kSeriesNumber);
  put(data, {0x0008, 0x002A}, VR::DT, "");
  put(data, {0x0008, 0x0064}, VR::CS, "WSD");  // Conversion Type: made on a workstation
  put(data, {0x0008, 0x103E}, VR::LO, textFor(data, title, 64));
  put(data, {0x0020, 0x0013}, VR::IS, "1");
  put(data, {0x0042, 0x0010}, VR::ST, textFor(data, title, 1024));
  putCode(data, {0x0040, 0xA043}, "28570-0", "LN", "Procedure Note");
  put(data, {0x0042, 0x0012}, VR::LO, "application/pdf");
  put(data, {0x0042, 0x0011}, VR::OB, pdf);
  putLong(data, {0x0042, 0x0015}, std::uint32_t(pdf.size()));
  WholeFile whole(file);
  writeDataSet(data, whole.temporaryPath().string());
  whole.commit();
}

}  // namespace facenav::dicom
