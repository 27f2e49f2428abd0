// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/pages.hpp"

#include <QAbstractTextDocumentLayout>
#include <QPageSize>
#include <QTextDocument>
#include <QTextObjectInterface>
#include <algorithm>

#include "lab/base/bad_input.hpp"
#include "src/plot/drawing.hpp"
#include "src/plot/plot_style.hpp"

namespace triax::src {
namespace {

// All lengths are in points of 1/72 inch: an A4 page is 595 by 842.
constexpr int kPointsPerInch = 72;
constexpr double kMargin = 48;
constexpr double kHeadHeight = 22;  // of the running head and of the line with the page number
// Of a page's height: a broad figure leaves room for the text above it, of tall ones a page holds
// two.
constexpr double kBroadFigure = 0.4, kTallFigure = 0.44;
constexpr double kAboveCaption = 4, kBelowCaption = 6;
const QSizeF kPage{595, 842};

QRectF text_area() {
  return {kMargin, kMargin + kHeadHeight, kPage.width() - 2 * kMargin,
          kPage.height() - 2 * (kMargin + kHeadHeight)};
}

constexpr const char* kStyle =
    "body { color: #222222; }"
    "h1 { font-size: 16pt; } h2 { font-size: 13pt; } h3 { font-size: 10pt; }"
    "table { border-collapse: collapse; }"
    "td, th { border-bottom: 0.5px solid #cccccc; }"
    ".banner { background-color: #fbe3d3; color: #8a3c00; font-weight: 700; }"
    ".notes { color: #444444; }";

// Qt draws images of rich text as pixels; this draws ours as the lines they are. The caption is
// part of what is drawn, or it could begin the next page.
class FigureObject : public QObject, public QTextObjectInterface {
  Q_OBJECT
  Q_INTERFACES(QTextObjectInterface)
 public:
  FigureObject(const std::vector<Drawing>& figures, QPaintDevice& device)
      : figures_(figures), device_(device) {}

  QSizeF intrinsicSize(QTextDocument* /*document*/, int /*position*/,
                       const QTextFormat& format) override {
    const auto size = figure_size(format);
    return {text_area().width(),
            size.height() + kAboveCaption + caption_height(format) + kBelowCaption};
  }
  void drawObject(QPainter* painter, const QRectF& rect, QTextDocument* /*document*/,
                  int /*position*/, const QTextFormat& format) override {
    // Qt offers a figure to each page that its line might touch, and a plot clips to its own axes,
    // which would undo the clipping to the page.
    if (!page_.contains(rect.center())) return;
    const QRectF frame(rect.topLeft(), figure_size(format));
    draw_on_page(plot(format), *painter, frame);
    painter->setFont(caption_font());
    painter->setPen(kGrey);
    painter->drawText(
        QRectF(rect.left(), frame.bottom() + kAboveCaption, rect.width(), caption_height(format)),
        Qt::TextWordWrap, caption(format));
  }
  /// The part of the document that is drawn next.
  void set_page(const QRectF& page) { page_ = page; }

 private:
  static QFont caption_font() { return text_font(8); }
  const Drawing& figure(const QTextFormat& format) const {
    return figures_.at(format.toImageFormat().name().toUInt());
  }
  const QCustomPlot& plot(const QTextFormat& format) const { return *figure(format).plot; }
  QString caption(const QTextFormat& format) const {
    return QString::fromStdString(figure(format).caption);
  }
  QSizeF figure_size(const QTextFormat& format) const {
    const auto size = QSizeF(plot(format).size()) * kPointsPerPixel;
    const auto room = text_area().size();
    const double part = size.width() > size.height() ? kBroadFigure : kTallFigure;
    return size *
           std::min({1.0, room.width() / size.width(), part * room.height() / size.height()});
  }
  double caption_height(const QTextFormat& format) const {
    const QFontMetricsF metrics(caption_font(), &device_);
    return metrics
        .boundingRect(QRectF(0, 0, text_area().width(), text_area().height()), Qt::TextWordWrap,
                      caption(format))
        .height();
  }
  const std::vector<Drawing>& figures_;
  QPaintDevice& device_;
  QRectF page_;
};

}  // namespace

Pages::Pages(QIODevice& device, const std::string& title) : writer_(&device) {
  writer_.setPageSize(QPageSize(QPageSize::A4));
  writer_.setPageMargins(QMarginsF(0, 0, 0, 0));
  writer_.setResolution(kPointsPerInch);
  writer_.setTitle(QString::fromStdString(title));
  writer_.setCreator("triax");
  if (!painter_.begin(&writer_)) throw lab::WorkFailed("a PDF document cannot be started");
}

void Pages::turn_page() {
  if (count_ > 0 && !writer_.newPage()) throw lab::WorkFailed("a PDF page cannot be started");
  ++count_;
}

void Pages::add_page(const std::function<void(QPainter&, QPaintDevice&)>& draw) {
  turn_page();
  painter_.save();
  draw(painter_, writer_);
  painter_.restore();
}

void Pages::begin_page(const std::string& running_head) {
  turn_page();
  const auto area = text_area();
  painter_.setFont(text_font(8));
  painter_.setPen(kGrey);
  const QRectF head(area.left(), kMargin - 8, area.width(), kHeadHeight - 6);
  const QFontMetricsF metrics(painter_.font(), &writer_);
  painter_.drawText(
      head, Qt::AlignLeft | Qt::AlignVCenter,
      metrics.elidedText(QString::fromStdString(running_head), Qt::ElideRight, area.width()));
  painter_.drawLine(head.bottomLeft(), head.bottomRight());
  painter_.drawText(QRectF(area.left(), area.bottom() + 8, area.width(), kHeadHeight),
                    Qt::AlignHCenter | Qt::AlignTop, QString("Page %1").arg(count_));
}

void Pages::add(const PageSection& section) {
  const auto area = text_area();
  FigureObject figures(section.figures, writer_);
  QTextDocument document;
  document.documentLayout()->setPaintDevice(&writer_);
  document.documentLayout()->registerHandler(QTextFormat::ImageObject, &figures);
  document.setDocumentMargin(0);
  document.setDefaultFont(text_font(8.5));
  document.setDefaultStyleSheet(kStyle);
  document.setHtml(QString::fromStdString("<body>" + section.markup + "</body>"));
  document.setPageSize(area.size());
  const int pages = document.pageCount();
  for (int page = 0; page < pages; ++page) {
    begin_page(section.running_head);
    const QRectF view(0, page * area.height(), area.width(), area.height());
    figures.set_page(view);
    painter_.save();
    painter_.translate(area.topLeft() - view.topLeft());
    painter_.setClipRect(view);
    QAbstractTextDocumentLayout::PaintContext context;
    context.clip = view;
    context.palette.setColor(QPalette::Text, kInk);
    document.documentLayout()->draw(&painter_, context);
    painter_.restore();
  }
}

void Pages::finish() {
  if (!painter_.end()) throw lab::WorkFailed("a PDF document cannot be completed");
}

}  // namespace triax::src

#include "pages.moc"
