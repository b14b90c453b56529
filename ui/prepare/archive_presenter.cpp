#include "prepare/archive_presenter.h"

#include <QSettings>
#include <QUuid>
#include <cmath>

namespace facenav::ui {
namespace {

QString text(const std::string& words) { return QString::fromStdString(words); }

pacs::PacsNode storedNode() {
  QSettings settings;
  settings.beginGroup("archive");
  pacs::PacsNode node;
  const auto words = [&](const char* key, const std::string& otherwise) {
    return settings.value(key, text(otherwise)).toString().toStdString();
  };
  node.host = words("host", node.host);
  node.port = settings.value("port", node.port).toInt();
  node.title = words("title", node.title);
  node.own_title = words("own_title", node.own_title);
  node.own_port = settings.value("own_port", node.own_port).toInt();
  node.timeout_s = settings.value("timeout_s", node.timeout_s).toInt();
  if (const auto trusted = words("tls_trust", {}); !trusted.empty())
    node.tls = pacs::Tls{trusted, words("tls_certificate", {}), words("tls_key", {})};
  return node;
}

void storeNode(const pacs::PacsNode& node) {
  QSettings settings;
  settings.beginGroup("archive");
  settings.setValue("host", text(node.host));
  settings.setValue("port", node.port);
  settings.setValue("title", text(node.title));
  settings.setValue("own_title", text(node.own_title));
  settings.setValue("own_port", node.own_port);
  settings.setValue("timeout_s", node.timeout_s);
  const auto tls = node.tls.value_or(pacs::Tls{});
  settings.setValue("tls_trust", text(tls.trusted_certificate.string()));
  settings.setValue("tls_certificate", text(tls.certificate.string()));
  settings.setValue("tls_key", text(tls.key.string()));
}

}  // namespace

std::optional<pacs::PacsNode> keptArchive() {
  return QSettings().contains("archive/host") ? std::optional(storedNode()) : std::nullopt;
}

ArchivePresenter::ArchivePresenter(const Services& services, PrepareQueue& queue, QObject* parent)
    : QObject(parent), services_(services), queue_(queue), node_(storedNode()) {
  retrieval_ = pacs::Retrieval(std::clamp(QSettings().value("archive/retrieval", 0).toInt(), 0, 2));
  connect(&runner_, &TaskRunner::progressed, this, [this](const QString& step, double fraction) {
    say(fraction > 0 ? tr("%1: %2 %3 %").arg(title_, step).arg(std::lround(100 * fraction))
                     : tr("%1: %2").arg(title_, step),
        false);
  });
  connect(&runner_, &TaskRunner::failed, this, [this](const QString& words) { say(words, true); });
  connect(&runner_, &TaskRunner::cancelled, this,
          [this] { say(tr("%1: cancelled, nothing was kept").arg(title_), false); });
}

void ArchivePresenter::setNode(const pacs::PacsNode& node) {
  node_ = node;
  storeNode(node);
}

void ArchivePresenter::setRetrieval(pacs::Retrieval retrieval) {
  retrieval_ = retrieval;
  QSettings().setValue("archive/retrieval", int(retrieval));
}

void ArchivePresenter::say(const QString& words, bool is_fault) {
  words_ = words;
  is_fault_ = is_fault;
  emit changed();
}

void ArchivePresenter::run(const QString& title, TaskRunner::Work work) {
  if (runner_.isRunning()) return;
  title_ = title;
  runner_.start(title, std::move(work));
  say(title + QChar(0x2026), false);
}

void ArchivePresenter::test() {
  run(tr("Calling the archive"), [this, node = node_](TaskMonitor&) -> TaskRunner::Delivery {
    services_.callArchive(node);
    return [this] { say(tr("\u2713 the archive answers and knows us"), false); };
  });
}

void ArchivePresenter::find(const pacs::PacsQuery& query) {
  run(tr("Asking the archive"), [this, node = node_, query](TaskMonitor& monitor) -> TaskRunner::Delivery {
    auto series = services_.findInArchive(node, query, monitor);
    return [this, series = std::move(series)] {
      series_ = series;
      emit found();
      say(series_.empty() ? tr("nothing in the archive matches") : tr("series found: %1").arg(series_.size()),
          false);
    };
  });
}

void ArchivePresenter::fetch(int line) {
  if (line < 0 || std::size_t(line) >= series_.size()) return;
  const auto series = series_[std::size_t(line)];
  const QString folder = receivedFolder() + "/" + QUuid::createUuid().toString(QUuid::Id128);
  run(tr("Fetching"),
      [this, node = node_, series, folder, how = retrieval_](TaskMonitor& monitor) -> TaskRunner::Delivery {
        const int images =
            services_.fetchFromArchive(node, series, folder.toStdString(), how, monitor).images;
        return [this, folder, images] {
          queue_.add(folder);
          say(tr("\u2713 %1 images fetched: in the worklist's queue").arg(images), false);
          emit queued();
        };
      });
}

}  // namespace facenav::ui
