#include "src/figures/origin_note.hpp"

#include <fmt/format.h>

#include <QFontMetricsF>
#include <algorithm>

#include "src/figures/plot_style.hpp"

namespace triax::src {
namespace {

/// Of more materials than these their number is told.
constexpr std::size_t kMostMaterials = 3;

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

void add_once(std::vector<std::string>& names, const std::string& name) {
  if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end())
    names.push_back(name);
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

std::string origin_of(const std::vector<const ReportedTest*>& tests) {
  std::vector<std::string> names, materials;
  for (const auto* test : tests) {
    const auto& header = test->stored.header;
    if (header.origin != lab::Origin::simulated) continue;
    names.push_back(header.name);
    add_once(materials, header.specimen.material);
  }
  if (names.empty()) return {};
  const std::string which = names.size() == tests.size()
                                ? "simulated"
                                : fmt::format("simulated: {}", fmt::join(names, ", "));
  const std::string how = materials.size() > kMostMaterials
                              ? fmt::format("{} sets of parameters", materials.size())
                              : fmt::format("{}", fmt::join(materials, ", "));
  return how.empty() ? which : which + (names.size() == tests.size() ? ": " : ", with ") + how;
}

}  // namespace triax::src
