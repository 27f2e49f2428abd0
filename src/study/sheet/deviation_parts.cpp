// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/sheet/deviation_parts.hpp"

#include <fmt/format.h>

#include <cmath>

#include "src/study/triaxial/test_result.hpp"

namespace triax::study {
namespace {

constexpr double kLeastSlender = 1.8, kMostSlender = 2.5, kLeastDiameter_m = 0.034;
constexpr double kLargestDrains = 0.05, kLargestPiston = 0.001;  // of q_f

}  // namespace

void add_origin_deviation(std::vector<std::string>& out, const db::StoredTest& test) {
  if (test.header.origin == lab::Origin::simulated)
    out.emplace_back("simulated: a model, not a specimen; no standard covers it");
}

void add_dimension_deviations(std::vector<std::string>& out, const lab::SpecimenInfo& specimen,
                              int part) {
  if (!specimen.height_m || !specimen.diameter_m) {
    out.emplace_back("the record does not give the dimensions of the specimen");
    return;
  }
  const double slender = *specimen.height_m / *specimen.diameter_m;
  if (slender < kLeastSlender || slender > kMostSlender)
    out.push_back(fmt::format("H/D = {:.2f}; ISO 17892-{} requires 1.8 to 2.5, ASTM 2 to 2.5",
                              slender, part));
  if (*specimen.diameter_m < kLeastDiameter_m)
    out.push_back(fmt::format("diameter {:.1f} mm, below 34 mm (ISO 17892-{})",
                              *specimen.diameter_m * 1e3, part));
}

void add_load_deviations(std::vector<std::string>& out, const SheetValues& values,
                         const LoadCorrections& corrections) {
  if (!values.failure) return;
  const double q = std::abs(values.failure->state.q);
  const auto add = [&](const char* what, double stress, double limit, const char* standard) {
    if (std::abs(stress) > limit * q)
      out.push_back(fmt::format("{} {:.1f} % of q_f, not subtracted; {}", what,
                                std::abs(stress) / q * 100, standard));
  };
  if (corrections.side_drains)
    add("side drains carry", corrections.side_drains->taken_off_pa, kLargestDrains,
        "ASTM D4767 corrects from 5 % on");
  if (corrections.piston)
    add("the piston makes", corrections.piston->taken_off_pa, kLargestPiston,
        "ASTM D4767 allows 0.1 %");
}

void add_record_deviations(std::vector<std::string>& out, const db::StoredTest& test) {
  if (test.summary.membrane_correction == "none" && test.header.origin == lab::Origin::recorded)
    out.emplace_back("no correction for the membrane was applied");
  if (const auto last = last_believed_reading(test))
    out.push_back(fmt::format("a sensor failed: nothing after reading {} is used or drawn", *last));
}

}  // namespace triax::study
