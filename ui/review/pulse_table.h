#pragma once
// PulseTable: the pulses of a session as a table that Qt's views sort. The MEP can be edited.

#include <QAbstractTableModel>

#include "review/review_presenter.h"

namespace facenav::ui {

class PulseTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  /// The columns: number, state, target, those of report::pulseColumns(), note.
  static constexpr int kNumber = 0, kState = 1, kTarget = 2, kFirstValue = 3;
  static constexpr int kSortRole = Qt::UserRole;

  explicit PulseTable(ReviewPresenter& presenter, QObject* parent = nullptr);
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  /// The pulse's number in its session.
  int numberAt(int row) const;
  bool isExcluded(int row) const;
  /// True if no pulse has a value in the column of a value; MEPs can be typed, so theirs is never so.
  bool isEmptyColumn(int column) const;
  /// The column of the table for one of the values.
  static int columnOf(report::PulseColumn column) { return kFirstValue + int(column); }

 private:
  const casefile::ReviewedPulse& at(int row) const;
  int noteColumn() const;
  QString stateWords(const casefile::ReviewedPulse& reviewed) const;
  QVariant text(const casefile::ReviewedPulse& reviewed, int column) const;
  QVariant sortKey(const casefile::ReviewedPulse& reviewed, int column) const;

  ReviewPresenter& presenter_;
  std::shared_ptr<const ReviewedSession> session_;
};

}  // namespace facenav::ui
