// Takes a series from the hospital's archive to a case by mouse and keyboard alone: the real window with its
// real services, a real archive (Orthanc), a real MRI.

#include <gmock/gmock.h>

#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QtTest>

#include "facenav/casefile/case_store.h"
#include "facenav/dicom/series.h"
#include "facenav/scene/display.h"
#include "facenav/volume/nifti.h"
#include "gui_fixtures.h"
#include "prepare/archive_page.h"
#include "prepare/prepare_workspace.h"
#include "registrations.h"
#include "shell/main_window.h"
#include "support/orthanc.h"

namespace facenav::ui {
namespace {

constexpr int kPrepareLimitMs = 150000;  // enough for a busy machine

/// Operates the archive page of a window by mouse and keyboard.
class ArchiveHand {
 public:
  explicit ArchiveHand(MainWindow& window) : page_(*window.findChild<ArchivePage*>()) {}

  void type(const char* field, const std::string& text) {
    for (auto* each : page_.findChildren<QWidget*>())
      if (each->accessibleName() == field) {
        QTest::keyClick(each, Qt::Key_A, Qt::ControlModifier);
        // The field keeps the focus: its content must count anyway.
        return QTest::keyClicks(each, QString::fromStdString(text));
      }
    FAIL() << "no field " << field;
  }
  void press(const char* words) {
    for (auto* button : page_.findChildren<QPushButton*>())
      if (button->text() == words && button->isEnabled()) return QTest::mouseClick(button, Qt::LeftButton);
    FAIL() << "no button " << words;
  }
  /// Waits for the archive's answer and returns its words on the page.
  std::string answer() {
    fixtures::waitFor([&] { return button("Find").isEnabled(); });
    return said().toStdString();
  }
  QTableWidget& table() { return *page_.findChild<QTableWidget*>(); }

 private:
  QPushButton& button(const char* words) {
    for (auto* each : page_.findChildren<QPushButton*>())
      if (each->text() == words) return *each;
    throw Error("no such button", words);
  }
  QString said() const {
    for (const char* name : {"fault", "muted", "taskwords"})
      for (auto* label : page_.findChildren<QLabel*>(name))
        if (label->isVisible() && !label->text().isEmpty()) return label->text();
    return {};
  }
  ArchivePage& page_;
};

TEST(ArchiveInTheWindow, ASeriesIsFoundFetchedAndBecomesACase) {
  if (!scene::hasDisplay()) GTEST_SKIP() << "no X display here: run under xvfb-run";
  FACENAV_NEEDS_ORTHANC();
  FACENAV_NEEDS(testing::virtualPatientMri());
  const testing::TemporaryFolder folder;
  const testing::Orthanc archive;
  dicom::writeSeries(volume::readNifti(testing::virtualPatientMri()).volume, folder.path() / "in", {});
  ASSERT_TRUE(archive.answers(archive.node()));
  TaskMonitor monitor;
  const int sent = pacs::store(archive.node(), folder.path() / "in", monitor);

  MainWindow window(servicesWith(app::makeRegistrations));
  window.show();
  window.setCasesFolder(QString::fromStdString((folder.path() / "cases").string()));
  window.setPrepareStep(PrepareStep::archive);
  QApplication::processEvents();
  ArchiveHand hand(window);
  hand.type("address", archive.node().host);
  hand.type("port", std::to_string(archive.node().port));
  hand.type("its title", "SOMEBODY");
  hand.press("Test");
  EXPECT_THAT(hand.answer(), ::testing::HasSubstr("SOMEBODY")) << "a wrong title is named";
  hand.type("its title", "ORTHANC");
  hand.press("Test");
  EXPECT_THAT(hand.answer(), ::testing::HasSubstr("answers"));
  hand.type("patient ID", "FaceNav-*");
  hand.press("Find");
  hand.answer();
  ASSERT_EQ(hand.table().rowCount(), 1);
  hand.press("Fetch and prepare");
  ASSERT_TRUE(fixtures::waitFor([&] { return !window.queue().jobs().empty(); }, 60000)) << hand.answer();
  EXPECT_EQ(window.prepareStep(), PrepareStep::worklist) << "where it is seen on its way";
  ASSERT_TRUE(fixtures::waitFor(
      [&] {
        return window.queue().jobs().empty() || window.queue().jobs().front().state == JobState::failed;
      },
      kPrepareLimitMs));
  ASSERT_TRUE(window.queue().jobs().empty()) << window.queue().jobs().front().failure.toStdString();

  ASSERT_TRUE(fixtures::waitFor([&] { return window.worklist().rows().size() == 1; }));
  const auto row = window.worklist().rows().front();
  EXPECT_EQ(row.state, "prepared");
  const auto store = casefile::CaseStore::open(row.case_folder.toStdString());
  EXPECT_THAT(std::vector<int>(std::begin(store.mri().grid.size), std::end(store.mri().grid.size)),
              ::testing::Contains(sent))
      << "all of its slices";
  EXPECT_TRUE(std::filesystem::is_empty(receivedFolder().toStdString())) << "what was fetched is gone";
}

}  // namespace
}  // namespace facenav::ui
