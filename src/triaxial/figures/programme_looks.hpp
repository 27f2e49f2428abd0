// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One marker and colour a type of test, the same in all figures of one set of tests.
#include <qcustomplot.h>

#include <map>
#include <string>
#include <vector>

namespace triax::src {

class ProgrammeLooks {
 public:
  /// Types of tests as they come, any number of times; empty is "other".
  explicit ProgrammeLooks(const std::vector<std::string>& programmes);

  /// In the order of the alphabet.
  std::vector<std::string> names() const;
  QColor colour(const std::string& programme) const;
  /// Filled for recorded tests, open for simulated ones; the shape alone tells types apart in a
  /// black-and-white print.
  QCPScatterStyle marker(const std::string& programme, bool simulated) const;

 private:
  std::size_t number(const std::string& programme) const;
  std::map<std::string, std::size_t> numbers_;
};

}  // namespace triax::src
