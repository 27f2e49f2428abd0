// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/colour_steps.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace triax::src;

TEST_CASE("colours change exactly at the ends of the steps") {
  const std::vector<QColor> steps = {Qt::red, Qt::green, Qt::blue, Qt::black};
  auto gradient = stepped_gradient(steps);
  const auto at = [&](double value) { return QColor(gradient.color(value, QCPRange(0, 1))); };
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double low = 0.25 * static_cast<double>(i);
    CHECK(at(low + 1e-9) == steps[i]);
    CHECK(at(low + 0.2499) == steps[i]);
  }
  CHECK(at(std::nan("")) == kNoValue);
  const auto mixed = steps_between({QColor(0, 0, 0), QColor(100, 200, 100)}, 2);
  CHECK(mixed[0] == QColor(25, 50, 25));
  CHECK(mixed[1] == QColor(75, 150, 75));
}
