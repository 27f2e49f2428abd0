// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/study/sheet/sheet_values.hpp"
#include "src/study/triaxial/test_result.hpp"

namespace triax::study {
namespace {

constexpr double kLeastB = 0.95;
constexpr double kAnisotropic = 0.05;  // q/p′ at the start of shear
constexpr double kLeastSlender = 1.8, kMostSlender = 2.5, kLeastDiameter_m = 0.034;

using Sentences = std::vector<std::string>;

void add_origin(Sentences& out, const db::StoredTest& test) {
  if (test.header.origin == lab::Origin::simulated)
    out.emplace_back("simulated: a model, not a specimen; no standard covers it");
}

void add_shear(Sentences& out, const db::StoredTest& test, const SheetValues& values) {
  bool constant_q = false, load = false, strain_path = false, said = false;
  for (const auto& stage : test.header.stages) {
    if (stage.role != lab::StageRole::shear) continue;
    said = said || stage.control != lab::AxialControl::unknown;
    constant_q = constant_q || stage.control == lab::AxialControl::constant_q;
    load = load || stage.control == lab::AxialControl::load;
    strain_path = strain_path || stage.strain_path_R.has_value();
  }
  const auto& type = test.header.programme;
  if (type == "CSD" || type == "CSU" || constant_q)
    out.push_back(fmt::format(
        "{}shear at constant q is none of the standards' tests, which prescribe a rate of axial "
        "strain",
        type.empty() ? "" : type + ": "));
  if (test.summary.cyclic)
    out.emplace_back("cyclic load: none of these standards' tests (ASTM D5311)");
  else if (load)
    out.emplace_back("sheared under load control; the standards prescribe a rate of axial strain");
  if (strain_path) out.emplace_back("a strain path was prescribed, drainage neither open nor shut");
  if (!said) out.emplace_back("the record does not say how the axis was driven");
  if (values.extension) out.emplace_back("sheared in extension; the standards are of compression");
  if (values.start) {
    const auto& s = values.start->state;
    if (std::abs(s.q) > kAnisotropic * s.p_eff)
      out.push_back(fmt::format(
          "q = {:.1f} kPa at the start of shear: BS 1377-8 and ASTM know isotropic consolidation",
          s.q * 1e-3));
  }
}

void add_specimen(Sentences& out, const db::StoredTest& test) {
  const auto& specimen = test.header.specimen;
  if (!specimen.height_m || !specimen.diameter_m) {
    out.emplace_back("the record does not give the dimensions of the specimen");
    return;
  }
  const double slender = *specimen.height_m / *specimen.diameter_m;
  if (slender < kLeastSlender || slender > kMostSlender)
    out.push_back(
        fmt::format("H/D = {:.2f}; ISO 17892-9 asks for 1.8 to 2.5, ASTM for 2 to 2.5", slender));
  if (*specimen.diameter_m < kLeastDiameter_m)
    out.push_back(
        fmt::format("diameter {:.1f} mm, below 34 mm (ISO 17892-9)", *specimen.diameter_m * 1e3));
}

void add_saturation(Sentences& out, const db::StoredTest& test) {
  const auto b = test.summary.consolidation.b_value;
  if (!b)
    out.emplace_back("B was not measured, or its check is not in the record");
  else if (*b < kLeastB)
    out.push_back(fmt::format("B = {:.3f}, below 0.95", *b));
}

void add_rate(Sentences& out, const SheetValues& values) {
  if (!values.rate_per_s) out.emplace_back("no time in the record: the rate is not known");
  if (!values.consolidation)
    out.emplace_back("no consolidation in the record: t_100 and the rate it allows are not known");
  else if (!values.consolidation->fit)
    out.push_back("no t_100: " + values.consolidation->why_no_fit);
  if (values.rate_per_s && values.allowed_rate_per_s &&
      *values.rate_per_s > 1.05 * *values.allowed_rate_per_s)
    out.push_back(fmt::format("sheared {:.1f} times as fast as t_100 allows (BS 1377-8)",
                              *values.rate_per_s / *values.allowed_rate_per_s));
}

}  // namespace

std::vector<std::string> deviations_of(const db::StoredTest& test, const SheetValues& values) {
  Sentences out;
  add_origin(out, test);
  add_shear(out, test, values);
  add_specimen(out, test);
  add_saturation(out, test);
  add_rate(out, values);
  if (test.summary.membrane_correction == "none" && test.header.origin == lab::Origin::recorded)
    out.emplace_back("no correction for the membrane was applied");
  if (const auto last = last_believed_reading(test))
    out.push_back(fmt::format("a sensor failed: nothing after reading {} is used or drawn", *last));
  return out;
}

}  // namespace triax::study
