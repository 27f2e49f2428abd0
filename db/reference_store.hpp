// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Results that laboratories reported, beside the tests that triax has measured or simulated.
#include <string>
#include <vector>

#include "lab/results/reference_result.hpp"

namespace triax::db {

/// A file of results. The same file is the same place in the file system, however it is named.
struct ReferenceFile {
  std::string source;   ///< as the user named it
  std::string project;  ///< empty: not said
};

/// Stores the results of one file in place of those that it had before, all or none. Creates the
/// database where there is none. Throws as open_for_writing() does.
void store_reference_results(const std::string& db, const ReferenceFile& file,
                             const std::vector<lab::ReferenceResult>& results);

/// The stored results of that file, in the order in which they were given; none for a file that was
/// never imported. Throws as open_for_reading() does.
std::vector<lab::ReferenceResult> load_reference_results(const std::string& db,
                                                         const std::string& source);

}  // namespace triax::db
