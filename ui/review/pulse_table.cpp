#include "review/pulse_table.h"

#include <limits>

#include "facenav/report/local_time.h"
#include "shell/shown_words.h"
#include "shell/theme.h"

namespace facenav::ui {
namespace {

constexpr int kValues = 15;

const report::PulseColumnWords& valueColumn(int column) {
  return report::pulseColumns()[std::size_t(column - PulseTable::kFirstValue)];
}

/// Where the pulse's field was strongest, and by which model; empty: not known.
QString fieldPlaceWords(const casefile::Pulse& pulse) {
  if (!pulse.field) return {};
  const auto& p_mm = pulse.field->peak_place.mm;
  return PulseTable::tr("strongest at RAS %1 %2 %3 mm; tier %4, coil %5")
      .arg(p_mm.x(), 0, 'f', 1)
      .arg(p_mm.y(), 0, 'f', 1)
      .arg(p_mm.z(), 0, 'f', 1)
      .arg(pulse.field->tier)
      .arg(QString::fromStdString(pulse.field->coil));
}

bool isValue(int column) {
  return column >= PulseTable::kFirstValue && column < PulseTable::kFirstValue + kValues;
}

}  // namespace

PulseTable::PulseTable(ReviewPresenter& presenter, QObject* parent)
    : QAbstractTableModel(parent), presenter_(presenter), session_(presenter.session()) {
  connect(&presenter_, &ReviewPresenter::sessionChanged, this, [this] {
    const auto fresh = presenter_.session();
    const bool is_same_shape = fresh && session_ && fresh->kept.folder == session_->kept.folder &&
                               fresh->kept.pulses.pulses.size() == session_->kept.pulses.pulses.size();
    if (!is_same_shape) beginResetModel();
    session_ = fresh;
    if (!is_same_shape) return endResetModel();
    if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
  });
}

int PulseTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || !session_ ? 0 : int(session_->kept.pulses.pulses.size());
}
int PulseTable::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : noteColumn() + 1;
}
int PulseTable::noteColumn() const { return kFirstValue + kValues; }
const casefile::ReviewedPulse& PulseTable::at(int row) const {
  return session_->kept.pulses.pulses[std::size_t(row)];
}
int PulseTable::numberAt(int row) const { return at(row).pulse.number; }
bool PulseTable::isExcluded(int row) const { return at(row).is_excluded; }

bool PulseTable::isEmptyColumn(int column) const {
  if (!isValue(column) || column == columnOf(report::PulseColumn::mep)) return false;
  for (int row = 0; row < rowCount(); ++row)
    if (report::valueOf(at(row).pulse, valueColumn(column).column)) return false;
  return true;
}

QString PulseTable::stateWords(const casefile::ReviewedPulse& reviewed) const {
  if (reviewed.is_excluded) return tr("\u2715 excluded");
  switch (reviewed.pulse.status) {
    case casefile::PulseStatus::on_target:
      return tr("\u25cf on target");
    case casefile::PulseStatus::outside:
      return tr("\u25a1 outside");
    case casefile::PulseStatus::lost:
      break;
  }
  return tr("\u2013 lost");
}

QVariant PulseTable::text(const casefile::ReviewedPulse& reviewed, int column) const {
  const casefile::Pulse& pulse = reviewed.pulse;
  if (column == kNumber) return pulse.number;
  if (column == kState) return stateWords(reviewed);
  if (column == kTarget) return pulse.target ? QString::fromStdString(pulse.target->name) : QString();
  if (isValue(column)) return QString::fromStdString(report::valueText(pulse, valueColumn(column).column));
  return reviewed.is_excluded ? QString::fromStdString(reviewed.note) : shownWords(pulse.reason);
}

/// Value to sort by; unknown values come last in ascending order.
QVariant PulseTable::sortKey(const casefile::ReviewedPulse& reviewed, int column) const {
  if (column == kNumber) return reviewed.pulse.number;
  if (!isValue(column)) return text(reviewed, column).toString().toLower();
  return report::valueOf(reviewed.pulse, valueColumn(column).column)
      .value_or(std::numeric_limits<double>::max());
}

QVariant PulseTable::data(const QModelIndex& index, int role) const {
  if (!session_ || index.row() >= rowCount()) return {};
  const auto& reviewed = at(index.row());
  switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
      return text(reviewed, index.column());
    case kSortRole:
      return sortKey(reviewed, index.column());
    case Qt::TextAlignmentRole:
      return int(Qt::AlignVCenter | (isValue(index.column()) ? Qt::AlignRight : Qt::AlignLeft));
    case Qt::ForegroundRole:
      return reviewed.is_excluded ? QVariant(themeColour(Colour::muted)) : QVariant();
    case Qt::ToolTipRole:
      if (index.column() == columnOf(report::PulseColumn::mep) &&
          session_->kept.pulses.edited_meps.count(reviewed.pulse.number))
        return tr("entered after the pulse; double click to type another");
      if (index.column() == kTarget || index.column() == noteColumn()) return text(reviewed, index.column());
      if (index.column() == columnOf(report::PulseColumn::peak_field) ||
          index.column() == columnOf(report::PulseColumn::peak_field_per_rate))
        return fieldPlaceWords(reviewed.pulse);
      return QString::fromStdString(report::localTime(reviewed.pulse.utc)) + " " +
             shownWords(reviewed.pulse.reason);
    default:
      return {};
  }
}

QVariant PulseTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  if (section == kNumber) return tr("pulse");
  if (section == kState) return tr("state");
  if (section == kTarget) return tr("target");
  if (!isValue(section)) return tr("reason");
  const auto& words = valueColumn(section);
  return shownWords(std::string(words.name)) + "\n" + QString::fromUtf8(words.unit);
}

Qt::ItemFlags PulseTable::flags(const QModelIndex& index) const {
  const auto flags = QAbstractTableModel::flags(index);
  return index.column() == columnOf(report::PulseColumn::mep) ? flags | Qt::ItemIsEditable : flags;
}

bool PulseTable::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || index.column() != columnOf(report::PulseColumn::mep)) return false;
  if (value.toString() == text(at(index.row()), index.column()).toString()) return false;
  presenter_.typeMep(numberAt(index.row()), value.toString());
  return true;
}

}  // namespace facenav::ui
