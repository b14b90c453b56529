#include "storage_provider.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmnet/dstorscp.h>

#include "facenav/core/error.h"
#include "incoming.h"
#include "scu.h"
#include "storage_classes.h"

namespace facenav::pacs {

struct StorageProvider::Listener : DcmStorageSCP {
  std::atomic<bool> is_stopping{false};
  mutable std::atomic<int> images{0};
  std::string own_title;

  OFBool stopAfterConnectionTimeout() override { return is_stopping; }
  OFBool stopAfterCurrentAssociation() override { return is_stopping; }
  OFBool checkCalledAETitleAccepted(const OFString& called) override { return called == own_title.c_str(); }
  void notifyInstanceStored(const OFString&, const OFString&, const OFString&, DcmDataset*) const override {
    ++images;
  }
  OFCondition handleIncomingCommand(T_DIMSE_Message* message,
                                    const DcmPresentationContextInfo& info) override {
    if (is_stopping || images >= kMostImages) return DIMSE_OUTOFRESOURCES;
    return DcmStorageSCP::handleIncomingCommand(message, info);
  }
};

StorageProvider::StorageProvider(const PacsNode& node, const std::filesystem::path& folder,
                                 const std::vector<std::string>& syntaxes)
    : listener_(std::make_unique<Listener>()) {
  prepareDcmtk();
  listener_->own_title = node.own_title;
  listener_->setAETitle(node.own_title.c_str());
  listener_->setPort(Uint16(node.own_port));
  listener_->setConnectionBlockingMode(DUL_NOBLOCK);
  listener_->setConnectionTimeout(1);
  listener_->setDIMSEBlockingMode(DIMSE_NONBLOCKING);
  listener_->setDIMSETimeout(Uint32(node.timeout_s));
  listener_->setACSETimeout(Uint32(node.timeout_s));
  listener_->setHostLookupEnabled(OFFalse);
  listener_->setOutputDirectory(folder.c_str());
  listener_->setFilenameGenerationMode(DcmStorageSCP::FGM_UniqueFromNewUID);  // no names from outside
  listener_->setDatasetStorageMode(DcmStorageSCP::DGM_StoreBitPreserving);
  OFList<OFString> accepted;
  for (const auto& syntax : syntaxes) accepted.push_back(syntax.c_str());
  for (const auto& kind : imageClasses()) listener_->addPresentationContext(kind.c_str(), accepted);
  if (listener_->openListenPort().bad())
    throw Error("port " + std::to_string(node.own_port) + " cannot be listened on", {},
                "close what uses it, or choose another that the archive knows");
  thread_ = std::thread([this] { listener_->acceptAssociations(); });
}

StorageProvider::~StorageProvider() {
  listener_->is_stopping = true;
  thread_.join();
}

int StorageProvider::images() const { return listener_->images; }

}  // namespace facenav::pacs
