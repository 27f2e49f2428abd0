// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A line below a plot, written into the figure itself: a picture taken out of its report keeps what
// it says of its origin.
#include <string>

class QCustomPlot;

namespace triax::src {

/// Height that one line of a note takes, px.
inline constexpr int kNoteHeight = 18;

/// Puts a text as the last row of the layout, small and grey; in several lines, broken behind
/// commas, where the plot is too narrow. After legend_below(). Does nothing with an empty text.
void note_below(QCustomPlot& plot, const std::string& text);

}  // namespace triax::src
