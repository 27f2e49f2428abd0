// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/handover/ags_codes.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>

namespace triax::study {
namespace {

struct Meaning {
  std::string_view heading, code, words;
};

constexpr std::array kCodes{
    Meaning{"DICT_TYPE", "GROUP", "Defines a group"},
    Meaning{"DICT_TYPE", "HEADING", "Defines a heading"},
    Meaning{"DICT_STAT", "OTHER", "Neither key nor required"},
    Meaning{"TREG_COND", "UNDISTURBED", "Undisturbed"},
    Meaning{"TREG_COND", "REMOULDED", "Remoulded"},
    Meaning{"TRIG_COND", "UNDISTURBED", "Undisturbed"},
    Meaning{"TRIG_COND", "REMOULDED", "Remoulded"},
    Meaning{"CTRC_TYPE", "ISOTROPIC", "Isotropic"},
    Meaning{"CTRD_COND", "DRAINED", "Drained"},
    Meaning{"CTRD_COND", "UNDRAINED", "Undrained"},
    Meaning{"TRIG_TYPE", "UU", "Unconsolidated, undrained, one stage"},
    Meaning{"TRIG_TYPE", "UUM", "Unconsolidated, undrained, several stages"},
    Meaning{"TRIG_TYPE", "UNC", "Unconfined compression"},
    Meaning{"TREG_TYPE", "CSD",
            "Constant q, p' falls, drained (user code: no test of the standards)"},
    Meaning{"TREG_TYPE", "CSU",
            "Constant q, p' falls, undrained (user code: no test of the standards)"},
    Meaning{"SAMP_TYPE", "B", "Bulk disturbed"},
    Meaning{"SAMP_TYPE", "BLK", "Block"},
    Meaning{"SAMP_TYPE", "C", "Core"},
    Meaning{"SAMP_TYPE", "D", "Small disturbed"},
    Meaning{"SAMP_TYPE", "P", "Piston"},
    Meaning{"SAMP_TYPE", "TW", "Thin-walled, pushed"},
    Meaning{"SAMP_TYPE", "U", "Undisturbed, open drive"},
    Meaning{"SAMP_TYPE", "UT", "Thin-walled, open drive"}};

constexpr std::array<std::pair<std::string_view, std::string_view>, 20> kUnits{
    {{"m", "metre"},
     {"mm", "millimetre"},
     {"%", "per cent"},
     {"kPa", "kilopascal"},
     {"MPa", "megapascal"},
     {"Mg/m3", "megagram per cubic metre"},
     {"deg", "degree of an angle"},
     {"%/hr", "per cent in an hour"},
     {"%/min", "per cent in a minute"},
     {"s", "second"},
     {"g", "gram"},
     {"Hz", "cycles in a second"},
     {"day", "day"},
     {"m/s", "metre per second"},
     {"bar", "bar"},
     {"DegC", "degree Celsius"},
     {"l/min", "litre per minute"},
     {"yyyy-mm-dd", "date"},
     {"yyyy-mm-ddThh:mm", "date and time of day"},
     {"hh:mm:ss", "time that passed"}}};

constexpr std::array<std::pair<std::string_view, std::string_view>, 11> kTypes{
    {{"ID", "Name that occurs once"},
     {"X", "Text"},
     {"XN", "Text or number"},
     {"PA", "Code listed in group ABBR"},
     {"PT", "Code listed in group TYPE"},
     {"PU", "Code listed in group UNIT"},
     {"DT", "Date and time"},
     {"T", "Time that passed"},
     {"U", "Number of any form"},
     {"YN", "Yes or no"},
     {"DMS", "Degrees, minutes, seconds"}}};

/// "CIUC": C, isotropic or not, undrained or drained, compression or extension.
std::string consolidated_meaning(const std::string& code, bool cyclic) {
  if (code.size() != 4 || code[0] != 'C') return {};
  const std::string way = cyclic ? "cyclic" : code[3] == 'E' ? "extension" : "compression";
  return fmt::format("{} consolidated, {}, {}",
                     code[1] == 'I' ? "Isotropically" : "Anisotropically",
                     code[2] == 'U' ? "undrained" : "drained", way);
}

}  // namespace

std::string ags_test_type(const db::StoredTest& test, const ShearValues& shear) {
  constexpr double kIsotropic = 0.05;
  if (!shear.start || !shear.failure) return {};
  const lab::StageInfo* stage = test.header.stage(shear.start->state.stage);
  for (const lab::StageInfo& one : test.header.stages)  // behind a first part that brings q up
    if (one.role == lab::StageRole::shear && one.control == lab::AxialControl::constant_q)
      stage = &one;
  if (stage == nullptr || stage->drainage == lab::Drainage::unknown) return {};
  const bool drained = stage->drainage == lab::Drainage::open;
  if (stage->control == lab::AxialControl::constant_q) return drained ? "CSD" : "CSU";
  const auto& start = shear.start->state;
  const bool isotropic = std::abs(start.q) < kIsotropic * std::abs(start.p_eff);
  const bool extension = !test.summary.cyclic && shear.failure->state.q < 0;
  return std::string("C") + (isotropic ? 'I' : 'A') + (drained ? 'D' : 'U') +
         (extension ? 'E' : 'C');
}

std::string ags_code_meaning(const std::string& heading, const std::string& code) {
  for (const Meaning& one : kCodes)
    if (one.heading == heading && one.code == code) return std::string(one.words);
  if (heading == "TREG_TYPE") return consolidated_meaning(code, false);
  if (heading == "CTRG_TYPE") return consolidated_meaning(code, true);
  return {};
}

std::string ags_unit_meaning(const std::string& unit) {
  for (const auto& [name, words] : kUnits)
    if (name == unit) return std::string(words);
  return unit;
}

std::string ags_type_meaning(const std::string& type) {
  for (const auto& [name, words] : kTypes)
    if (name == type) return std::string(words);
  const auto count = type.substr(0, type.find_first_not_of("0123456789"));
  if (type.ends_with("DP")) return "Number with " + count + " decimals";
  if (type.ends_with("SF")) return "Number with " + count + " significant figures";
  return type;
}

}  // namespace triax::study
