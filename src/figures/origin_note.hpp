#pragma once
// Where what a figure shows comes from, written into the figure itself: a picture taken out of its
// report keeps its origin.
#include <qcustomplot.h>

#include <string>
#include <vector>

#include "src/report/reported_test.hpp"

namespace triax::src {

/// Height that one line of a note takes, px.
inline constexpr int kNoteHeight = 18;

/// Puts a text as the last row of the layout, small and grey; in several lines, broken behind
/// commas, where the plot is too narrow. After legend_below(). Does nothing with an empty text.
void note_below(QCustomPlot& plot, const std::string& text);

/// "simulated: inl2/S28-general", with the names of the simulated tests where others are recorded;
/// empty where none is simulated.
std::string origin_of(const std::vector<const ReportedTest*>& tests);

}  // namespace triax::src
