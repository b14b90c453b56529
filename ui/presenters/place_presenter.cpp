#include "presenters/place_presenter.h"

#include <QRegularExpression>
#include <cmath>

#include "facenav/core/error.h"
#include "facenav/core/log.h"

namespace facenav::ui {
namespace {

constexpr double kFarthest_mm = 400.0;  // no head is larger

QString nameAt(const atlas::LabelMap& map, const Point<Mni>& p) {
  const auto label = atlas::labelAt(map, p);
  if (label.name.empty()) return {};
  const QString name = QString::fromStdString(label.name);
  return label.distance_mm > 0.5
             ? PlacePresenter::tr("%1 (%2 mm away)").arg(name).arg(label.distance_mm, 0, 'f', 0)
             : name;
}

QString figures(const QString& frame, const Eigen::Vector3d& mm) {
  const auto figure = [](double value) { return QString::number(value, 'f', 1).rightJustified(7); };
  return frame + figure(mm.x()) + figure(mm.y()) + figure(mm.z());
}

}  // namespace

PlacePresenter::PlacePresenter(const Services& services, CaseModel& model, QObject* parent)
    : QObject(parent), services_(services), model_(model) {}

/// Read once, when first asked for. Without it there are coordinates, but no names.
const atlas::BrainTemplate* PlacePresenter::labels() const {
  if (has_tried_ || !services_.readTemplate) return labels_.get();
  has_tried_ = true;
  try {
    labels_ = std::make_shared<atlas::BrainTemplate>(services_.readTemplate());
  } catch (const Error& error) {
    logWarning(error.what());
  }
  return labels_.get();
}

Place PlacePresenter::at(const Point<Mri>& ras) const {
  Place place{ras, std::nullopt, {}, {}};
  if (!hasAtlas()) return place;
  place.mni = model_.current().atlas->toMni(ras);
  if (const auto* names = labels()) {
    place.aal = nameAt(names->aal, *place.mni);
    place.brodmann = nameAt(names->brodmann, *place.mni);
  }
  return place;
}

QString PlacePresenter::describe(const Point<Mri>& ras) const {
  const Place place = at(ras);
  QStringList lines{figures(tr("RAS"), place.ras.mm)};
  lines << (place.mni ? figures(tr("MNI"), place.mni->mm) : tr("MNI  the case has no atlas"));
  QStringList names;
  for (const QString& name : {place.aal, place.brodmann})
    if (!name.isEmpty()) names << name;
  if (place.mni) lines << (names.isEmpty() ? tr("no label within 5 mm") : names.join('\n'));
  return lines.join('\n');
}

std::optional<Point<Mri>> PlacePresenter::read(const QString& typed, bool is_mni, QString& words) const {
  QString text = typed.trimmed();
  if (text.startsWith("MNI", Qt::CaseInsensitive) || text.startsWith("RAS", Qt::CaseInsensitive)) {
    is_mni = text.startsWith('M', Qt::CaseInsensitive);
    text = text.mid(3);
  }
  const QStringList parts = text.split(QRegularExpression("[\\s,;]+"), Qt::SkipEmptyParts);
  Eigen::Vector3d mm;
  bool is_number = parts.size() == 3;
  for (int i = 0; i < 3 && is_number; ++i) mm[i] = parts[i].toDouble(&is_number);
  if (!is_number || !mm.allFinite() || mm.cwiseAbs().maxCoeff() > kFarthest_mm) {
    words = tr("three numbers in mm are expected, such as -38 -22 56");
    return std::nullopt;
  }
  if (!is_mni) return Point<Mri>(mm);
  if (!hasAtlas()) {
    words = tr("the case has no atlas: type RAS coordinates");
    return std::nullopt;
  }
  return model_.current().atlas->toMri(Point<Mni>(mm));
}

}  // namespace facenav::ui
