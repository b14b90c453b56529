#include "plan/other_words.h"

#include <QObject>
#include <QRegularExpression>
#include <utility>
#include "shell/shown_words.h"

namespace facenav::ui {
namespace {

QString stated(const interop::OtherFile& file) {
  const std::string own = file.space_words.empty() ? toString(file.space) : file.space_words;
  return file.space == interop::Space::unknown && file.space_words.empty() ? QString() : shownWords(own);
}

QString formWords(interop::Form form) {
  return form == interop::Form::sform ? QStringLiteral("sform") : QStringLiteral("qform");
}

}  // namespace

QString inWindowWords(const std::string& words) {
  static const std::vector<std::pair<QRegularExpression, QString>> kOptions = [] {
    const std::pair<const char*, QString> all[] = {
        {"(give|say with) --space \\w+ or --space \\w+( which it is)?",
         QObject::tr("choose RAS or LPS under Coordinates")},
        {"give --form \\w+ or --form \\w+", QObject::tr("choose sform or qform under Form")},
        {"with --form", QObject::tr("under Form")},
        {"give --y-sign as-written or --y-sign flipped", QObject::tr("choose one under Handle")},
        {"give --head-frame x-nasion or --head-frame x-right", QObject::tr("choose one under Head frame")},
        {"--head-frame x-nasion or --head-frame x-right", QObject::tr("choose one under Head frame")},
        {"name (the|that) T1 with --t1", QObject::tr("choose \\1 T1 under T1")},
        {"give --replace, or rename it", QObject::tr("tick Replace, or rename it")},
        {", or --replace", QObject::tr(", or tick Replace")},
        {" \\(--(utc-offset|didt)\\)", QString()},
        {"choose one with --target NAME", QObject::tr("tick one target")},
        {"name those to draw with --target", QObject::tr("tick those to draw")},
        {"; with --session (\\w+)", QObject::tr("; with a session: \\1")},
        {"facenav target makes a target there",
         QObject::tr("type its coordinates in Plan for a target there")},
        {"--([a-z0-9-]+)", "'\\1'"}};
    std::vector<std::pair<QRegularExpression, QString>> made;
    for (const auto& [pattern, shown] : all) made.emplace_back(QRegularExpression(pattern), shown);
    return made;
  }();
  QString shown = shownWords(words);
  for (const auto& [option, choice] : kOptions) shown.replace(option, choice);
  return shown;
}

QString kindWords(interop::Kind kind) {
  switch (kind) {
    case interop::Kind::target:
      return QObject::tr("target");
    case interop::Kind::pulse:
      return QObject::tr("pulse");
    case interop::Kind::landmark:
      return QObject::tr("landmark");
    case interop::Kind::electrode:
      return QObject::tr("electrode");
  }
  return {};
}

QString fateWords(const steps::PreviewedItem& item) {
  const QString fates[] = {QObject::tr("comes in"),        QObject::tr("replaces the one here"),
                           QObject::tr("is here already"), QObject::tr("is shown only"),
                           QObject::tr("refused"),         QObject::tr("stays out")};
  const QString fate = fates[int(item.fate)];
  return item.reason.empty() ? fate : fate + ": " + inWindowWords(item.reason);
}

std::optional<Point<Mri>> importedPlace(const interop::Item& item) {
  if (item.mri_T_coil) return Point<Mri>(item.mri_T_coil->translation_mm());
  return item.mri_place;
}

guidance::Target shownTarget(const std::string& name, const RigidTransform<Mri, Coil>& mri_T_coil) {
  constexpr double kShownDepth_mm = 25;  // of the cortex under a coil, for its line
  guidance::Target target;
  target.name = name;
  target.mri_T_target = mri_T_coil.reframe<Mri, frames::Target>();
  target.scalp_point = Point<Mri>(mri_T_coil.translation_mm());
  target.cortex_point = mri_T_coil * Point<Coil>(0, 0, kShownDepth_mm);
  return target;
}

QString importedPlaceWords(const interop::Item& item) {
  const auto place = importedPlace(item);
  if (!place) return {};
  const auto figure = [](double mm) { return QString::number(mm, 'f', 1); };
  return figure(place->mm.x()) + "  " + figure(place->mm.y()) + "  " + figure(place->mm.z());
}

QString assumedWords(const steps::PreviewedFile& file, const std::string& used) {
  const auto& answers = file.order.answers;
  const auto& read = file.preview.file;
  const QString own = stated(read);
  QString words = answers.space ? QObject::tr("Coordinates: %1, as chosen here")
                                      .arg(QString::fromStdString(toString(*answers.space)))
                  : own.isEmpty() ? QObject::tr("Coordinates: the file does not say")
                                  : QObject::tr("Coordinates: %1, as the file says").arg(own);
  const auto form = answers.form.value_or(read.form);
  const QString t1 = file.order.t1.empty() ? QObject::tr("the case's own")
                                           : QString::fromStdString(file.order.t1.filename().string());
  if (read.head_points)
    words += QObject::tr("; by nasion and ears, without a T1");
  else if (form == interop::Form::any)
    words += QObject::tr("; T1: %1, by its %2").arg(t1, QString::fromStdString(used));
  else
    words += (answers.form ? QObject::tr("; T1: %1, by its %2 as chosen here")
                           : QObject::tr("; T1: %1, by its %2 as the file says"))
                 .arg(t1, formWords(form));
  return words;
}

}  // namespace facenav::ui
