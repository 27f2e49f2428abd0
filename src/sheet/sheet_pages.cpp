// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/sheet/sheet_pages.hpp"

#include <fmt/format.h>
#include <qcustomplot.h>

#include <QAbstractTextDocumentLayout>
#include <QTextDocument>
#include <algorithm>

#include "src/plot/plot_style.hpp"

namespace triax::src {
namespace {

// In points of 1/72 inch: an A4 page is 595 by 842.
constexpr double kSheetMargin = 26, kGap = 4, kPadding = 3, kTitleHeight = 24, kFootHeight = 10;
constexpr double kSheetWidth = 595 - 2 * kSheetMargin, kSheetHeight = 842 - 2 * kSheetMargin;
constexpr double kLargest = 7.2, kSmallest = 4.6, kStep = 0.2;  // of letters
constexpr double kLeastFigure = 108, kMostFigure = 230;

constexpr const char* kSheetStyle =
    "body { color: #222222; } table { border-collapse: collapse; }"
    ".title { font-weight: 700; color: #222222; }"
    ".label { color: #555555; } .value { color: #111111; }"
    ".blank { border-bottom: 0.5px solid #bbbbbb; }"
    ".rows th { font-weight: 400; color: #555555; border-bottom: 0.5px solid #999999; }"
    ".line { color: #222222; }";

bool is_figure(const SheetRow& row) { return !row.parts.empty() && row.parts.front().plot; }

std::vector<double> widths_of(const SheetRow& row) {
  double all = 0;
  for (const auto& part : row.parts) all += part.share;
  const double room = kSheetWidth - kGap * static_cast<double>(row.parts.size() - 1);
  std::vector<double> widths;
  widths.reserve(row.parts.size());
  for (const auto& part : row.parts) widths.push_back(room * part.share / all);
  return widths;
}

class SheetLayout {
 public:
  SheetLayout(const Sheet& sheet, QPaintDevice& device) : sheet_(sheet), device_(device) {
    double size = kLargest;
    while (true) {
      lay_out(size);
      if (least_height() <= room() || size <= kSmallest) break;
      size -= kStep;
    }
  }

  void draw(QPainter& page) {
    draw_title(page);
    double y = kSheetMargin + kTitleHeight + kGap;
    double weights = 0, fixed = 0;
    for (std::size_t i = 0; i < sheet_.rows.size(); ++i)
      is_figure(sheet_.rows[i]) ? weights += sheet_.rows[i].weight : fixed += heights_[i];
    const double left = room() - fixed - kGap * static_cast<double>(sheet_.rows.size() - 1);
    for (std::size_t i = 0; i < sheet_.rows.size(); ++i) {
      const auto& row = sheet_.rows[i];
      const double height =
          is_figure(row) ? std::clamp(left * row.weight / weights, 40.0, kMostFigure * row.weight)
                         : heights_[i];
      draw_row(page, i, y, height);
      y += height + kGap;
    }
    draw_foot(page);
  }

 private:
  static double room() { return kSheetHeight - kTitleHeight - kGap - kFootHeight; }

  void lay_out(double size) {
    documents_.clear();
    heights_.clear();
    for (const auto& row : sheet_.rows) {
      auto& of_row = documents_.emplace_back();
      double height = 0;
      const auto widths = widths_of(row);
      for (std::size_t i = 0; i < row.parts.size(); ++i) {
        auto& document = of_row.emplace_back(std::make_unique<QTextDocument>());
        if (row.parts[i].plot) continue;
        document->documentLayout()->setPaintDevice(&device_);
        document->setDocumentMargin(0);
        document->setDefaultFont(text_font(size));
        document->setDefaultStyleSheet(kSheetStyle);
        document->setHtml(
            QString::fromStdString("<body>" + box_markup(row.parts[i].box) + "</body>"));
        document->setTextWidth(widths[i] - 2 * kPadding);
        height = std::max(height, document->size().height() + 2 * kPadding);
      }
      heights_.push_back(height);
    }
  }

