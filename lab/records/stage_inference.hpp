// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Roles of stages that a file numbers but does not name, judged from what moved in them.
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "lab/records/table_reader.hpp"
#include "lab/results/record_header.hpp"

namespace triax::lab {

/// A straight-line fit that is fed one point at a time.
struct LineFit {
  double n = 0, mean_x = 0, mean_y = 0, sxx = 0, sxy = 0, syy = 0;
  void add(double x, double y);
  double slope() const { return sxy / sxx; }
  /// Standard deviation of y about the line.
  double residual() const;
  /// Share of the variance of y that the line explains, 0 if nothing moves.
  double r_squared() const;
};

/// What one stage did, in constant memory.
struct StageSummary {
  struct Span {
    double first = kMissing, last = kMissing, low = kMissing, high = kMissing;
    void add(double value);
    double change() const { return last - first; }
    double range() const { return high - low; }
    /// Largest distance from the first value.
    double excursion() const;
  };
  int number = 1;
  std::int64_t rows = 0;
  std::int64_t first_line = 0;
  std::array<Span, kQuantityCount> spans;
  Span deviator;          ///< q, or σ₁' − σ₃', of the columns; of raw channels none
  Span effective_radial;  ///< σ₃' as the columns or the pressures give it
  Span total_radial;      ///< the same and u
  LineFit displacement_in_time;
  LineFit force_in_time;
  LineFit displacement_in_strain;  ///< slope: the height (m) behind the file's own axial strain

  void add(const Row& row);
  const Span& operator[](Quantity q) const { return spans[index(q)]; }
};

/// Reads all rows once. `number_of` turns the stage column's value in a line into a stage number.
/// `held_cell_pressure` (Pa) is that of each row of a table without a column of it. `stage_lines`
/// are the first lines of stage 1, 2, ... of a table without a stage column; empty: all is stage 1.
/// `each` is called with each row.
std::vector<StageSummary> summarise_stages(
    TableReader& reader, const std::function<int(double value, std::int64_t line)>& number_of,
    const std::optional<double>& held_cell_pressure = {},
    std::span<const std::int64_t> stage_lines = {},
    const std::function<void(const Row&)>& each = {});

/// Number of the stage of a line, from the first line of each stage.
int stage_at_line(std::span<const std::int64_t> stage_lines, std::int64_t line);

/// Role, drainage and control of each stage; `specimen` gives the scale of what counts as movement.
///   shear          the cap moves by more than 0.5 % of the height while |ΔF| exceeds 5 kPa·A. In
///                  a file without such a stage, after consolidation: |ΔF| alone where σ_c stands,
///                  and whatever moves while that load is still on the cap
///   b_check        σ_c moves by more than 5 kPa, V_b stands still, Δu/Δσ_c >= 0.5
///   saturation     σ_c rises and u or u_b with it (σ_c − u changes by less than half of that), or
///                  a closed stage whose u hardly answers: still filling
///   consolidation  V_b moves, none of the above; or saturation after the last B check; or
///                  shear with V_b moving while σ_c rises, where a later stage is sheared:
///                  anisotropic and K0 consolidation
/// Closed where V_b stands still (range below 1e-4 of the specimen's volume; 20 mm³ if unknown).
std::vector<StageInfo> infer_stages(const std::vector<StageSummary>& summaries,
                                    const SpecimenInfo& specimen);

/// What else a watched stage may have been, where what moved leaves it open: the other drainage,
/// unless V_b moved by more than kPlainFlow of the specimen's volume, or stood still while u moved
/// by more than 5 kPa; the other of consolidation and shear, where a load was put on a cap that
/// moved little or while the drainage was open; a held q, where the drainage was open, nobody knows
/// what moved the axis and a pressure moved under its load.
std::vector<Guess::Said> other_answers(const StageSummary& moved, const StageInfo& inferred,
                                       const SpecimenInfo& specimen);

/// The height (m, to 5 digits) that an operator typed in for the shear stage: there where the
/// file's own axial strain is displacement over one constant height that differs by more than 0.05
/// % from `our_height_m`.
std::optional<double> typed_height(const StageSummary& shear, double our_height_m);

}  // namespace triax::lab
