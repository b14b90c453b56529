#include "dimse_status.h"

namespace facenav::pacs {

std::pair<std::string, std::string> statusInWords(unsigned status, const std::string& own_title) {
  const std::string ask = "ask its administrator";
  switch (status) {
    case 0x0110:
      return {"the archive met an error of its own", "try again, or " + ask};
    case 0x0112:
      return {"the archive does not hold this object", "search again"};
    case 0x0122:
      return {"the archive does not take this kind of object or request", ask};
    case 0x0124:
      return {"the archive does not allow '" + own_title + "' to do this", ask};
    case 0x0211:
      return {"the archive does not know this kind of request", ask};
    case 0xA701:
      return {"the archive is out of resources and could not count the matches", "try again later"};
    case 0xA702:
      return {
          "the archive could not send the images: it cannot convert them to a form that FaceNav reads, or "
          "is out of resources",
          "have the series sent uncompressed or as JPEG 2000; or " + ask};
    case 0xA801:
      return {"the archive does not know '" + own_title + "' as a place to send to", "have it entered there"};
    case 0xFE00:
      return {"it was cancelled", "try again"};
    default:
      break;
  }
  if ((status & 0xFF00) == 0xA700)
    return {"the archive is out of resources (disk or memory)", "try again later"};
  if ((status & 0xFF00) == 0xA900)
    return {"the archive finds that data and kind of object do not match", "check the UIDs"};
  if ((status & 0xF000) == 0xC000)
    return {"the archive could not process the request", "check the UIDs and the search's words, or " + ask};
  return {"the archive reports a failure", ask};
}

}  // namespace facenav::pacs
