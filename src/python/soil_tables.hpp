// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/python/columns.hpp"
#include "src/study/soil/soil.hpp"

namespace triax::python {

/// A row a test, as in the document; what is unknown is NaN.
Columns table_of_tests(const study::Soil& soil);
/// Of the tests that are used and came to one, or near it.
Columns table_of_critical_states(const study::Soil& soil);
Columns table_of_circles(const study::Soil& soil);
/// Shear of one test.
Columns table_of_path(const study::TestPoints& test);
/// e over p′ by the form that fits better. Pre-condition: there is a line.
Columns table_of_line(const study::Soil& soil, const std::vector<double>& p_eff_kPa);

}  // namespace triax::python
