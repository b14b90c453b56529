#include "support/window_checks.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QTabBar>
#include <QTableWidget>

#include "shell/elided_label.h"
#include "shell/users_words.h"

namespace facenav::testing {
namespace {

const QString kLongText = "ninety-five of a hundred are within";

/// A window of 600 x 300 without a layout, so that a test decides where each part lies.
class WindowChecks : public ::testing::Test {
 protected:
  WindowChecks() { window_.resize(600, 300); }
  template <class Part>
  Part* add(Part* part, const QRect& at) {
    part->setParent(&window_);
    part->setGeometry(at);
    return part;
  }
  QStringList cut() {
    window_.show();
    QApplication::processEvents();
    return cutTexts(window_);
  }
  QStringList misplaced() {
    window_.show();
    QApplication::processEvents();
    return misplacedParts(window_);
  }
  QWidget window_;
};

TEST_F(WindowChecks, ALabelIsCutWhereItsTextIsWider) {
  auto* label = add(new QLabel(kLongText), {10, 10, 40, 30});
  ASSERT_EQ(cut().size(), 1);
  EXPECT_TRUE(cut().first().contains("QLabel 'ninety-five")) << cut().first().toStdString();
  label->resize(label->sizeHint());
  EXPECT_EQ(cut(), QStringList());
}

TEST_F(WindowChecks, AWrappedLabelIsCutWhereALineOrALongWordHasNoRoom) {
  auto* label = add(new QLabel(kLongText), {10, 10, 120, 20});
  label->setWordWrap(true);
  EXPECT_EQ(cut().size(), 1) << "one line of several";
  label->resize(120, label->heightForWidth(120));
  EXPECT_EQ(cut(), QStringList());
  label->resize(30, 280);
  EXPECT_EQ(cut().size(), 1) << "a word is wider";
}

TEST_F(WindowChecks, AShortenedTextIsCutUnlessAPersonWroteItAndTheToolTipHasIt) {
  auto* label = add(new ui::ElidedLabel, {10, 10, 60, 30});
  label->set(kLongText);
  EXPECT_EQ(cut().size(), 1);
  ui::markUsersWords(*label);
  EXPECT_EQ(cut(), QStringList());
  label->setToolTip({});
  EXPECT_EQ(cut().size(), 1);
}

TEST_F(WindowChecks, ButtonsTabsAndListsOfChoiceAreCutWhereTheirTextIsWider) {
  add(new QPushButton(kLongText), {10, 10, 60, 30});
  add(new QCheckBox(kLongText), {10, 50, 60, 30});
  add(new QComboBox, {10, 90, 60, 30})->addItem(kLongText);
  auto* tabs = add(new QTabBar, {10, 130, 60, 30});
  tabs->setUsesScrollButtons(false);
  tabs->addTab(kLongText);
  add(new QLineEdit, {10, 170, 60, 30})->setPlaceholderText(kLongText);
  EXPECT_EQ(cut().size(), 5) << cut().join('\n').toStdString();
  for (auto* part : window_.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
    part->resize(500, 36);
  EXPECT_EQ(cut(), QStringList());
}

TEST_F(WindowChecks, AHeadingOfATableIsCutWhereItsColumnIsNarrow) {
  auto* table = add(new QTableWidget(1, 1), {10, 10, 400, 200});
  table->setHorizontalHeaderLabels({kLongText});
  table->setColumnWidth(0, 60);
  EXPECT_EQ(cut().size(), 1) << cut().join('\n').toStdString();
  table->setColumnWidth(0, 380);
  EXPECT_EQ(cut(), QStringList());
}

TEST_F(WindowChecks, HiddenPartsHaveNoFaults) {
  add(new QPushButton(kLongText), {10, 10, 20, 30})->hide();
  EXPECT_EQ(cut(), QStringList());
  EXPECT_EQ(misplaced(), QStringList());
}

TEST_F(WindowChecks, APartOutsideTheWindowIsFound) {
  auto* button = add(new QPushButton("end"), {560, 10, 80, 30});
  ASSERT_EQ(misplaced().size(), 1);
  EXPECT_TRUE(misplaced().first().contains("lies outside")) << misplaced().first().toStdString();
  button->move(510, 10);
  EXPECT_EQ(misplaced(), QStringList());
}

TEST_F(WindowChecks, APartOverAnotherIsFound) {
  add(new QPushButton("one"), {10, 10, 80, 30});
  auto* other = add(new QPushButton("two"), {60, 20, 80, 30});
  ASSERT_EQ(misplaced().size(), 1);
  EXPECT_TRUE(misplaced().first().contains("covers a part of")) << misplaced().first().toStdString();
  other->move(90, 10);
  EXPECT_EQ(misplaced(), QStringList());
}

TEST_F(WindowChecks, WhatABarCanScrollToIsNoFault) {
  auto* area = add(new QScrollArea, {10, 10, 200, 100});
  auto* content = new QWidget;
  content->setFixedSize(150, 900);
  area->setWidget(content);
  EXPECT_EQ(misplaced(), QStringList());
  content->setFixedSize(400, 80);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  EXPECT_EQ(misplaced().size(), 1);
}

TEST_F(WindowChecks, AButtonThatMovesIsFoundAndOneThatTakesAnothersPlaceUnderTheMouse) {
  auto* first = add(new QPushButton("go on"), {10, 10, 80, 30});
  auto* second = add(new QPushButton("end"), {100, 10, 80, 30});
  window_.show();
  QApplication::processEvents();
  const ButtonPlaces before(window_);
  EXPECT_EQ(before.moved({50, 20}), QStringList());
  second->move(140, 10);
  ASSERT_EQ(before.moved({50, 20}).size(), 1);
  EXPECT_EQ(before.moved({50, 20}).first(), "QPushButton 'end' moved by 40,0 px");
  second->move(100, 10);
  first->hide();
  add(new QPushButton("delete"), {10, 10, 80, 30})->show();
  QApplication::processEvents();
  EXPECT_EQ(before.moved({50, 20}),
            QStringList("QPushButton 'delete' lies under the mouse in place of another button"));
  EXPECT_EQ(before.moved({300, 200}), QStringList());
}

}  // namespace
}  // namespace facenav::testing
