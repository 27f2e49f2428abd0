// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a sheet says of a test beside what was stored of it: B by its steps, consolidation, failure
// by the chosen criterion, the rate of shear.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "db/store.hpp"
#include "src/study/handover/shear_values.hpp"
#include "src/study/sheet/root_time.hpp"
#include "src/study/soil/strength_set.hpp"

namespace triax::study {

struct SheetOptions {
  FailureCriterion failure = FailureCriterion::peak_deviator_stress;
  double failure_strain = 0.15;  ///< of the criterion axial_strain
  DrainageBoundary drained_at = DrainageBoundary::one_end;
  bool boundary_is_said = false;
};

/// A stage before shear in which the cell pressure was raised, from its first reading to its last.
struct PressureStep {
  int stage = 1;
  std::string name;
  lab::StageRole role = lab::StageRole::unknown;
  double cell_from_pa = lab::kMissing, cell_to_pa = lab::kMissing;
  double pore_from_pa = lab::kMissing, pore_to_pa = lab::kMissing;
  /// Δu/Δσ_c; only of a B check.
  std::optional<double> b() const;
};

/// The last stage of consolidation with a tenth or more of the outflow of those before it: a rest
/// behind one is none.
struct ConsolidationCurve {
  int stage = 1;
  std::vector<ConsolidationPoint> points;  ///< outflow in m³, or ε_v where no volume was read
  bool in_m3 = true;
  double p_eff_from_pa = lab::kMissing, p_eff_to_pa = lab::kMissing;
  std::optional<RootTime> fit;
  std::string why_no_fit;
};

struct SheetValues {
  SheetOptions options;
  std::vector<PressureStep> steps;
  std::optional<ConsolidationCurve> consolidation;
  std::optional<ScanValues> start, end;  ///< of shear: first and last scan with known stresses
  std::optional<ScanValues> failure;
  std::optional<ScanValues> at_15_pct;  ///< first scan of that axial strain
  std::string failure_reason;           ///< why there is none, or what is to be said of it
  lab::Drainage drainage = lab::Drainage::unknown;  ///< of the last stage of shear
  bool extension = false;
  std::optional<double> rate_per_s;          ///< of the axial strain, up to failure
  std::optional<double> allowed_rate_per_s;  ///< that t_100 allows
};

/// Of each stage of shear the readings up to the last one that can be believed
/// (last_believed_reading).
class SheetReader {
 public:
  SheetReader(const db::StoredTest& test, const SheetOptions& options);
  void add(const lab::Reading& reading, const lab::State& state);
  SheetValues take();

 private:
  void add_before_shear(const lab::Reading& reading, const lab::State& state);
  void add_shear(const lab::Reading& reading, const lab::State& state);
  void finish_consolidation();
  void find_failure();
  void find_total_stress_failure();
  void fail_at_strain();
  bool is_largest_q(const lab::State& state) const;
  void find_rates();

  const db::StoredTest& test_;
  SheetValues found_;
  std::optional<int> stage_;
  std::optional<std::int64_t> last_;
  std::int64_t stride_ = 1, count_ = 0;
  std::optional<ConsolidationCurve> consolidating_;  ///< the stage under way
  std::vector<double> mean_stress_;                  ///< total, beside its points
  std::optional<ScanValues> largest_q_, largest_ratio_, at_strain_;
  double beyond_q_ = 0;  ///< largest |q| beyond kLastTotalStrain, of a test of total stresses
  std::vector<lab::State> shear_;
};

SheetValues sheet_values(const db::Store& store, const db::StoredTest& test,
                         const SheetOptions& options);

}  // namespace triax::study
