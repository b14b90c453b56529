#include "prepare/worklist_table.h"

#include <algorithm>

namespace facenav::ui {
namespace {

constexpr qlonglong kBeforeAll_s = 1000000000000;  // sorts before all cases

QVariant textOf(const WorklistRow& row, int column) {
  switch (column) {
    case WorklistTable::state:
      return row.state;
    case WorklistTable::name:
      return row.name;
    case WorklistTable::age:
      return row.age;
    case WorklistTable::findings:
      return row.findings < 0 ? QString() : QString::number(row.findings);
    case WorklistTable::checked_by:
      return row.checked_by;
    default:
      return row.detail;
  }
}

QVariant sortKey(const WorklistRow& row, int column) {
  if (column == WorklistTable::state) return row.state_order;
  if (column == WorklistTable::findings) return row.findings;
  if (column == WorklistTable::age) {  // jobs have no age: list them before all cases, in their own order
    if (row.job_id) return qlonglong(row.job_id) - kBeforeAll_s;
    return row.created.isValid() ? -row.created.toSecsSinceEpoch() : qlonglong(0);
  }
  return textOf(row, column).toString().toLower();
}

bool isSame(const WorklistRow& a, const WorklistRow& b) {
  return a.job_id == b.job_id && a.case_folder == b.case_folder;
}

/// True if `all` contains every row of `some`, in the same order.
bool isInOrderOf(const std::vector<WorklistRow>& some, const std::vector<WorklistRow>& all) {
  auto next = some.begin();
  for (const auto& row : all)
    if (next != some.end() && isSame(*next, row)) ++next;
  return next == some.end();
}

}  // namespace

WorklistTable::WorklistTable(WorklistPresenter& presenter, QObject* parent)
    : QAbstractTableModel(parent), presenter_(presenter), rows_(presenter.rows()) {
  connect(&presenter_, &WorklistPresenter::changed, this, &WorklistTable::update);
}

/// Adds and removes single rows, so that the view keeps its selection and a label being typed.
void WorklistTable::update() {
  const auto& fresh = presenter_.rows();
  removeMissing(fresh);
  if (isInOrderOf(rows_, fresh)) {
    insertNew(fresh);
    rows_ = fresh;
    if (!rows_.empty()) emit dataChanged(index(0, 0), index(int(rows_.size()) - 1, columns - 1));
    return;
  }
  beginResetModel();
  rows_ = fresh;
  endResetModel();
}

void WorklistTable::removeMissing(const std::vector<WorklistRow>& fresh) {
  for (int line = int(rows_.size()) - 1; line >= 0; --line) {
    const auto& row = rows_[std::size_t(line)];
    const auto is_it = [&](const WorklistRow& other) { return isSame(row, other); };
    if (std::any_of(fresh.begin(), fresh.end(), is_it)) continue;
    beginRemoveRows({}, line, line);
    rows_.erase(rows_.begin() + line);
    endRemoveRows();
  }
}

/// Inserts the missing rows of `fresh`. `rows_` must be a subset of `fresh` in the same order.
void WorklistTable::insertNew(const std::vector<WorklistRow>& fresh) {
  for (int line = 0; line < int(fresh.size()); ++line) {
    const auto& row = fresh[std::size_t(line)];
    if (line < int(rows_.size()) && isSame(rows_[std::size_t(line)], row)) continue;
    beginInsertRows({}, line, line);
    rows_.insert(rows_.begin() + line, row);
    endInsertRows();
  }
}

int WorklistTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : int(rows_.size());
}
int WorklistTable::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : columns; }

QVariant WorklistTable::data(const QModelIndex& index, int role) const {
  const auto& row = rows_[std::size_t(index.row())];
  if (role == Qt::DisplayRole) return textOf(row, index.column());
  if (role == Qt::EditRole) return index.column() == name ? row.label : QVariant();
  if (role == Qt::ToolTipRole) return index.column() == detail ? row.detail : row.case_folder;
  if (role == kSortRole) return sortKey(row, index.column());
  if (role == kMarkRole) return int(row.mark);
  if (role == kFractionRole) return row.fraction;
  if (role == Qt::TextAlignmentRole && index.column() == findings) return int(Qt::AlignCenter);
  return {};
}

Qt::ItemFlags WorklistTable::flags(const QModelIndex& index) const {
  const auto flags = QAbstractTableModel::flags(index);
  return index.column() == name && rows_[std::size_t(index.row())].can_be_labelled
             ? flags | Qt::ItemIsEditable
             : flags;
}

bool WorklistTable::setData(const QModelIndex& index, const QVariant& value, int role) {
  const auto& row = rows_[std::size_t(index.row())];
  if (role != Qt::EditRole || index.column() != name || !row.can_be_labelled) return false;
  const QString words = value.toString();
  if (words != row.label) presenter_.setLabel(QString(row.case_folder), words);
  return true;
}

QVariant WorklistTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  const QString names[columns] = {tr("State"),    tr("Case"),       tr("Age"),
                                  tr("Findings"), tr("Checked by"), tr("What to look at")};
  if (role == Qt::DisplayRole) return names[section];
  if (role == Qt::TextAlignmentRole)
    return int(section == findings ? Qt::AlignCenter : Qt::AlignLeft | Qt::AlignVCenter);
  return {};
}

WorklistFilter::WorklistFilter(WorklistTable& table, QObject* parent)
    : QSortFilterProxyModel(parent), table_(table) {
  setSourceModel(&table);
  setSortRole(WorklistTable::kSortRole);
  setDynamicSortFilter(true);
}

void WorklistFilter::setWords(const QString& words) {
  words_ = words.toLower().split(' ', Qt::SkipEmptyParts);
  invalidateFilter();
}

const WorklistRow& WorklistFilter::row(const QModelIndex& index) const {
  return table_.row(mapToSource(index).row());
}

bool WorklistFilter::filterAcceptsRow(int line, const QModelIndex&) const {
  const auto& row = table_.row(line);
  const QString text =
      QStringList{row.state, row.name, row.case_folder.section('/', -1), row.age, row.checked_by, row.detail}
          .join(' ')
          .toLower();
  return std::all_of(words_.begin(), words_.end(), [&](const QString& word) { return text.contains(word); });
}

}  // namespace facenav::ui
