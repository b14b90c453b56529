#pragma once
// ChartView: a chart that is drawn anew for the widget's size.

#include <QWidget>
#include <functional>

#include "facenav/report/chart.h"

namespace facenav::ui {

class ChartView : public QWidget {
  Q_OBJECT

 public:
  /// Makes the chart for a size in chart units; empty: nothing is drawn.
  using Make = std::function<report::Chart(int width, int height)>;

  explicit ChartView(QWidget* parent = nullptr);
  void set(Make make);
  const report::Chart& chart() const { return chart_; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void makeChart();
  Make make_;
  report::Chart chart_;
};

}  // namespace facenav::ui
