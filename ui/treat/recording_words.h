#pragma once
// Describes a recording that is played in place of cameras: "morning: 300 frames, 60 per s (assumed)".

#include <QCoreApplication>
#include <QString>

#include "facenav/capture/recording.h"

namespace facenav::ui {

inline QString wordsOf(const capture::Recording& recording) {
  const auto tr = [](const char* text) { return QCoreApplication::translate("facenav::ui", text); };
  return tr("%1: %2 frames, %3 per s%4")
      .arg(QString::fromStdString(recording.folder.filename().string()))
      .arg(qlonglong(recording.frame_count))
      .arg(recording.frames_per_s, 0, 'f', 0)
      .arg(recording.has_timestamps ? QString() : tr(" (assumed)"));
}

}  // namespace facenav::ui
