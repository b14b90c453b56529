#pragma once
// ImportList: what files of other programs hold, as a tree: the files, under each its targets, sessions of
// pulses, and places. Space ticks what comes in.

#include <QTreeWidget>

#include "plan/import_presenter.h"

namespace facenav::ui {

/// A row of the list.
struct ImportRow {
  int file = -1, item = -1;  // of ImportPresenter::files(); item -1: the file itself, or a session
  bool is_session = false;
  QString name;         // of the item or the session
  QString reason = {};  // of a row that stands for several items that are refused for it
  bool operator==(const ImportRow& other) const {
    return file == other.file && (item < 0) == (other.item < 0) && is_session == other.is_session &&
           name == other.name && reason == other.reason;
  }
};

class ImportList : public QTreeWidget {
  Q_OBJECT

 public:
  explicit ImportList(ImportPresenter& presenter, QWidget* parent = nullptr);
  /// The chosen row; its file is -1 if there is none.
  ImportRow chosen() const;
  void choose(const ImportRow& row);
  /// Whole sentences on the chosen row: its reason, what was corrected, and what the file says.
  QString describe() const;

 signals:
  void chosenChanged();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  static QString placeInFileWords(const std::string& where);
  void fill();
  void fillFile(int file);
  QTreeWidgetItem* addRow(QTreeWidgetItem* parent, const ImportRow& row, const QStringList& texts);
  void addItem(QTreeWidgetItem* parent, int file, int item);
  void addRefused(QTreeWidgetItem* top, int file, const steps::RefusedItems& refused);
  QTreeWidgetItem* sessionRow(QTreeWidgetItem* parent, int file, const std::string& session);
  void setTick(QTreeWidgetItem& row, bool is_taken);
  QTreeWidgetItem* find(const ImportRow& row) const;
  void take(QTreeWidgetItem* changed);
  void fitColumns();

  ImportPresenter& presenter_;
  bool is_filling_ = false;
};

}  // namespace facenav::ui
