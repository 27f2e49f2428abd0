#include "src/figures/subject.hpp"

#include <QFontMetricsF>

#include "src/figures/plot_style.hpp"

namespace triax::src {
namespace {

std::string described(const Subject& subject) {
  return subject.material + (subject.state.empty() ? std::string() : ", " + subject.state) +
         (subject.plane == sim::ProbePlane::plane_strain ? ", plane strain" : "");
}

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

std::string stress_x_name(sim::ProbePlane plane) {
  return plane == sim::ProbePlane::axisymmetric ? "√2 dσ₃" : "dσ₃";
}
std::string stress_y_name() { return "dσ₁"; }
std::string strain_x_name(sim::ProbePlane plane) {
  return plane == sim::ProbePlane::axisymmetric ? "√2 dε₃" : "dε₃";
}
std::string strain_y_name() { return "dε₁"; }

double isotropic_unloading(sim::ProbePlane plane) {
  return plane == sim::ProbePlane::axisymmetric ? sim::kIsotropicUnloading
                                                : 1.25 * std::numbers::pi;
}

std::string simulated_with(const Subject& subject) {
  return "Simulated with " + described(subject) + ".";
}

std::string origin_of(const Subject& subject) { return "simulated: " + described(subject); }

void origin_below(QCustomPlot& plot, const Subject& subject) {
  constexpr int kLeft = 56, kRight = 10;  // as the entries of the legend
  QFont font = label_font();
  font.setPixelSize(11);
  const auto text =
      in_lines(QString::fromStdString(origin_of(subject)), font, plot.width() - kLeft - kRight);
  auto* line = new QCPTextElement(&plot, text, font);
  line->setTextColor(QColor(0x66, 0x66, 0x66));
  line->setTextFlags(Qt::AlignLeft | Qt::AlignVCenter);
  line->setMargins({kLeft, 0, kRight, 4});
  const int row = plot.plotLayout()->rowCount();
  plot.plotLayout()->addElement(row, 0, line);
  plot.plotLayout()->setRowStretchFactor(row, 0.001);
}

}  // namespace triax::src
