// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How all figures look: dark text on white, thin grid, colours that colour-blind readers tell
// apart.
#include <qcustomplot.h>

#include <string>

namespace triax::src {

// Palette of Okabe and Ito (2008).
inline const QColor kBlue{0x00, 0x72, 0xB2};
inline const QColor kVermilion{0xD5, 0x5E, 0x00};
inline const QColor kGreen{0x00, 0x9E, 0x73};
inline const QColor kOrange{0xE6, 0x9F, 0x00};
inline const QColor kPurple{0xAA, 0x4C, 0x80};
inline const QColor kInk{0x22, 0x22, 0x22};
inline const QColor kGrey{0x77, 0x77, 0x77};
inline const QColor kGridLine{0xE4, 0xE4, 0xE4};

/// Fonts have sizes in pixels, so that a page, a picture and a screen look alike.
QFont label_font();
/// The same letters, of so many points.
QFont text_font(double points);
QFont title_font();
QPen line(const QColor& colour, double width = 1.6, Qt::PenStyle style = Qt::SolidLine);

void style_axes(QCPAxisRect& rect, const std::string& x_title, const std::string& y_title);
void style_legend(QCPLegend& legend);

/// Puts the legend in its own row below the axes, where it can cover no data, in so many columns or
/// as many as the widest of its entries so far leaves room for.
void legend_below(QCustomPlot& plot, int columns);

/// Range from the data with a margin; never empty. Values that are not finite are ignored.
class RangeOf {
 public:
  void add(double value);
  bool empty() const { return empty_; }
  double width() const { return high_ - low_; }
  /// Widens the range about its middle where it is narrower than this.
  void widen_to(double width);
  /// `margin` of the width is added at both ends; an end that is 0 stays 0 if `keep_zero`.
  QCPRange with_margin(double margin, bool keep_zero) const;

 private:
  double low_ = 0;
  double high_ = 0;
  bool empty_ = true;
};

}  // namespace triax::src
