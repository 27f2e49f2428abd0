// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a report says of runs of grains, before it is said as text, HTML or PDF: one source, three
// forms.
#include <string>
#include <vector>

#include "db/grain_store.hpp"
#include "src/output/fact.hpp"
#include "src/output/table.hpp"

namespace triax::src {

/// A table with what its columns mean, and what follows from it.
struct GrainSection {
  std::string title;  ///< "Stage probes: responses and contacts"
  Table table;        ///< with a row at least
  std::vector<std::string> notes;
  std::vector<Fact> facts;
};

/// One run in full.
struct GrainContent {
  std::string title;        ///< "Run of grains 3: dense"
  std::string banner;       ///< what a reader must not miss: SIMULATED, INTERRUPTED
  std::vector<Fact> facts;  ///< where it comes from, and the specimen
  std::vector<GrainSection> sections;
};

GrainContent grain_content(const db::StoredGrainRun& run);

/// One row a run: id, name, status, specimen, and what its last stage came to.
Table grain_summary_table(const std::vector<db::StoredGrainRun>& runs);

}  // namespace triax::src
