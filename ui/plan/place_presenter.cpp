#include "plan/place_presenter.h"

#include "facenav/core/error.h"
#include "facenav/core/log.h"
#include "facenav/surface/outside_head.h"
#include "plan/typed_coordinates.h"

namespace facenav::ui {
namespace {

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

/// Labels of the atlas, read at first use. Without them there are coordinates, but no names.
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
  const TypedCoordinates read = readCoordinates(text);
  if (!read.mm) {
    words = read.fault;
    return std::nullopt;
  }
  if (is_mni && !hasAtlas()) {
    words = tr("the case has no atlas: type RAS coordinates");
    return std::nullopt;
  }
  const auto place = is_mni ? model_.current().atlas->toMri(Point<Mni>(*read.mm)) : Point<Mri>(*read.mm);
  words = outsideWords(place);
  return words.isEmpty() ? std::optional(place) : std::nullopt;
}

QString PlacePresenter::outsideWords(const Point<Mri>& place) const {
  if (!model_.isOpen()) return {};
  const double outside_mm =
      surface::outsideHead_mm(*model_.current().head_mask, *model_.current().scalp, place);
  if (outside_mm <= surface::kFarthestOutside_mm) return {};
  return tr("%1 mm outside the head: check the numbers, and whether they are MNI or RAS")
      .arg(outside_mm, 0, 'f', 0);
}

}  // namespace facenav::ui
