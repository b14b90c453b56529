#pragma once
// Readers and writers of each format, for the table in formats.cpp. A reader gets content that its format was
// recognised by, and throws Error with one line where it is damaged.

#include "facenav/interop/formats.h"

namespace facenav::interop {

bool isBrainsight(const std::string& content);
OtherFile readBrainsight(const Source& source);
Written writeBrainsight(const Order& order);

bool isLocalite(const std::string& content);
OtherFile readLocalite(const Source& source);
Written writeLocalite(const Order& order);

bool isSimnibsCsv(const std::string& content);
OtherFile readSimnibsCsv(const Source& source);
Written writeSimnibsCsv(const Order& order);

bool isSimnibsMat(const std::string& content);
OtherFile readSimnibsMat(const Source& source);
Written writeSimnibsMat(const Order& order);
Written writeSimnibsScript(const Order& order);

bool isVisor2(const std::string& content);
OtherFile readVisor2(const Source& source);
Written writeVisor2(const Order& order);

bool isSoftaxic(const std::string& content);
OtherFile readSoftaxic(const Source& source);
Written writeSoftaxic(const Order& order);

bool isInvesalius(const std::string& content);
OtherFile readInvesalius(const Source& source);
Written writeInvesalius(const Order& order);

bool isSlicerMarkups(const std::string& content);
OtherFile readSlicerMarkups(const Source& source);
Written writeSlicerMarkups(const Order& order);

bool isItkTransform(const std::string& content);
OtherFile readItkTransform(const Source& source);
Written writeItkTransform(const Order& order);

bool isFcsv(const std::string& content);
OtherFile readFcsv(const Source& source);

bool isNavinibs(const std::string& content);
OtherFile readNavinibs(const Source& source);
/// A file that holds this list, "targets" or "samples", bare or as a member.
OtherFile readNavinibsList(const Source& source, const char* list);
Written writeNavinibs(const Order& order);

bool isStimguide(const std::string& content);
OtherFile readStimguide(const Source& source);

bool isVisor2Pulses(const std::string& content);
OtherFile readVisor2Pulses(const Source& source);

bool isNibsMarkers(const std::string& content);
OtherFile readNibsMarkers(const Source& source);
WrittenFolder writeNibsBids(const Order& order);

bool isOwnCsv(const std::string& content);
OtherFile readOwnCsv(const Source& source);
Written writeOwnCsv(const Order& order);

bool isOwnJson(const std::string& content);
OtherFile readOwnJson(const Source& source);
Written writeOwnJson(const Order& order);

/// The file with every item named and placed; the same target twice counts once. Throws Error for one without
/// items, or with too many.
OtherFile finished(OtherFile file, const std::filesystem::path& path);

/// Items of one kind that have a pose, in order.
std::vector<const Item*> posed(const Order& order, Kind kind);
/// Throws Error if the order has no target with a pose.
std::vector<const Item*> targetsOf(const Order& order);
/// Notes that the format holds no pulses or no names, where the order has some.
void notePulsesLeft(const Order& order, Written& written, const std::string& format);

}  // namespace facenav::interop
