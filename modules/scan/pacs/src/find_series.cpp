#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>

#include "facenav/core/error.h"
#include "facenav/dicom/character_set.h"
#include "held_syntaxes.h"
#include "scu.h"
#include "storage_classes.h"

namespace facenav::pacs {
namespace {

constexpr std::size_t kMostAnswers = 5000;

std::string rawText(DcmDataset& data, const DcmTagKey& tag) {
  constexpr std::size_t kLongest = 1024;
  OFString value;
  if (data.findAndGetOFStringArray(tag, value).bad()) return {};
  return {value.c_str(), std::min<std::size_t>(value.size(), kLongest)};
}

std::string withoutBlanksAtEnd(std::string text) {
  while (!text.empty() && (text.back() == ' ' || text.back() == '\0')) text.pop_back();
  return text;
}

/// Text of an element, decoded by the answer's character set. Control characters are replaced by blanks,
/// since the text comes from outside and is shown to people.
std::string textOf(DcmDataset& data, const DcmTagKey& tag) {
  const std::string set = rawText(data, DCM_SpecificCharacterSet);
  return dicom::onOneLine(dicom::toUtf8(withoutBlanksAtEnd(rawText(data, tag)), set));
}

std::string nameOfPerson(DcmDataset& data, const DcmTagKey& tag) {
  const std::string set = rawText(data, DCM_SpecificCharacterSet);
  return dicom::personNameToUtf8(withoutBlanksAtEnd(rawText(data, tag)), set);
}

int integerOf(DcmDataset& data, const DcmTagKey& tag) {
  const std::string text = textOf(data, tag);
  const bool is_number =
      !text.empty() && text.size() < 8 && text.find_first_not_of("0123456789") == std::string::npos;
  return is_number ? std::stoi(text) : 0;
}

std::string isoDate(const std::string& dicom) {
  const bool is_date = dicom.size() == 8 && dicom.find_first_not_of("0123456789") == std::string::npos;
  return is_date ? dicom.substr(0, 4) + "-" + dicom.substr(4, 2) + "-" + dicom.substr(6) : "";
}

/// Sends one query at a time. Stops on Cancel, or if an archive sends an endless answer.
template <class Base>
class FindScu : public Base {
 public:
  explicit FindScu(TaskMonitor& monitor) : monitor_(monitor) {}
  OFCondition handleFINDResponse(const T_ASC_PresentationContextID context, QRResponse* response,
                                 OFBool& waitForNextResponse) override {
    if (monitor_.isCancelled() || ++answers_ > kMostAnswers) {
      waitForNextResponse = OFFalse;
      return this->sendCANCELRequest(context);
    }
    return Base::handleFINDResponse(context, response, waitForNextResponse);
  }

