// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What earlier tests of the same sand came to: a witness of the onset to come, beside what the test
// itself shows.
//
// The stress ratio at onset hardly moves with p′ and rates, and with density slowly; it does with
// what the pore fluid gives way, x = (1 − B)/B = c K. So each earlier test of the same control says
// its η with the standard error √(s² + (b Δx)² + its own²), and the mean of them by their
// precisions counts, its error not less than what they scatter by. A simulation does not scatter as
// specimens do: in place of s stands the error of a calibrated law.
#include <optional>
#include <string>
#include <vector>

#include "lab/results/forecast.hpp"
#include "lab/results/record_header.hpp"
#include "lab/results/summary.hpp"
#include "lab/warning/driven_path.hpp"

namespace triax::lab {

struct EarlierTest {
  std::string name;
  bool by_law = false;  ///< the onset is that of a simulation, which knows it
  DrivenPath::Control control = DrivenPath::Control::none;
  bool in_extension = false;
  double give = 0;              ///< x = (1 − B)/B of the pore fluid; 0 where B is not known
  std::optional<double> onset;  ///< |η|, of one that lost sustainability inside the limit surface
  double onset_error = 0;       ///< its standard error
  double min_work = 1;          ///< normalised, that one without an onset went through
};
/// Of a test that was judged, or of a simulation, which knows whether and where it lost
/// sustainability, whatever its verdict; empty for others, and where nothing drove it to an onset.
/// `forecasts`: what its alarm said, in order. Where the pore fluid gave way (B below 0.95) that
/// knows of the fluid, and the verdict does not: the onset is then the forecast that the path
/// reached, or the last before the verdict's onset.
std::optional<EarlierTest> earlier_test(const RecordHeader& header, const TestSummary& summary,
                                        const std::vector<Forecast>& forecasts);

class EarlierTests {
 public:
  struct Onset {
    double eta = 0, error = 0;  ///< |η| to come, and its standard error
  };
  void add(const EarlierTest& test) { tests_.push_back(test); }
  bool empty() const { return tests_.empty(); }
  const std::vector<EarlierTest>& all() const { return tests_; }
  /// Empty where none of that control had one.
  std::optional<Onset> onset(DrivenPath::Control control, bool in_extension, double give) const;
  /// None that was driven so, in that sense of shear, carried on.
  bool agree(DrivenPath::Control control, bool in_extension) const;
  /// The least normalised work with which all that were driven so, in that sense of shear, carried
  /// on; empty where one did not, or there is none.
  std::optional<double> carried_on(DrivenPath::Control control, bool in_extension) const;

 private:
  std::vector<EarlierTest> tests_;
};

}  // namespace triax::lab
