// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/calibrate/calibrated_set.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "lab/base/toml_number.hpp"
#include "lab/base/toml_reader.hpp"
#include "src/study/version.hpp"

namespace triax::study {
namespace {

std::string tests_in_words(const Calibration& c) {
  std::vector<std::string> names;
  for (const auto& path : c.measured) names.push_back(path.name);
  constexpr std::size_t kMostNames = 12;
  const std::size_t more = names.size() > kMostNames ? names.size() - kMostNames : 0;
  names.resize(names.size() - more);
  return fmt::format("{}{}", fmt::join(names, ", "),
                     more > 0 ? fmt::format(" and {} more", more) : "");
}

std::string source_of(const Calibration& c) {
  const auto simulated = std::ranges::count(c.measured, true, &MeasuredPath::simulated);
  return fmt::format("calibrated by triax {} from {} on {} test{} ({}){}: cost {:.4g}{}", version(),
                     c.start.name, c.measured.size(), c.measured.size() == 1 ? "" : "s",
                     tests_in_words(c),
                     simulated > 0 ? fmt::format(", {} of them simulated", simulated) : "", c.cost,
                     c.interrupted ? ", interrupted before the search ended" : "");
}

/// What stands behind a value: how sure it is.
std::string remark_on(const Calibration& c, const std::string& key) {
  const auto found = std::ranges::find(c.parameters, key, &ParameterEstimate::key);
  if (found == c.parameters.end()) return "  # as in " + c.start.name;
  if (!found->determined) return "  # not determined by these tests";
  return fmt::format("  # {:.4g} to {:.4g} with {:.0f} % confidence{}", found->low, found->high,
                     100 * c.confidence, found->at_bound ? ", at the bound of its range" : "");
}

std::string list_remark(const Calibration& c, const std::string& key) {
  std::string text;
  for (const auto& p : c.parameters)
    if (p.key.starts_with(key + "."))
      text += fmt::format("# {} is {:.6g}{}\n", p.key, p.value, remark_on(c, p.key).substr(3));
  return text;
}

/// The folder of the set is not that of the file that is written.
std::string text_value(const sim::ParameterSet& set, const std::string& key,
                       const std::string& value) {
  namespace fs = std::filesystem;
  std::error_code none;
  const fs::path there = fs::path(set.folder) / value;
  if (key == "umat" && fs::is_regular_file(there, none))
    return lab::toml_quoted(fs::absolute(there, none).string());
  return lab::toml_quoted(value);
}

std::string table_of(const Calibration& c, const std::string& name, Imposed imposed) {
  const sim::ParameterSet set = for_drainage(c.material.parameters, *c.material.law, imposed);
  const auto& e = *c.material.void_ratio_range;
  const auto& p = *c.material.p_eff_range_kPa;
  std::string out = fmt::format(
      "[sets.{}]\ndescription = {}\nsource = {}\nrange = \"p' {:.4g} to {:.4g} kPa, e {:.4g} to "
      "{:.4g} at the start of shear, that of the tests\"\n"
      "void_ratio_range = [{}, {}]\np_eff_range_kPa = [{}, {}]\n",
      lab::toml_quoted(name), lab::toml_quoted(fmt::format("{}, calibrated", c.material.law->name)),
      lab::toml_quoted(source_of(c)), p.low, p.high, e.low, e.high, lab::toml_number(e.low),
      lab::toml_number(e.high), lab::toml_number(p.low), lab::toml_number(p.high));
  for (const auto& parameter : c.material.law->parameters) {
    const std::string& key = parameter.key;
    if (const auto text = set.texts.find(key); text != set.texts.end())
      out += fmt::format("{} = {}\n", key, text_value(set, key, text->second));
    if (const auto number = set.numbers.find(key); number != set.numbers.end())
      out += fmt::format("{} = {}{}\n", key, lab::toml_number(number->second), remark_on(c, key));
    if (const auto list = set.lists.find(key); list != set.lists.end()) {
      std::vector<std::string> values;
      for (const double value : list->second) values.push_back(lab::toml_number(value));
      out += fmt::format("{}{} = [{}]\n", list_remark(c, key), key, fmt::join(values, ", "));
    }
  }
  return out;
}

}  // namespace

std::string set_name_from(const std::string& file) {
  std::string name = std::filesystem::path(file).stem().string();
  for (char& letter : name)
    if (std::isalnum(static_cast<unsigned char>(letter)) == 0 && letter != '_' && letter != '-')
      letter = '-';
  return name.empty() ? "calibrated" : name;
}

std::string calibrated_toml(const Calibration& c, const std::string& set_name) {
  std::string out = fmt::format(
      "# Parameters found by triax calibrate; take them with --materials FILE --material {}/{}.\n"
      "law = \"{}\"\n\n",
      c.material.law->name, set_name, c.material.law->name);
  const auto undrained = for_drainage(c.material.parameters, *c.material.law, Imposed::undrained);
  const auto drained = for_drainage(c.material.parameters, *c.material.law, Imposed::drained);
  out += table_of(c, set_name, Imposed::undrained);
  if (undrained.numbers != drained.numbers)
    out += "\n" + table_of(c, set_name + "-drained", Imposed::drained);
  return out;
}

}  // namespace triax::study
