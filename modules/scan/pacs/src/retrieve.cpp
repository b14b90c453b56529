#include <dcmtk/dcmdata/dctk.h>

#include "facenav/core/error.h"
#include "held_syntaxes.h"
#include "incoming.h"
#include "scu.h"
#include "storage_classes.h"
#include "storage_provider.h"

namespace facenav::pacs {
namespace {

/// The archive's final response to a C-GET or C-MOVE.
struct Outcome {
  unsigned status = 0;
  int failed = 0;
};

/// Reports progress, stops on Cancel, and writes incoming images under our own names (DCMTK would use names
/// from the archive).
template <class Base>
class RetrieveScu : public Base {
 public:
  RetrieveScu(TaskMonitor& monitor, std::filesystem::path folder, Outcome& outcome)
      : monitor_(monitor), folder_(std::move(folder)), outcome_(outcome) {}

  OFCondition handleCGETResponse(const T_ASC_PresentationContextID context, RetrieveResponse* response,
                                 OFBool& go_on) override {
    note(context, response, go_on);
    return Base::handleCGETResponse(context, response, go_on);
  }
  OFCondition handleMOVEResponse(const T_ASC_PresentationContextID context, RetrieveResponse* response,
                                 OFBool& go_on) override {
    note(context, response, go_on);
    return Base::handleMOVEResponse(context, response, go_on);
  }
  OFCondition handleSTORERequestFile(T_ASC_PresentationContextID* context, const OFString&,
                                     T_DIMSE_C_StoreRQ* request) override {
    if (++images_ > kMostImages) return DIMSE_OUTOFRESOURCES;
    const auto file = folder_ / (std::to_string(1000000 + images_) + ".part");
    return Base::handleSTORERequestFile(context, file.c_str(), request);
  }

 private:
  void note(const T_ASC_PresentationContextID context, RetrieveResponse* response, OFBool&) {
    if (!response) return;
    outcome_.status = response->m_status;
    outcome_.failed = response->m_numberOfFailedSubops;
    const double done = response->m_numberOfCompletedSubops, left = response->m_numberOfRemainingSubops;
    if (!is_cancelled_) try {
        monitor_.report("receiving images", done + left > 0 ? done / (done + left) : 0.0);
      } catch (const Cancelled&) {  // must not pass through DCMTK's code
        is_cancelled_ = true;
        this->sendCANCELRequest(context);
      }
  }

  TaskMonitor& monitor_;
  std::filesystem::path folder_;
  Outcome& outcome_;
  int images_ = 0;
  bool is_cancelled_ = false;
};

void putKeys(DcmDataset& keys, const std::string& study_uid, const std::string& series_uid) {
  keys.putAndInsertString(DCM_QueryRetrieveLevel, "SERIES");
  keys.putAndInsertString(DCM_StudyInstanceUID, study_uid.c_str());
  keys.putAndInsertString(DCM_SeriesInstanceUID, series_uid.c_str());
}

void checkUid(const std::string& uid, const char* whose) {
  if (uid.empty() || uid.size() > 64 || uid.find_first_not_of("0123456789.") != std::string::npos)
    throw Error(std::string("no ") + whose + " UID", uid, "'facenav pacs find' lists them");
}

const std::vector<std::string> kPlain{UID_LittleEndianExplicitTransferSyntax,
                                      UID_LittleEndianImplicitTransferSyntax};

/// False if the archive does not offer C-GET.
bool tryGet(const PacsNode& node, DcmDataset& keys, const std::vector<std::string>& syntaxes,
            const std::filesystem::path& folder, Outcome& outcome, TaskMonitor& monitor) {
  std::vector<Offer> offers{{UID_GETStudyRootQueryRetrieveInformationModel, kPlain}};
  for (const auto& kind : imageClasses())
    for (const auto& syntax : syntaxes) offers.push_back({kind, {syntax}, true});
  return withAssociation<RetrieveScu>(
      node, offers,
      [&](DcmSCU& scu) {
        const auto context = scu.findPresentationContextID(UID_GETStudyRootQueryRetrieveInformationModel, "");
        if (context == 0) return false;
        scu.setStorageMode(DCMSCU_STORAGE_BIT_PRESERVING);
        scu.setStorageDir(folder.c_str());
        OFList<RetrieveResponse*> responses;
        const OFCondition condition = scu.sendCGETRequest(context, &keys, &responses);
        for (RetrieveResponse* response : responses) delete response;
        if (!monitor.isCancelled()) require(condition, node, "receiving");
        return true;
      },
      monitor, folder, outcome);
}

void move(const PacsNode& node, DcmDataset& keys, const std::vector<std::string>& syntaxes,
          const std::filesystem::path& folder, Outcome& outcome, TaskMonitor& monitor) {
  const StorageProvider provider(node, folder, syntaxes);
  withAssociation<RetrieveScu>(
      node, {{UID_MOVEStudyRootQueryRetrieveInformationModel, kPlain}},
      [&](DcmSCU& scu) {
        const auto context =
            scu.findPresentationContextID(UID_MOVEStudyRootQueryRetrieveInformationModel, "");
        OFList<RetrieveResponse*> responses;
        const OFCondition condition = scu.sendMOVERequest(context, node.own_title.c_str(), &keys, &responses);
        for (RetrieveResponse* response : responses) delete response;
        if (!monitor.isCancelled()) require(condition, node, "receiving");
      },
      monitor, folder, outcome);
}

/// True if images failed that the archive may be able to send in another form.
bool mayDependOnForm(const Outcome& outcome) {
  return outcome.failed > 0 || (outcome.status & 0xFF00) == 0xA700;
}

/// Requests the series in one set of forms. Returns the way it went.
Retrieval request(const PacsNode& node, DcmDataset& keys, const std::vector<std::string>& syntaxes,
                  const std::filesystem::path& folder, Retrieval how, Outcome& outcome,
                  TaskMonitor& monitor) {
  if (how != Retrieval::move && tryGet(node, keys, syntaxes, folder, outcome, monitor)) return Retrieval::get;
  if (how == Retrieval::get) throw Error("the archive offers no C-GET", nameOf(node), "use C-MOVE");
  move(node, keys, syntaxes, folder, outcome, monitor);
  return Retrieval::move;
}

}  // namespace

Received retrieve(const PacsNode& node, const std::string& study_uid, const std::string& series_uid,
                  const std::filesystem::path& folder, Retrieval how, TaskMonitor& monitor) {
  checkUid(study_uid, "study");
  checkUid(series_uid, "series");
  check(node);
  IncomingFolder incoming(folder);
  DcmDataset keys;
  putKeys(keys, study_uid, series_uid);
  Outcome outcome;
  Received received;
  for (const auto& syntaxes : syntaxesToTry(heldSyntaxes(node, study_uid, series_uid, monitor))) {
    incoming.clear();
    outcome = {};
    received.how = request(node, keys, syntaxes, incoming.path(), how, outcome, monitor);
    how = received.how;
    if (monitor.isCancelled()) throw Cancelled();
    if (!mayDependOnForm(outcome)) break;
  }
  requireStatus(outcome.status, node, "receiving");
  if (outcome.failed > 0)
    throw Error(std::to_string(outcome.failed) + " images could not be received", nameOf(node), "try again");
  received.images = incoming.commit();
  if (received.images > 0) return received;
  std::error_code ignored;
  std::filesystem::remove(folder, ignored);
  throw Error("the archive sent no image", nameOf(node), "check the UIDs");
}

}  // namespace facenav::pacs
