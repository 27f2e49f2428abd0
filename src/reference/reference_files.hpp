// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "lab/ags/triaxial_results.hpp"

namespace triax::src {

/// Files of results among the records of a replay.
class ReferenceFiles {
 public:
  /// Reads the file if it calls itself AGS; false for anything else. Throws BadInput for a file
  /// that cannot be opened, that is broken or holds no triaxial result.
  bool take(const std::string& path);
  /// Stores what was taken.
  void store(const std::string& db) const;

  const std::vector<lab::AgsResults>& all() const { return files_; }

 private:
  std::vector<lab::AgsResults> files_;
};

}  // namespace triax::src