  double least_height() const {
    double height = kGap * static_cast<double>(sheet_.rows.size() - 1);
    for (std::size_t i = 0; i < sheet_.rows.size(); ++i)
      height += is_figure(sheet_.rows[i]) ? kLeastFigure * sheet_.rows[i].weight : heights_[i];
    return height;
  }

  void draw_title(QPainter& page) const {
    const QRectF bar(kSheetMargin, kSheetMargin, kSheetWidth, kTitleHeight);
    page.setPen(line(kInk, 0.8));
    page.drawRect(bar);
    auto font = text_font(10.5);
    font.setBold(true);
    page.setFont(font);
    const auto inside = bar.adjusted(6, 0, -6, 0);
    page.drawText(inside, Qt::AlignLeft | Qt::AlignVCenter, QString::fromStdString(sheet_.title));
    const QFontMetricsF metrics(font, &device_);
    const double taken = metrics.horizontalAdvance(QString::fromStdString(sheet_.title)) + 12;
    page.drawText(inside, Qt::AlignRight | Qt::AlignVCenter,
                  metrics.elidedText(QString::fromStdString(sheet_.subject), Qt::ElideRight,
                                     (inside.width() - taken) * (sheet_.mark.empty() ? 1 : 0.5)));
    if (sheet_.mark.empty()) return;
    page.setPen(kVermilion);
    page.drawText(inside.adjusted(taken, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                  QString::fromStdString(sheet_.mark));
  }

  void draw_foot(QPainter& page) const {
    page.setFont(text_font(5.6));
    page.setPen(kGrey);
    page.drawText(QRectF(kSheetMargin, kSheetMargin + kSheetHeight - kFootHeight + 2, kSheetWidth,
                         kFootHeight),
                  Qt::AlignLeft | Qt::AlignVCenter, QString::fromStdString(sheet_.footer));
  }

  void draw_row(QPainter& page, std::size_t number, double y, double height) {
    const auto& row = sheet_.rows[number];
    const auto widths = widths_of(row);
    double x = kSheetMargin;
    for (std::size_t i = 0; i < row.parts.size(); ++i) {
      const QRectF frame(x, y, widths[i], height);
      const auto& part = row.parts[i];
      if (part.box.marked) page.fillRect(frame, QColor(0xfb, 0xe3, 0xd3));
      page.setPen(line(part.box.marked ? kVermilion : kGrey, part.box.marked ? 0.9 : 0.5));
      page.setBrush(Qt::NoBrush);
      page.drawRect(frame);
      if (part.plot)
        draw_figure(page, part, frame);
      else
        draw_box(page, *documents_[number][i], frame);
      x += widths[i] + kGap;
    }
  }

  static void draw_figure(QPainter& page, const SheetPart& part, const QRectF& frame) {
    const double px_per_pt = kSheetFigureWidth / ((kSheetWidth - 2 * kGap) / 3);
    resize_plot(*part.plot, static_cast<int>(frame.width() * px_per_pt),
                static_cast<int>(frame.height() * px_per_pt));
    if (part.settle) part.settle(*part.plot);
    draw_on_page(*part.plot, page, frame);
  }

  static void draw_box(QPainter& page, QTextDocument& document, const QRectF& frame) {
    page.save();
    page.translate(frame.topLeft() + QPointF(kPadding, kPadding));
    const QRectF view(0, 0, frame.width() - 2 * kPadding, frame.height() - 2 * kPadding);
    page.setClipRect(view);
    QAbstractTextDocumentLayout::PaintContext context;
    context.clip = view;
    context.palette.setColor(QPalette::Text, kInk);
    document.documentLayout()->draw(&page, context);
    page.restore();
  }

  const Sheet& sheet_;
  QPaintDevice& device_;
  std::vector<std::vector<std::unique_ptr<QTextDocument>>> documents_;
  std::vector<double> heights_;
};

}  // namespace

void draw_sheet(const Sheet& sheet, QPainter& page, QPaintDevice& device) {
  SheetLayout(sheet, device).draw(page);
}

}  // namespace triax::src
