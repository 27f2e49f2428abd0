// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/note.hpp"

#include <QFontMetricsF>

#include "src/plot/plot_style.hpp"

namespace triax::src {
namespace {

/// Broken behind commas where a line would be wider.
QString in_lines(const QString& text, const QFont& font, double width) {
  const QFontMetricsF metrics(font);
  QString lines, here;
  for (const auto& part : text.split(", ")) {
    const QString longer = here.isEmpty() ? part : here + ", " + part;
    const bool fits = metrics.horizontalAdvance(longer + ",") <= width;
    if (!here.isEmpty() && !fits) lines += here + ",\n";
    here = fits || here.isEmpty() ? longer : part;
  }
  return lines + here;
}

}  // namespace

void note_below(QCustomPlot& plot, const std::string& text) {
  constexpr int kLeft = 56, kRight = 10;  // as the entries of the legend
  if (text.empty()) return;
  QFont font = label_font();
  font.setPixelSize(11);
  const auto lines = in_lines(QString::fromStdString(text), font, plot.width() - kLeft - kRight);
  auto* note = new QCPTextElement(&plot, lines, font);
  note->setTextColor(QColor(0x66, 0x66, 0x66));
  note->setTextFlags(Qt::AlignLeft | Qt::AlignVCenter);
  note->setMargins({kLeft, 0, kRight, 4});
  const int row = plot.plotLayout()->rowCount();
  plot.plotLayout()->addElement(row, 0, note);
  plot.plotLayout()->setRowStretchFactor(row, 0.001);
}

}  // namespace triax::src
