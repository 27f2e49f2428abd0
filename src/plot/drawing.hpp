// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Drawing without a screen: a plot of fixed size that can be written as SVG, PNG or into a PDF
// page.
#include <memory>
#include <string>

class QCustomPlot;
class QPainter;
class QRectF;

namespace triax::src {

/// Ends a plot where QCustomPlot is known: who only holds a drawing need not read Qt's widgets.
struct EndPlot {
  void operator()(QCustomPlot* plot) const;
};
using OwnPlot = std::unique_ptr<QCustomPlot, EndPlot>;

/// Of 1/72 inch, in a pixel of 1/96 inch.
inline constexpr double kPointsPerPixel = 0.75;

/// A finished plot. Its size is in CSS pixels (1/96 inch); text is laid out for that size.
struct Drawing {
  OwnPlot plot;
  std::string caption;  ///< one or two sentences that say what is seen
};

/// Makes the application object that fonts and plots need, on Qt's platform without a screen; no
/// display, no window system. Call before any drawing; further calls do nothing. Numbers
/// have a decimal point from then on, whatever the locale of the environment is.
void need_drawing();

/// An empty plot of that size in the house style. Calls need_drawing().
OwnPlot make_plot(int width_px, int height_px);

/// Gives a plot another size.
void resize_plot(QCustomPlot& plot, int width_px, int height_px);

/// A standalone SVG element that looks the same with any font: each text carries its length.
std::string to_svg(const QCustomPlot& plot);

/// PNG bytes; `scale` device pixels per CSS pixel. The description stands in the file's metadata.
std::string to_png(const QCustomPlot& plot, double scale, const std::string& description = {});

/// Draws into the rectangle of a page with its aspect kept, at the top, centred. Gives the height
/// used, in the painter's units.
double draw_on_page(const QCustomPlot& plot, QPainter& page, const QRectF& rectangle);

}  // namespace triax::src
