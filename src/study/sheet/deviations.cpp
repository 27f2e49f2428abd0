// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/sheet/deviations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/study/sheet/deviation_parts.hpp"
#include "src/study/sheet/total_stress.hpp"

namespace triax::study {
namespace {

constexpr double kLeastB = 0.95;
constexpr double kAnisotropic = 0.05;  // q/p′ at the start of shear

using Sentences = std::vector<std::string>;

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
    out.push_back(
        fmt::format("{}shear at constant q is not a test of these standards, which prescribe a "
                    "rate of axial strain",
                    type.empty() ? "" : type + ": "));
  if (test.summary.cyclic)
    out.emplace_back("cyclic load is not covered by these standards (see ASTM D5311)");
  else if (load)
    out.emplace_back("sheared under load control; the standards prescribe a rate of axial strain");
  if (strain_path)
    out.emplace_back("a strain path was prescribed, drainage neither open nor closed");
  if (!said) out.emplace_back("the control of the axis is not in the record");
  if (values.extension) out.emplace_back("sheared in extension; the standards cover compression");
  if (values.start) {
    const auto& s = values.start->state;
    if (std::abs(s.q) > kAnisotropic * s.p_eff)
      out.push_back(
          fmt::format("q = {:.1f} kPa at the start of shear: BS 1377-8 and ASTM require isotropic "
                      "consolidation",
                      s.q * 1e-3));
  }
}

void add_saturation(Sentences& out, const db::StoredTest& test) {
  const auto b = test.summary.consolidation.b_value;
  if (!b)
    out.emplace_back("B was not measured, or its check is not in the record");
  else if (*b < kLeastB)
    out.push_back(fmt::format("B = {:.3f}, below 0.95", *b));
}

void add_rate(Sentences& out, const SheetValues& values) {
  if (!values.rate_per_s) out.emplace_back("no time in the record: the rate is unknown");
  if (!values.consolidation)
    out.emplace_back("no consolidation in the record: t_100 and the allowed rate are unknown");
  else if (!values.consolidation->fit)
    out.push_back("no t_100: " + values.consolidation->why_no_fit);
  if (values.rate_per_s && values.allowed_rate_per_s &&
      *values.rate_per_s > 1.05 * *values.allowed_rate_per_s)
    out.push_back(fmt::format("sheared {:.1f} times as fast as t_100 allows (BS 1377-8)",
                              *values.rate_per_s / *values.allowed_rate_per_s));
}

}  // namespace

std::vector<std::string> deviations_of(const db::StoredTest& test, const SheetValues& values,
                                       const SheetWords& words) {
  if (test.header.is_total_stress()) return total_stress_deviations(test, values, words);
  Sentences out;
  add_origin_deviation(out, test);
  add_shear(out, test, values);
  add_dimension_deviations(out, test.header.specimen, 9);
  add_saturation(out, test);
  add_rate(out, values);
  add_load_deviations(out, values, load_corrections(test, values, words));
  add_record_deviations(out, test);
  return out;
}

}  // namespace triax::study
