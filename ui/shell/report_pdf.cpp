#include "shell/report_pdf.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QPainter>
#include <QPdfWriter>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QUrl>

#include "facenav/core/whole_file.h"
#include "review/chart_painter.h"
#include "shell/image_view.h"

namespace facenav::ui {
namespace {

constexpr int kSection = 2;  // level of a section's heading
constexpr int kResolution_dpi = 300, kMargin_mm = 14, kFoot_mm = 8;
constexpr double kChartSharpness = 3.0;                      // pixels of a chart per unit, for paper
constexpr int kChartWidth_px = 222, kPictureWidth_px = 280;  // at 96 dpi; the page is 688 wide

const char* const kStyle =
    "body{font-family:sans-serif;font-size:11px;color:#1d2430}"
    "h1{font-size:19px;margin-bottom:2px}h2{font-size:14px;color:#005a8c;margin-top:8px;margin-bottom:2px}"
    "p{margin-top:2px;margin-bottom:2px}"
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
  for (const char* table : {"<table class=\"facts\">", "<table class=\"pictures\">", "<table>"})
    body.replace(table, "<table cellspacing=\"0\" cellpadding=\"1\" width=\"100%\">");
  return body;
}

/// Moves a heading to the next page, where what follows it would stand there without it.
void keepHeadings(QTextDocument& document) {
  const auto pageOf = [&](double y_px) { return int(y_px / document.pageSize().height()); };
  for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
    const QTextBlock next = block.next();
    if (block.blockFormat().headingLevel() != kSection || !next.isValid()) continue;
    document.pageCount();  // lays out all of it; rectangles are known only then
    const auto* layout = document.documentLayout();
    const QRectF own = layout->blockBoundingRect(block), after = layout->blockBoundingRect(next);
    if (pageOf(own.top()) == pageOf(after.bottom() - 1)) continue;
    QTextBlockFormat format = block.blockFormat();
    format.setPageBreakPolicy(QTextFormat::PageBreak_AlwaysBefore);
    QTextCursor(block).setBlockFormat(format);
  }
}

void printPages(QTextDocument& document, const report::SessionReport& report, QPdfWriter& writer) {
  const QString subtitle = QString::fromStdString(report.subtitle);
  const QString page_words = QString::fromStdString(report.page_words);
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
    painter.drawText(foot, Qt::AlignRight, page_words.arg(n + 1).arg(document.pageCount()));
  }
}

}  // namespace

void fillReport(QTextDocument& document, const report::SessionReport& report) {
  document.setDefaultStyleSheet(kStyle);
  for (std::size_t i = 0; i < report.figures.size(); ++i)
    document.addResource(QTextDocument::ImageResource, QUrl(QString("figure:%1").arg(i)),
                         drawn(report.figures[i]));
  document.setHtml("<html><body><h1>" + QString::fromStdString(report.title).toHtmlEscaped() +
                   "</h1><p class=\"subtitle\">" + QString::fromStdString(report.subtitle).toHtmlEscaped() +
                   "</p>" + bodyOf(report) + "</body></html>");
}

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
    fillReport(document, report);
    document.setDocumentMargin(0);
    document.setPageSize({(210 - 2 * kMargin_mm) * per_mm, (297 - 2 * kMargin_mm - kFoot_mm) * per_mm});
    keepHeadings(document);
    printPages(document, report, writer);
  }
  writeWholeFile(path, bytes.data().toStdString(), FileAccess::owner_only);
}

}  // namespace facenav::ui
