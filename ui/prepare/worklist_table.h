#pragma once
// WorklistTable: the worklist as a table that Qt's views sort and filter.

#include <QAbstractTableModel>
#include <QSortFilterProxyModel>

#include "prepare/worklist_presenter.h"

namespace facenav::ui {

class WorklistTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { state, name, age, findings, checked_by, detail, columns };
  static constexpr int kSortRole = Qt::UserRole, kMarkRole = Qt::UserRole + 1,
                       kFractionRole = Qt::UserRole + 2;

  explicit WorklistTable(WorklistPresenter& presenter, QObject* parent = nullptr);
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  /// Edits a case's label in place.
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  const WorklistRow& row(int line) const { return rows_[std::size_t(line)]; }

 private:
  void update();
  void removeMissing(const std::vector<WorklistRow>& fresh);
  void insertNew(const std::vector<WorklistRow>& fresh);

  WorklistPresenter& presenter_;
  std::vector<WorklistRow> rows_;
};

/// Filters by words that must all occur in a row; sorts by kSortRole.
class WorklistFilter : public QSortFilterProxyModel {
  Q_OBJECT

 public:
  explicit WorklistFilter(WorklistTable& table, QObject* parent = nullptr);
  void setWords(const QString& words);
  const WorklistRow& row(const QModelIndex& index) const;

 protected:
  bool filterAcceptsRow(int line, const QModelIndex& parent) const override;

 private:
  WorklistTable& table_;
  QStringList words_;
};

}  // namespace facenav::ui
