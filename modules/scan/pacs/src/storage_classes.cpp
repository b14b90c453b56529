#include "storage_classes.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcuid.h>

#include <set>

namespace facenav::pacs {

const std::vector<std::string>& imageClasses() {
  static const std::vector<std::string> classes{
      UID_MRImageStorage, UID_EnhancedMRImageStorage, UID_LegacyConvertedEnhancedMRImageStorage,
      UID_CTImageStorage, UID_EnhancedCTImageStorage, UID_LegacyConvertedEnhancedCTImageStorage};
  return classes;
}

const std::vector<std::string>& imageSyntaxes() {
  static const std::vector<std::string> syntaxes{
      UID_LittleEndianExplicitTransferSyntax, UID_LittleEndianImplicitTransferSyntax,
      UID_BigEndianExplicitTransferSyntax,    UID_DeflatedExplicitVRLittleEndianTransferSyntax,
      UID_JPEGProcess14SV1TransferSyntax,     UID_JPEGProcess14TransferSyntax,
      UID_JPEGLSLosslessTransferSyntax,       UID_JPEGLSLossyTransferSyntax,
      UID_JPEG2000LosslessOnlyTransferSyntax, UID_JPEG2000TransferSyntax,
      UID_JPEGProcess2_4TransferSyntax,       UID_RLELosslessTransferSyntax};
  return syntaxes;
}

std::vector<std::vector<std::string>> syntaxesToTry(const std::vector<std::string>& held) {
  const std::set<std::string> plain{
      UID_LittleEndianExplicitTransferSyntax, UID_LittleEndianImplicitTransferSyntax,
      UID_BigEndianExplicitTransferSyntax, UID_DeflatedExplicitVRLittleEndianTransferSyntax};
  std::vector<std::vector<std::string>> sets;
  if (!held.empty()) sets.push_back(held);
  sets.push_back(imageSyntaxes());
  std::vector<std::string> compressed;
  for (const auto& syntax : imageSyntaxes())
    if (!plain.count(syntax)) compressed.push_back(syntax);
  sets.push_back(compressed);
  for (const auto& syntax : compressed) sets.push_back({syntax});
  return sets;
}

}  // namespace facenav::pacs
