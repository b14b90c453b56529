#include "plan/import_list.h"

#include <QHeaderView>
#include <QRegularExpression>
#include <QTreeWidgetItemIterator>
#include <algorithm>
#include <set>

#include "plan/other_words.h"
#include "shell/appearance.h"
#include "shell/shown_words.h"

namespace facenav::ui {
namespace {

using interop::Kind;
using steps::ItemFate;

constexpr int kMostPulses = 500;  // rows of a session, which says how many it has
enum ImportColumn { kNameColumn, kFateColumn, kPlaceColumn, kKindColumn };
enum ImportRole { kFileRole = Qt::UserRole, kItemRole, kSessionRole, kRowNameRole, kReasonRole };

ImportRow importRowOf(const QTreeWidgetItem& item) {
  return {item.data(0, kFileRole).toInt(), item.data(0, kItemRole).toInt(),
          item.data(0, kSessionRole).toBool(), item.data(0, kRowNameRole).toString(),
          item.data(0, kReasonRole).toString()};
}

/// "Brainsight text export, version 12; 2 refused", or why the file cannot be read.
QString fileWords(const steps::PreviewedFile& file) {
  if (!file.failure.empty()) return ImportList::tr("cannot be read: %1").arg(inWindowWords(file.failure));
  QString words = shownWords(file.preview.file.words);
  if (const int refused = file.preview.count(ItemFate::refused))
    words += ImportList::tr("; %1 refused").arg(refused);
  return words;
}

/// True if the reason stands in a row above the item's: several are refused for it.
bool isToldAbove(const steps::RefusedItems& refused) { return refused.items.size() > 1; }

struct SessionCount {
  int pulses = 0, with_pose = 0, refused = 0;
  ItemFate fate = ItemFate::refused;
};

SessionCount countOf(const steps::ImportPreview& preview, const std::string& session) {
  SessionCount count;
  for (const auto& [item, fate, reason] : preview.items) {
    if (item.kind != Kind::pulse || item.session != session) continue;
    ++count.pulses;
    count.with_pose += item.mri_T_coil.has_value();
    count.refused += fate == ItemFate::refused;
    if (fate != ItemFate::refused) count.fate = fate;
  }
  return count;
}

QString sessionWords(const SessionCount& count) {
  steps::PreviewedItem whole;
  whole.fate = count.fate;
  QString words = fateWords(whole) + "; " +
                  ImportList::tr("%1 pulses, %2 with a pose").arg(count.pulses).arg(count.with_pose);
  if (count.refused > 0 && count.fate != ItemFate::refused)
    words += ImportList::tr(", %1 refused").arg(count.refused);
  return words;
}

}  // namespace

ImportList::ImportList(ImportPresenter& presenter, QWidget* parent)
    : QTreeWidget(parent), presenter_(presenter) {
  setObjectName("import_list");
  setAccessibleName(tr("what the files hold"));
  setToolTip(tr("Space: take in or leave out   arrows: choose, open and close"));
  setHeaderLabels({tr("name"), tr("outcome"), tr("place (RAS, mm)"), tr("kind")});
  setAlternatingRowColors(true);
  setUniformRowHeights(true);
  setTextElideMode(Qt::ElideRight);
  header()->setStretchLastSection(false);
  header()->setSectionsMovable(false);
  connect(&presenter_, &ImportPresenter::changed, this, &ImportList::fill);
  connect(this, &QTreeWidget::itemChanged, this, &ImportList::take);
  connect(this, &QTreeWidget::currentItemChanged, this, [this] {
    if (!is_filling_) emit chosenChanged();
  });
}

ImportRow ImportList::chosen() const { return currentItem() ? importRowOf(*currentItem()) : ImportRow(); }

QTreeWidgetItem* ImportList::find(const ImportRow& row) const {
  for (QTreeWidgetItemIterator it(const_cast<ImportList*>(this)); *it; ++it)
    if (importRowOf(**it) == row) return *it;
  return nullptr;
}

void ImportList::choose(const ImportRow& row) {
  auto* found = find(row);
  if (!found) return;
  setCurrentItem(found);
  scrollToItem(found);
}

/// Fills the tree anew; the chosen row stays chosen, and what was closed stays closed.
void ImportList::fill() {
  const bool was_empty = topLevelItemCount() == 0;
  const ImportRow row = chosen();
  std::vector<ImportRow> open;
  for (QTreeWidgetItemIterator it(this); *it; ++it)
    if ((*it)->isExpanded()) open.push_back(importRowOf(**it));
  is_filling_ = true;
  clear();
  for (int file = 0; file < int(presenter_.files().size()); ++file) fillFile(file);
  for (QTreeWidgetItemIterator it(this); *it; ++it)
    (*it)->setExpanded(was_empty ? !(*it)->parent()
                                 : std::find(open.begin(), open.end(), importRowOf(**it)) != open.end());
  auto* current = find(row);
  if (!current && topLevelItemCount() > 0)
    current = topLevelItem(0)->childCount() > 0 ? topLevelItem(0)->child(0) : topLevelItem(0);
  if (current) setCurrentItem(current);
  is_filling_ = false;
  if (was_empty) fitColumns();
  emit chosenChanged();
}

void ImportList::fillFile(int file) {
  const auto& previewed = presenter_.files()[std::size_t(file)];
  const QString name = QString::fromStdString(previewed.order.file.filename().string());
  auto* top = addRow(nullptr, {file, -1, false, name}, {name, fileWords(previewed), {}, tr("file")});
  std::set<std::size_t> told;
  for (const auto& refused : previewed.preview.refusals())
    if (isToldAbove(refused)) {
      told.insert(refused.items.begin(), refused.items.end());
      addRefused(top, file, refused);
    }
  for (int i = 0; i < int(previewed.preview.items.size()); ++i) {
    const auto& item = previewed.preview.items[std::size_t(i)].item;
    if (told.count(std::size_t(i)) > 0) continue;
    auto* parent = item.kind == Kind::pulse ? sessionRow(top, file, item.session) : top;
    if (parent == top || parent->childCount() < kMostPulses) addItem(parent, file, i);
  }
}

/// Adds a row for several items that are refused for one reason; their own rows lie below it.
void ImportList::addRefused(QTreeWidgetItem* top, int file, const steps::RefusedItems& refused) {
  steps::PreviewedItem all;
  all.fate = ItemFate::refused;
  all.reason = refused.reason;
  const ImportRow row{file, -1, false, {}, QString::fromStdString(refused.reason)};
  auto* above = addRow(top, row, {tr("%1 items").arg(refused.items.size()), fateWords(all), {}, {}});
  const auto shown = std::min<std::size_t>(refused.items.size(), kMostPulses);
  for (std::size_t i = 0; i < shown; ++i) {
    addItem(above, file, int(refused.items[i]));
    above->child(int(i))->setText(kFateColumn, tr("refused"));
  }
}

QTreeWidgetItem* ImportList::addRow(QTreeWidgetItem* parent, const ImportRow& row, const QStringList& texts) {
  auto* added = parent ? new QTreeWidgetItem(parent, texts) : new QTreeWidgetItem(this, texts);
  added->setData(0, kFileRole, row.file);
  added->setData(0, kItemRole, row.item);
  added->setData(0, kSessionRole, row.is_session);
  added->setData(0, kRowNameRole, row.name);
  added->setData(0, kReasonRole, row.reason);
  for (int column = 0; column < texts.size(); ++column) added->setToolTip(column, texts[column]);
  return added;
}

void ImportList::addItem(QTreeWidgetItem* parent, int file, int item) {
  const auto& previewed = presenter_.files()[std::size_t(file)].preview.items[std::size_t(item)];
  const QString name = QString::fromStdString(previewed.item.name);
  QString fate = fateWords(previewed);
  if (!previewed.item.notes.empty()) fate += tr(" (see below)");
  auto* row = addRow(parent, {file, item, false, name},
                     {name, fate, importedPlaceWords(previewed.item), kindWords(previewed.item.kind)});
  const bool may_come = previewed.fate == ItemFate::added || previewed.fate == ItemFate::replaced ||
                        previewed.fate == ItemFate::left_out;
  if (previewed.item.kind == Kind::target && may_come) setTick(*row, previewed.fate != ItemFate::left_out);
}

/// The row of a session's pulses; added with its first pulse.
QTreeWidgetItem* ImportList::sessionRow(QTreeWidgetItem* parent, int file, const std::string& session) {
  const ImportRow wanted{file, -1, true, QString::fromStdString(session)};
  for (int i = parent->childCount() - 1; i >= 0; --i)
    if (importRowOf(*parent->child(i)) == wanted) return parent->child(i);
  const auto count = countOf(presenter_.files()[std::size_t(file)].preview, session);
  auto* row = addRow(parent, wanted,
                     {session.empty() ? tr("pulses") : QString::fromStdString(session),
                      sessionWords(count),
                      {},
                      tr("session")});
  if (count.fate == ItemFate::added || count.fate == ItemFate::left_out)
    setTick(*row, count.fate == ItemFate::added);
  return row;
}

void ImportList::setTick(QTreeWidgetItem& row, bool is_taken) {
  row.setFlags(row.flags() | Qt::ItemIsUserCheckable);
  row.setCheckState(0, is_taken ? Qt::Checked : Qt::Unchecked);
}

void ImportList::take(QTreeWidgetItem* changed) {
  if (is_filling_) return;
  const ImportRow row = importRowOf(*changed);
  const bool is_taken = changed->checkState(0) == Qt::Checked;
  const std::string name = row.name.toStdString();
  if (row.is_session)
    presenter_.setSessionTaken(std::size_t(row.file), name, is_taken);
  else if (row.item >= 0)
    presenter_.setTargetTaken(std::size_t(row.file), name, is_taken);
}

/// "line 3" in the window's language; any other place is a name in the file.
QString ImportList::placeInFileWords(const std::string& where) {
  static const QRegularExpression kLine("^line (\\d+)$");
  const QString words = QString::fromStdString(where);
  const auto line = kLine.match(words);
  return line.hasMatch() ? tr("line %1").arg(line.captured(1)) : shownWords(words);
}

QString ImportList::describe() const {
  const ImportRow row = chosen();
  if (row.file < 0) return {};
  const auto& file = presenter_.files()[std::size_t(row.file)];
  QStringList lines;
  if (row.item >= 0) {
    const auto& previewed = file.preview.items[std::size_t(row.item)];
    lines << tr("%1 (%2): %3").arg(row.name, placeInFileWords(previewed.item.where), fateWords(previewed));
    for (const auto& note : previewed.item.notes) lines << inWindowWords(note);
  } else {
    lines << tr("%1: %2").arg(currentItem()->text(kNameColumn), currentItem()->text(kFateColumn));
  }
  if (file.failure.empty() && presenter_.t1()) lines << assumedWords(file, presenter_.t1()->used);
  for (const auto& note : file.preview.file.notes) lines << inWindowWords(note);
  return lines.join("\n");
}

/// Gives the texts their widths as far as the list has them; what becomes of an item takes the rest.
void ImportList::fitColumns() {
  for (int column = 0; column < columnCount(); ++column) resizeColumnToContents(column);
  const int room_px = viewport()->width();
  const int most_px = room_px * 2 / 5;
  if (columnWidth(kNameColumn) > most_px) setColumnWidth(kNameColumn, most_px);
  const int others_px = columnWidth(kNameColumn) + columnWidth(kPlaceColumn) + columnWidth(kKindColumn);
  setColumnWidth(kFateColumn, std::max(sized(150), room_px - others_px));
}

void ImportList::resizeEvent(QResizeEvent* event) {
  QTreeWidget::resizeEvent(event);
  fitColumns();
}

}  // namespace facenav::ui
