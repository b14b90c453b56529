#pragma once
// ArchivePresenter: the hospital's archive (PACS) from the window: test the connection, list series, fetch
// one into the queue. The connection is remembered; a query is not, since it may name a patient. Fetched
// files lie in a private folder that is removed when the case is made.

#include <QObject>
#include <optional>
#include <vector>

#include "prepare/prepare_queue.h"
#include "shell/services.h"
#include "shell/task_runner.h"

namespace facenav::ui {

/// The archive as it was set up; nothing if it never was.
std::optional<pacs::PacsNode> keptArchive();

class ArchivePresenter : public QObject {
  Q_OBJECT

 public:
  ArchivePresenter(const Services& services, PrepareQueue& queue, QObject* parent = nullptr);

  const pacs::PacsNode& node() const { return node_; }
  void setNode(const pacs::PacsNode& node);
  pacs::Retrieval retrieval() const { return retrieval_; }
  void setRetrieval(pacs::Retrieval retrieval);

  /// Tests the connection (C-ECHO).
  void test();
  void find(const pacs::PacsQuery& query);
  /// Fetches one line of the result and queues it.
  void fetch(int line);
  void cancel() { runner_.cancel(); }

  const std::vector<pacs::PacsSeries>& series() const { return series_; }
  bool isBusy() const { return runner_.isRunning(); }
  /// Current step, result or failure.
  QString words() const { return words_; }
  bool isFault() const { return is_fault_; }

 signals:
  void changed();
  /// The result changed.
  void found();
  void queued();

 private:
  void run(const QString& title, TaskRunner::Work work);
  void say(const QString& words, bool is_fault);

  const Services& services_;
  PrepareQueue& queue_;
  TaskRunner runner_;
  pacs::PacsNode node_;
  pacs::Retrieval retrieval_ = pacs::Retrieval::automatic;
  std::vector<pacs::PacsSeries> series_;
  QString words_, title_;
  bool is_fault_ = false;
};

}  // namespace facenav::ui
