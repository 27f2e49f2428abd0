// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Runs of grains as parts of a report for browsers and of a PDF.
#include <string>
#include <vector>

#include "db/grain_store.hpp"
#include "src/plot/pages.hpp"

namespace triax::src {

/// A section with a table of the runs that links to one section each, with its figures.
std::string grain_html(const std::vector<db::StoredGrainRun>& runs);

/// The same as pages.
std::vector<PageSection> grain_pages(const std::vector<db::StoredGrainRun>& runs);

}  // namespace triax::src