 private:
  TaskMonitor& monitor_;
  std::size_t answers_ = 0;
};

template <class Use>
void ask(DcmSCU& scu, const PacsNode& node, DcmDataset& keys, TaskMonitor& monitor, Use use) {
  const auto context = scu.findPresentationContextID(UID_FINDStudyRootQueryRetrieveInformationModel, "");
  OFList<QRResponse*> responses;
  const OFCondition condition = scu.sendFINDRequest(context, &keys, &responses);
  unsigned last = 0;
  for (QRResponse* response : responses) {
    if (response->m_dataset) use(*response->m_dataset);
    last = response->m_status;
    delete response;
  }
  if (monitor.isCancelled()) throw Cancelled();
  require(condition, node, "searching");
  requireStatus(last, node, "searching");
}

void put(DcmDataset& keys, const DcmTagKey& tag, const std::string& value) {
  const bool is_plain =
      std::all_of(value.begin(), value.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
  if (!is_plain) keys.putAndInsertString(DCM_SpecificCharacterSet, "ISO_IR 192");  // what is typed is UTF-8
  keys.putAndInsertString(tag, value.c_str());
}

std::vector<PacsSeries> findStudies(DcmSCU& scu, const PacsNode& node, const PacsQuery& query,
                                    TaskMonitor& monitor) {
  DcmDataset keys;
  put(keys, DCM_QueryRetrieveLevel, "STUDY");
  put(keys, DCM_PatientID, query.patient_id);
  put(keys, DCM_PatientName, query.patient_name);
  put(keys, DCM_StudyDate, query.study_date);
  put(keys, DCM_StudyInstanceUID, query.study_uid);
  put(keys, DCM_StudyDescription, "");
  std::vector<PacsSeries> studies;
  ask(scu, node, keys, monitor, [&](DcmDataset& answer) {
    PacsSeries study;
    study.study_uid = textOf(answer, DCM_StudyInstanceUID);
    study.study_description = textOf(answer, DCM_StudyDescription);
    study.date = isoDate(textOf(answer, DCM_StudyDate));
    study.patient_id = textOf(answer, DCM_PatientID);
    study.patient_name = nameOfPerson(answer, DCM_PatientName);
    if (!study.study_uid.empty()) studies.push_back(std::move(study));
  });
  return studies;
}

void findSeriesOf(const PacsSeries& study, DcmSCU& scu, const PacsNode& node, const std::string& modality,
                  TaskMonitor& monitor, std::vector<PacsSeries>& found) {
  DcmDataset keys;
  put(keys, DCM_QueryRetrieveLevel, "SERIES");
  put(keys, DCM_StudyInstanceUID, study.study_uid);
  put(keys, DCM_SeriesInstanceUID, "");
  put(keys, DCM_SeriesDescription, "");
  put(keys, DCM_Modality, modality);
  put(keys, DCM_NumberOfSeriesRelatedInstances, "");
  ask(scu, node, keys, monitor, [&](DcmDataset& answer) {
    PacsSeries series = study;
    series.series_uid = textOf(answer, DCM_SeriesInstanceUID);
    series.description = textOf(answer, DCM_SeriesDescription);
    series.modality = textOf(answer, DCM_Modality);
    series.images = integerOf(answer, DCM_NumberOfSeriesRelatedInstances);
    if (!series.series_uid.empty()) found.push_back(std::move(series));
  });
}

const std::vector<std::string>& plainSyntaxes() {
  static const std::vector<std::string> kPlain{UID_LittleEndianExplicitTransferSyntax,
                                               UID_LittleEndianImplicitTransferSyntax};
  return kPlain;
}

/// Adds to `held` the UIDs of `listed`, separated by backslashes, that the importer reads.
void addReadable(const std::string& listed, std::vector<std::string>& held) {
  for (const std::string& syntax : imageSyntaxes())
    if (("\\" + listed + "\\").find("\\" + syntax + "\\") != std::string::npos &&
        std::find(held.begin(), held.end(), syntax) == held.end())
      held.push_back(syntax);
}

}  // namespace

std::vector<std::string> heldSyntaxes(const PacsNode& node, const std::string& study_uid,
                                      const std::string& series_uid, TaskMonitor& monitor) {
  DcmDataset keys;
  put(keys, DCM_QueryRetrieveLevel, "IMAGE");
  put(keys, DCM_StudyInstanceUID, study_uid);
  put(keys, DCM_SeriesInstanceUID, series_uid);
  put(keys, DCM_SOPInstanceUID, "");
  put(keys, DCM_AvailableTransferSyntaxUID, "");
  // The echo service is offered too, so that an archive without C-FIND does not refuse the connection.
  return withAssociation<FindScu>(
      node,
      {{UID_FINDStudyRootQueryRetrieveInformationModel, plainSyntaxes()},
       {UID_VerificationSOPClass, {UID_LittleEndianImplicitTransferSyntax}}},
      [&](DcmSCU& scu) {
        std::vector<std::string> held;
        if (scu.findPresentationContextID(UID_FINDStudyRootQueryRetrieveInformationModel, "") == 0)
          return held;
        try {
          ask(scu, node, keys, monitor,
              [&](DcmDataset& answer) { addReadable(textOf(answer, DCM_AvailableTransferSyntaxUID), held); });
        } catch (const Cancelled&) {
          throw;
        } catch (const Error&) {  // an archive that does not know this key: the retrieval tries each form
          held.clear();
        }
        return held;
      },
      monitor);
}

std::vector<PacsSeries> findSeries(const PacsNode& node, const PacsQuery& query, TaskMonitor& monitor) {
  if (query.patient_id.empty() && query.patient_name.empty() && query.study_date.empty() &&
      query.study_uid.empty())
    throw Error("the search is empty", nameOf(node), "give a patient id, a study date, or a study UID");
  return withAssociation<FindScu>(
      node, {{UID_FINDStudyRootQueryRetrieveInformationModel, plainSyntaxes()}},
      [&](DcmSCU& scu) {
        const auto studies = findStudies(scu, node, query, monitor);
        std::vector<PacsSeries> found;
        for (std::size_t s = 0; s < studies.size(); ++s) {
          monitor.report("searching the archive", double(s) / double(studies.size()));
          findSeriesOf(studies[s], scu, node, query.modality, monitor, found);
        }
        return found;
      },
      monitor);
}

}  // namespace facenav::pacs
