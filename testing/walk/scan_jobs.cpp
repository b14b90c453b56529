#include <gtest/gtest.h>

#include <QLineEdit>
#include <QListWidget>
#include <QSettings>
#include <QTableView>

#include "jobs.h"
#include "plan/target_list.h"
#include "prepare/prepare_workspace.h"
#include "shell/main_window.h"
#include "shell/scene_view.h"
#include "shell/slice_view.h"

namespace facenav::walk {
namespace {

using ui::MainWindow;
using ui::PrepareStep;
using Page = Robot::Page;

constexpr int kPreparing_ms = 200000;

bool isEnabled(const QWidget& window, const QString& words) {
  const auto* button = buttonOf(window, words);
  return button && button->isEnabled();
}

void importFolder(Robot& robot, MainWindow& window, const Patient& patient) {
  robot.step(
      "start", Page::changes, [] {}, [&] { return window.prepareStep() == PrepareStep::worklist; });
  robot.step(
      "series", Page::changes, [&] { robot.press("2 Series"); },
      [&] { return window.prepareStep() == PrepareStep::series; });
  robot.step(
      "read", Page::stays,
      [&] {
        robot.answerFolder(pathOf(patient.series()));
        robot.press("Read DICOM folder\u2026");
      },
      [&] { return isEnabled(window, "Prepare the chosen series") && !window.tasks().isRunning(); });
  robot.step(
      "queue", Page::changes, [&] { robot.press("Prepare the chosen series"); },
      [&] { return window.prepareStep() == PrepareStep::worklist; });
  robot.step(
      "prepared", Page::changes, [] {},
      [&] { return window.queue().jobs().empty() && window.worklist().rows().size() == 1; }, kPreparing_ms);
}

void openFromWorklist(Robot& robot, MainWindow& window) {
  robot.step(
      "open", Page::changes,
      [&] {
        auto* table = part<QTableView>(window, "worklist");
        robot.clickAt(*table->viewport(), table->visualRect(table->model()->index(0, 0)).center());
        robot.press("Open");
      },
      [&] { return window.prepareStep() == PrepareStep::check && !window.tasks().isRunning(); });
}

/// Follows the first finding that leads to a place; scans without one have none to follow.
void lookAtFindings(Robot& robot, MainWindow& window) {
  auto* findings = part<QListWidget>(window, "findings");
  ASSERT_NE(findings, nullptr);
  for (int i = 0; i < findings->count(); ++i) {
    if (!findings->item(i)->font().underline()) continue;
    findings->scrollToItem(findings->item(i));
    const auto* slice = part<ui::SliceView>(window);
    const QStringList before = slice->caption();
    robot.step(
        "finding", Page::stays,
        [&] { robot.clickAt(*findings->viewport(), findings->visualItemRect(findings->item(i)).center()); },
        [&] { return slice->caption() != before; });
    return;
  }
}

void correctAndUndo(Robot& robot, MainWindow& window) {
  robot.step(
      "brush", Page::stays, [&] { robot.press("Brush"); },
      [&] { return buttonOf(window, "Brush")->isChecked(); });
  auto* slice = part<ui::SliceView>(window);
  robot.step(
      "stroke", Page::stays,
      [&] { robot.drag(*slice, slice->rect().center(), slice->rect().center() + QPoint(30, 12)); },
      [&] { return isEnabled(window, "Undo"); });
  robot.step(
      "undone", Page::stays, [&] { robot.key(Qt::Key_Z, Qt::ControlModifier); },
      [&] { return !isEnabled(window, "Undo") && !isEnabled(window, "Save"); });
}

void signOff(Robot& robot, MainWindow& window) {
  robot.step(
      "looks right", Page::changes, [&] { robot.press("Looks right: sign off"); },
      [&] { return window.prepareStep() == PrepareStep::sign_off; });
  if (robot.hasFailed()) return;
  auto* items = part<QListWidget>(window, "what must be seen");
  robot.step(
      "seen", Page::stays,
      [&] {
        for (int i = 0; i < items->count(); ++i) {
          items->scrollToItem(items->item(i));
          robot.clickAt(*items->viewport(), items->visualItemRect(items->item(i)).center());
          robot.key(Qt::Key_Space);
        }
      },
      [&] {
        for (int i = 0; i < items->count(); ++i)
          if (items->item(i)->checkState() != Qt::Checked) return false;
        return true;
      });
  robot.step(
      "name", Page::stays,
      [&] {
        QList<QLineEdit*> fields;
        for (auto* field : window.findChildren<QLineEdit*>())
          if (field->isVisible()) fields << field;
        robot.click(*fields.front());
        robot.key(Qt::Key_A, Qt::ControlModifier);
        robot.type("XY");
        robot.click(*fields.back());
        robot.type("the brain is whole");
      },
      [&] { return isEnabled(window, "Sign off"); });
  robot.step(
      "signed", Page::stays, [&] { robot.press("Sign off"); },
      [&] { return buttonOf(window, "4 Sign off \u2713") != nullptr; });
  const auto* reject = buttonOf(window, "Reject: ask for a new scan");
  EXPECT_FALSE(reject && reject->hasFocus()) << "the next Space would reject the scan";
}

}  // namespace

void prepareAScan(Patient& patient, const Look& look) {
  QSettings().clear();
  MainWindow window(patient.services());
  window.show();
  window.setCasesFolder(pathOf(patient.folder() / (std::string("imported ") + look.name)));
  Robot robot(window, "radiographer", look);
  importFolder(robot, window, patient);
  openFromWorklist(robot, window);
  if (robot.hasFailed()) return;
  lookAtFindings(robot, window);
  correctAndUndo(robot, window);
  signOff(robot, window);
}

void planTargets(Patient& patient, const Look& look) {
  QSettings().clear();
  const auto cases = patient.casesFolder(std::string("planned ") + look.name);
  const auto targets = [&] { return casefile::CaseStore::open(cases / "patient").targets().targets; };
  MainWindow window(patient.services());
  window.show();
  window.setCasesFolder(pathOf(cases));
  Robot robot(window, "neurologist", look);
  robot.step(
      "start", Page::changes, [] {}, [&] { return window.worklist().rows().size() == 1; });
  openFromWorklist(robot, window);
  robot.step(
      "plan", Page::changes, [&] { robot.press("Plan"); },
      [&] { return part<ui::TargetList>(window) != nullptr; });
  if (robot.hasFailed()) return;
  auto* scene = part<ui::SceneView>(window);
  robot.step(
      "click", Page::stays, [&] { robot.clickAt(*scene, scene->rect().center() + QPoint(20, 20)); },
      [&] { return targets().size() == 2; });
  if (robot.hasFailed()) return;
  const auto at_mm = [&] { return targets().back().cortex_point.mm; };
  const auto handle = [&] { return part<QLineEdit>(window, "handle, degrees")->text(); };
  const Eigen::Vector3d clicked_mm = at_mm();
  robot.step(
      "nudged", Page::stays, [&] { robot.key(Qt::Key_Left); },
      [&] { return (at_mm() - clicked_mm).norm() > 0.3; });
  const Eigen::Vector3d nudged_mm = at_mm();
  const QString first = handle();
  robot.step(
      "turned", Page::stays, [&] { robot.press("\u21bb 5\u00b0"); }, [&] { return handle() != first; });
  robot.step(
      "typed", Page::stays,
      [&] {
        robot.click(*part<QLineEdit>(window, "handle, degrees"));
        robot.key(Qt::Key_A, Qt::ControlModifier);
        robot.type("30");
        robot.key(Qt::Key_Return);
      },
      [&] { return handle() == "+30"; });
  robot.step(
      "undo", Page::stays, [&] { robot.press("Undo"); }, [&] { return handle() != "+30"; });
  robot.step(
      "undo the turn", Page::stays, [&] { robot.press("Undo"); }, [&] { return handle() == first; });
  robot.step(
      "undo the nudge", Page::stays, [&] { robot.press("Undo"); },
      [&] { return (at_mm() - clicked_mm).norm() < 0.01 && (at_mm() - nudged_mm).norm() > 0.3; });
  robot.step(
      "preset", Page::stays,
      [&] {
        robot.chooseInMenu("hand area of the right M1");
        robot.press("Preset");
      },
      [&] { return targets().size() == 3; });
}

}  // namespace facenav::walk
