#include "shell/report_pdf.h"

#include <QBuffer>
#include <QObject>
#include <QPainter>
#include <QPdfWriter>
#include <QTextDocument>
#include <QUrl>

#include "facenav/core/whole_file.h"
#include "review/chart_painter.h"
#include "shell/image_view.h"

namespace facenav::ui {
namespace {

constexpr int kResolution_dpi = 300, kMargin_mm = 14, kFoot_mm = 8;
constexpr double kChartSharpness = 3.0;                      // pixels of a chart per unit, for paper
constexpr int kChartWidth_px = 260, kPictureWidth_px = 460;  // at 96 dpi; the page is 688 wide

const char* const kStyle =
    "body{font-family:sans-serif;font-size:12px;color:#1d2430}"
    "h1{font-size:21px}h2{font-size:15px;color:#005a8c}"
    "p.subtitle{color:#444455}th{background-color:#eef3f8;text-align:left}";

QImage drawn(const report::SessionReport::Figure& figure) {
  if (!figure.chart) return toQImage(figure.picture);
  const auto& chart = *figure.chart;
  QImage image(QSize(chart.width, chart.height) * kChartSharpness, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  painter.scale(kChartSharpness, kChartSharpness);
  paintChart(painter, chart, ChartPaper::white);
  return image;
}

QString bodyOf(const report::SessionReport& report) {
  QString body = QString::fromStdString(report.body);
  for (std::size_t i = 0; i < report.figures.size(); ++i) {
    const QString place = QString("<img src=\"figure:%1\">").arg(i);
    const int width_px = report.figures[i].chart ? kChartWidth_px : kPictureWidth_px;
    body.replace(place, QString("<img src=\"figure:%1\" width=\"%2\">").arg(i).arg(width_px));
  }
  body.replace("<table class=\"facts\">", "<table cellspacing=\"0\" cellpadding=\"2\" width=\"100%\">");
  body.replace("<table>", "<table cellspacing=\"0\" cellpadding=\"2\" width=\"100%\">");
  return body;
}

void fill(QTextDocument& document, const report::SessionReport& report, const QSizeF& page) {
  document.setDefaultStyleSheet(kStyle);
  for (std::size_t i = 0; i < report.figures.size(); ++i)
    document.addResource(QTextDocument::ImageResource, QUrl(QString("figure:%1").arg(i)),
                         drawn(report.figures[i]));
  document.setDocumentMargin(0);
  document.setHtml("<html><body><h1>" + QString::fromStdString(report.title).toHtmlEscaped() +
                   "</h1><p class=\"subtitle\">" + QString::fromStdString(report.subtitle).toHtmlEscaped() +
                   "</p>" + bodyOf(report) + "</body></html>");
  document.setPageSize(page);
}

void printPages(QTextDocument& document, const QString& subtitle, QPdfWriter& writer) {
  QPainter painter(&writer);
  const double to_dots = kResolution_dpi / 96.0;  // the document is laid out at 96 dpi
  painter.scale(to_dots, to_dots);
  const QSizeF page = document.pageSize();
  for (int n = 0; n < document.pageCount(); ++n) {
    if (n > 0) writer.newPage();
    painter.save();
    painter.translate(0, -n * page.height());
    document.drawContents(&painter, QRectF(0, n * page.height(), page.width(), page.height()));
    painter.restore();
    QFont font("sans-serif");
    font.setPixelSize(10);
    painter.setFont(font);
    painter.setPen(QColor(68, 68, 85));
    const QRectF foot(0, page.height() + 6, page.width(), 16);
    painter.drawText(foot, Qt::AlignLeft, subtitle);
    painter.drawText(foot, Qt::AlignRight, QObject::tr("page %1 of %2").arg(n + 1).arg(document.pageCount()));
  }
}

}  // namespace

void writeReportPdf(const report::SessionReport& report, const std::filesystem::path& path) {
  QBuffer bytes;
  bytes.open(QIODevice::WriteOnly);
  {
    QPdfWriter writer(&bytes);
    writer.setTitle(QString::fromStdString(report.title + ", " + report.subtitle));
    writer.setCreator("FaceNav");
    writer.setResolution(kResolution_dpi);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(QMarginsF(kMargin_mm, kMargin_mm, kMargin_mm, kMargin_mm), QPageLayout::Millimeter);
    QTextDocument document;
    const double per_mm = 96.0 / 25.4;
    fill(document, report, {(210 - 2 * kMargin_mm) * per_mm, (297 - 2 * kMargin_mm - kFoot_mm) * per_mm});
    printPages(document, QString::fromStdString(report.subtitle), writer);
  }
  writeWholeFile(path, bytes.data().toStdString(), FileAccess::owner_only);
}

}  // namespace facenav::ui
