// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/figures/origin_note.hpp"

#include <catch2/catch.hpp>

#include "src/plot/drawing.hpp"
#include "src/plot/plot_style.hpp"

using namespace triax::src;

namespace {

std::string note_in(QCustomPlot& plot) {
  for (int row = 0; row < plot.plotLayout()->rowCount(); ++row)
    if (auto* note = qobject_cast<QCPTextElement*>(plot.plotLayout()->element(row, 0)))
      return note->text().toStdString();
  return {};
}

}  // namespace

TEST_CASE("recorded tests have no note; simulated ones tell their materials") {
  CHECK(origin_note({}).empty());
  CHECK(origin_note({.tests = 2, .simulated = {}, .materials = {}}).empty());
  CHECK(origin_note({2, {"A", "B"}, {"inl2/x"}}) == "simulated: inl2/x");
  CHECK(origin_note({3, {"A", "B", "C"}, {"inl2/x", "sanisand/y"}}) ==
        "simulated: inl2/x, sanisand/y");
}

TEST_CASE("among recorded tests the simulated ones are named") {
  CHECK(origin_note({2, {"A"}, {"inl2/x"}}) == "simulated: A, with inl2/x");
  CHECK(origin_note({1, {"B"}, {}}) == "simulated");
  CHECK(origin_note({2, {"B"}, {}}) == "simulated: B");
}

TEST_CASE("of many materials their number is told") {
  CHECK(origin_note({4, {"a", "b", "c", "d"}, {"1", "2", "3", "4"}}) ==
        "simulated: 4 sets of parameters");
}

TEST_CASE(
    "a note is broken behind commas where the plot is too narrow, an empty one is not drawn") {
  auto narrow = make_plot(240, 200), broad = make_plot(900, 200), none = make_plot(240, 200);
  const std::string text = "simulated: inl2/S28-general, sanisand/S28-general, norsand/S28";
  note_below(*narrow, text);
  note_below(*broad, text);
  note_below(*none, "");
  CHECK(note_in(*broad) == text);
  CHECK(note_in(*narrow).find(",\n") != std::string::npos);
  CHECK(note_in(*none).empty());
}
