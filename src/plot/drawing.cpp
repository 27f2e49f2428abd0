// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/drawing.hpp"

#include <qcustomplot.h>

#include <QApplication>
#include <QBuffer>
#include <QFontMetricsF>
#include <QHash>
#include <QLocale>
#include <QRegularExpression>
#include <QSvgGenerator>
#include <algorithm>
#include <array>
#include <clocale>
#include <cmath>

#include "lab/base/bad_input.hpp"
#include "src/output/markup.hpp"
#include "src/plot/plot_style.hpp"

namespace triax::src {
namespace {

// toPainter is no const function of QCustomPlot: it lays the plot out for the size asked. Our plots
// are of fixed size, so nothing that a caller can see changes.
QCustomPlot& drawable(const QCustomPlot& plot) { return const_cast<QCustomPlot&>(plot); }

// Verdana has the widths of DejaVu Sans on systems that lack it; what other fonts would add or lack
// is evened out by the text's own length.
QString with_text_lengths(const QString& svg) {
  static const QRegularExpression kText(
      R"re(<text ([^>]*?)font-family="[^"]*" font-size="([0-9.]+)"([^>]*)>([^<]*)</text>)re");
  QString out;
  qsizetype done = 0;
  for (auto it = kText.globalMatch(svg); it.hasNext();) {
    const auto match = it.next();
    QFont font = label_font();
    font.setPixelSize(static_cast<int>(std::lround(match.captured(2).toDouble())));
    if (match.captured(3).contains("font-weight=\"700\"")) font.setBold(true);
    auto text = match.captured(4);
    text.replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", "\"").replace("&amp;", "&");
    const double length = QFontMetricsF(font).horizontalAdvance(text);
    out += svg.mid(done, match.capturedStart() - done);
    out += QString(
               "<text %1font-family=\"DejaVu Sans, Verdana, sans-serif\" font-size=\"%2\"%3 "
               "textLength=\"%4\" lengthAdjust=\"spacingAndGlyphs\">%5</text>")
               .arg(match.captured(1), match.captured(2), match.captured(3),
                    QString::number(length, 'f', 1), match.captured(4));
    done = match.capturedEnd();
  }
  return out + svg.mid(done);
}

}  // namespace

void need_drawing() {
  if (QCoreApplication::instance() != nullptr) return;
  qputenv("QT_QPA_PLATFORM", "offscreen");
  // The application object keeps references to these as long as the program runs, and Qt wants it
  // gone before static objects are: it is left to the end of the process.
  static int argument_count = 1;
  static std::string name = "triax";
  static std::array<char*, 2> arguments = {name.data(), nullptr};
  // Qt warns of a missing XDG_RUNTIME_DIR, which a program without windows does not need.
  const auto usual = qInstallMessageHandler(
      [](QtMsgType, const QMessageLogContext&, const QString&) { /* nobody to tell */ });
  QLocale::setDefault(QLocale::c());
  // QCustomPlot draws the axes of a frame in the order of a hash: the same bytes in every run.
  QHashSeed::setDeterministicGlobalSeed();
  static const auto* application = new QApplication(argument_count, arguments.data());
  static_cast<void>(application);
  // Numbers read the same everywhere: Qt takes over the locale of the environment, for itself and
  // for the C library.
  std::setlocale(LC_NUMERIC, "C");
  qInstallMessageHandler(usual);
}

void EndPlot::operator()(QCustomPlot* plot) const { delete plot; }

OwnPlot make_plot(int width_px, int height_px) {
  need_drawing();
  OwnPlot plot(new QCustomPlot);
  plot->setAttribute(Qt::WA_DontShowOnScreen);
  resize_plot(*plot, width_px, height_px);
  plot->setFont(label_font());
  plot->setBackground(Qt::NoBrush);
  return plot;
}

void resize_plot(QCustomPlot& plot, int width_px, int height_px) {
  plot.setGeometry(0, 0, width_px, height_px);
  plot.setViewport(QRect(0, 0, width_px, height_px));
}

std::string to_svg(const QCustomPlot& plot) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  QSvgGenerator svg;
  svg.setOutputDevice(&buffer);
  svg.setResolution(96);
  svg.setSize(plot.size());
  svg.setViewBox(QRect(QPoint(0, 0), plot.size()));
  QCPPainter painter;
  if (!painter.begin(&svg)) throw lab::WorkFailed("a figure cannot be drawn as SVG");
  painter.setMode(QCPPainter::pmVectorized);
  painter.setMode(QCPPainter::pmNoCaching);
  drawable(plot).toPainter(&painter, plot.width(), plot.height());
  painter.end();
  auto text = QString::fromUtf8(buffer.data());
  // Qt's own title would pop up over every figure.
  text.remove(QRegularExpression("<(title|desc)>[^<]*</(title|desc)>\n"));
  auto svg_text = with_text_lengths(text.mid(text.indexOf("<svg")));
  // On a dark page too the ink is dark.
  svg_text.insert(svg_text.indexOf('>') + 1,
                  "\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>");
  return in_xml(svg_text.toStdString());
}

std::string to_png(const QCustomPlot& plot, double scale, const std::string& description) {
  QImage image(plot.size() * scale, QImage::Format_RGB32);
  image.fill(Qt::white);
  QCPPainter painter;
  if (!painter.begin(&image)) throw lab::WorkFailed("a figure cannot be drawn as PNG");
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(scale, scale);
  painter.setMode(QCPPainter::pmNoCaching);
  drawable(plot).toPainter(&painter, plot.width(), plot.height());
  painter.end();
  if (!description.empty()) image.setText("Description", QString::fromStdString(description));
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return bytes.toStdString();
}

double draw_on_page(const QCustomPlot& plot, QPainter& page, const QRectF& rectangle) {
  const double scale =
      std::min(rectangle.width() / plot.width(), rectangle.height() / plot.height());
  QPicture picture;
  QCPPainter painter;
  if (!painter.begin(&picture)) throw lab::WorkFailed("a figure cannot be drawn on a page");
  painter.setMode(QCPPainter::pmVectorized);
  painter.setMode(QCPPainter::pmNoCaching);
  drawable(plot).toPainter(&painter, plot.width(), plot.height());
  painter.end();
  page.save();
  page.translate(rectangle.x() + (rectangle.width() - plot.width() * scale) / 2, rectangle.y());
  // A picture plays back at its size in inches; here one of its units is to be one of the page's.
  const double dpi = static_cast<double>(picture.logicalDpiX()) / page.device()->logicalDpiX();
  page.scale(scale * dpi, scale * dpi);
  picture.play(&page);
  page.restore();
  return plot.height() * scale;
}

}  // namespace triax::src
