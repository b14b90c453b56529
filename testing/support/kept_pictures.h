#pragma once
// Kept pictures of windows to compare with: small, grey or in colours, lossless, each with the noise between
// two runs of the build that made it. What changes from day to day (times, random numbers) is painted over
// first.

#include <QImage>
#include <QString>
#include <QStringList>
#include <filesystem>

class QWidget;

namespace facenav::testing {

/// Grey picture of the window, a quarter of 1366 x 768. `hidden`: object or accessible names of the parts
/// that are painted over. So are parts with words of a person, and those named by a moment in UTC.
QImage smallPicture(QWidget& window, const QStringList& hidden);

/// Picture in colours, a sixth of 1366 x 768, for what grey does not show: a theme's colours.
QImage smallColouredPicture(QWidget& window, const QStringList& hidden);

/// Largest mean difference of a block of 8 x 8 pixels, in grey levels, or in those of the colour that differs
/// most if one picture has colours; 255 if the sizes differ.
double difference(const QImage& a, const QImage& b);

class KeptPictures {
 public:
  enum class Use { compare, renew, measure_noise };
  /// `use`: what show() does. renew keeps new pictures; measure_noise, in a second run, their noise.
  KeptPictures(std::filesystem::path folder, Use use) : folder_(std::move(folder)), use_(use) {}
  /// By FACENAV_WALK_PICTURES: "new", "noise", otherwise compare.
  static Use useFromEnvironment();

  Use use() const { return use_; }
  /// Allowed difference from the kept picture, grey levels: a multiple of its noise.
  double tolerance(const QString& name) const;
  /// Difference from the kept picture, grey levels; 255 if there is none.
  double differenceFrom(const QString& name, const QImage& picture) const;
  /// How the picture differs from the kept one, in words; empty if it does not. Other uses write the file.
  QString show(const QString& name, const QImage& picture) const;

 private:
  QString file(const QString& name) const;
  std::filesystem::path folder_;
  Use use_;
};

}  // namespace facenav::testing
