#include "treat/still_pictures.h"

#include <QObject>
#include <cmath>

namespace facenav::ui {
namespace {

constexpr double kPairWithin_s = 20.0;  // a head holds still for about this long

}  // namespace

void StillPictures::clear() {
  dots_.reset();
  plain_.reset();
}

void StillPictures::take(const cameras::StereoFrame& frame) {
  dots_ = plain_ = frame;
  dots_taken_ = plain_taken_ = Timestamp::now();
}

void StillPictures::takeDots(const cameras::StereoFrame& frame) {
  dots_ = frame;
  plain_.reset();
  dots_taken_ = Timestamp::now();
}

QString StillPictures::takePlain(const cameras::StereoFrame& frame) {
  if (!dots_) return QObject::tr("take the picture with dots first");
  if (frame.number <= dots_->number)  // the same image as the one with dots
    return QObject::tr("no new picture from the cameras yet: take it again");
  plain_ = frame;
  plain_taken_ = Timestamp::now();
  if (capture()) return {};
  clear();
  return QObject::tr("more than %1 s between the two pictures: take both again").arg(kPairWithin_s);
}

std::optional<capture::CapturePair> StillPictures::capture() const {
  if (!dots_ || !plain_ || std::abs(plain_taken_.s - dots_taken_.s) > kPairWithin_s) return std::nullopt;
  return capture::CapturePair{*dots_, *plain_};
}

QString StillPictures::words() const {
  if (capture()) return QObject::tr("taken: align now, the head as it is");
  if (dots_) return QObject::tr("now the projector off, the head still, and take the second picture");
  return QObject::tr(
      "look at the cameras, and hold the coil still beside the face, its marker to both cameras: the picture "
      "is taken by itself");
}

}  // namespace facenav::ui
