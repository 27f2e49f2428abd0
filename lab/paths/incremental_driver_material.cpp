// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/paths/incremental_driver_material.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/paths/inp_frame.hpp"
#include "sim/materials/laws.hpp"

namespace triax::lab {
namespace {

constexpr int kMostProperties = 10'000;

/// What is known of a start before the law is built.
struct Translation {
  std::string law;
  sim::ParameterSet parameters;
  std::optional<double> void_ratio;
  std::vector<double> memory;
};

class Translator {
 public:
  Translator(const InpMaterial& inp, const std::string& where, std::vector<std::string>& warnings)
      : inp_(inp), where_(where), warnings_(warnings) {
    const auto words = inp_words(inp.name);
    name_ = words.empty() ? "" : folded(words[0]);
  }

  Translation translate() {
    if (name_ == "mcc") return cam_clay();
    if (const auto* law = sim::find_law(name_); law != nullptr && name_ != "umat")
      return own_law(*law);
    if (name_.starts_with("hypo-vw96")) return hypoplastic_of_xmat();
    if (name_.starts_with("hypo") && inp_.properties.size() == 16) return hypoplastic();
    std::vector<std::string> known = {"MCC", "HYPO (16 numbers)", "Hypo-VW96"};
    for (const auto& law : sim::laws())
      if (law.name != "umat") known.push_back(law.name);
    fail(
        fmt::format("{} with {} numbers is not a law of triax; {}; for another law give the "
                    "library with its UMAT: umat=libNAME.so",
                    excerpt(inp_.name), inp_.properties.size(), must_be_one_of(known)));
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { throw BadInput(where_, 0, message); }
  void warn(const std::string& message) { warnings_.push_back(where_ + ": " + message); }

  double property(std::size_t number) const { return inp_.properties[number - 1]; }
  double state(std::size_t number) const {
    return number <= inp_.state.size() ? inp_.state[number - 1] : 0;
  }
  void need(std::size_t count, const char* which) const {
    if (inp_.properties.size() != count)
      fail(fmt::format("{} numbers, {} has {}: {}", inp_.properties.size(), excerpt(name_), count,
                       which));
  }
  std::optional<double> void_ratio_state(std::size_t number) const {
    return state(number) > 0 ? std::optional(state(number)) : std::nullopt;
  }

  Translation own_law(const sim::LawDescription& law) {
    Translation t{law.name, {}, {}, {}};
    std::size_t next = 0;
    for (const auto& parameter : law.parameters) {
      if (parameter.kind != sim::ParameterKind::number || next == inp_.properties.size()) continue;
      t.parameters.numbers[parameter.key] = inp_.properties[next++];
    }
    if (next < inp_.properties.size())
      fail(fmt::format("{} numbers, {} has {}", inp_.properties.size(), law.name, next));
    if (std::ranges::any_of(inp_.state, [](double v) { return v != 0; }))
      warn("the state variables of the start are ignored: their order differs from that of triax");
    return t;
  }

  Translation cam_clay() {
    need(4, "λ, κ, M, ν");
    const double m = property(3);
    Translation t{"cam_clay", {}, void_ratio_state(1), {}};
    t.parameters.numbers = {{"compression_slope", property(1)},
                            {"swelling_slope", property(2)},
                            {"critical_stress_ratio", m},
                            {"poisson_ratio", property(4)}};
    const double p = sim::mean_stress<sim::Tensor>(inp_.stress);
    const double q = sim::deviator_stress<sim::Tensor>(inp_.stress);
    const double surface = p + q * q / (m * m * p), preconsolidation = std::abs(state(8)) * 1e3;
    if (preconsolidation > surface * (1 + 1e-12) && surface > 0)
      t.parameters.numbers["overconsolidation_ratio"] = preconsolidation / surface;
    return t;
  }

  Translation hypoplastic() {
    Translation t{"hypoplastic", {}, void_ratio_state(7), {}};
    take_hypoplastic(t, property(1), property(10), property(11));
    if (property(2) != 0) warn(fmt::format("p_t = {} kPa is ignored", property(2)));
    if (property(15) != 0)
      fail(
          "the bulk modulus of the water (number 15) is not 0: its stresses would be total "
          "stresses, but triax prescribes effective stresses");
    if (!t.void_ratio && property(16) > 0 && property(16) < 10) t.void_ratio = property(16);
    if (property(12) > 0) t.memory = intergranular(1);
    return t;
  }

  Translation hypoplastic_of_xmat() {
    need(16, "φ_c (rad), ν, h_s, n, e_d0, e_c0, e_i0, α, β, m_T, m_R, R, β_r, χ, 0, 0");
    Translation t{"hypoplastic", {}, void_ratio_state(1), {}};
    take_hypoplastic(t, property(1) * 180 / std::numbers::pi, property(11), property(10));
    if (property(11) <= 2) {
      t.parameters.numbers["intergranular_range"] = 0;
    } else if (property(12) > 0) {
      if (std::ranges::any_of(
              inp_.state.begin() + std::min<std::ptrdiff_t>(1, std::ssize(inp_.state)),
              inp_.state.end(), [](double v) { return v != 0; }))
        fail("state variables of the start other than the void ratio are not supported");
      t.memory.assign(6, 0);
    }
    return t;
  }

  void take_hypoplastic(Translation& t, double friction_deg, double m_r, double m_t) {
    t.parameters.numbers = {{"critical_friction_angle_deg", friction_deg},
                            {"granulate_hardness_kPa", property(3)},
                            {"pressure_exponent", property(4)},
                            {"densest_void_ratio", property(5)},
                            {"critical_void_ratio", property(6)},
                            {"loosest_void_ratio", property(7)},
                            {"peak_exponent", property(8)},
                            {"stiffness_exponent", property(9)},
                            {"intergranular_range", property(12)}};
    if (property(12) <= 0) return;
    t.parameters.numbers["reversal_factor"] = m_r;
    t.parameters.numbers["transverse_factor"] = m_t;
    t.parameters.numbers["intergranular_rate_exponent"] = property(13);
    t.parameters.numbers["intergranular_exponent"] = property(14);
  }

  /// STATEV from `first` on, tension positive with γ = 2 ε, as our components.
  std::vector<double> intergranular(std::size_t first) const {
    std::vector<double> h(6);
    for (std::size_t i = 0; i < 6; ++i)
      h[i] = -state(first + i) * (i < 3 ? 1 : 1 / std::numbers::sqrt2);
    return h;
  }

  const InpMaterial& inp_;
  const std::string& where_;
  std::vector<std::string>& warnings_;
  std::string name_;
};

Translation as_plugin(const InpMaterial& inp, const IncrementalDriverSettings& settings) {
  Translation t{"umat", {}, {}, {}};
  t.parameters.texts = {{"umat", settings.umat}, {"name", inp.name}};
  t.parameters.lists = {{"properties", inp.properties}, {"initial_state", inp.state}};
  t.parameters.numbers["state_variables"] = static_cast<double>(inp.state.size());
  if (settings.time_limit_s) t.parameters.numbers["time_limit_s"] = *settings.time_limit_s;
  return t;
}

}  // namespace

InpMaterial read_inp_material(InpLines& parameters, InpLines& start) {
  InpMaterial inp;
  const std::string name = parameters.required("the name of the material");
  inp.name = name.substr(0, std::min<std::size_t>(name.find('#'), 80));
  inp.name.erase(inp.name.find_last_not_of(" \t") + 1);
  const int count = parameters.whole("the number of properties", 0, kMostProperties);
  for (int i = 0; i < count; ++i)
    inp.properties.push_back(parameters.numbers(1, fmt::format("property {}", i + 1))[0]);

  const int stresses = start.whole("the number of stress components", 1, 6);
  for (int i = 0; i < stresses; ++i) {
    const double kpa = start.numbers(1, fmt::format("stress {} (kPa)", i + 1))[0];
    inp.stress(i) = -1e3 * kpa * (i < 3 ? 1 : std::numbers::sqrt2);
  }
  const int states = start.whole("the number of state variables", 0, kMostProperties);
  inp.state.assign(static_cast<std::size_t>(states), 0);
  for (auto& value : inp.state) {
    const auto line = start.next();
    if (!line) break;  // what is not given is 0
    const auto words = inp_words(*line);
    const auto number = fortran_number(words.empty() ? "" : words[0]);
    if (!number) start.fail(fmt::format("{} is not a state variable", excerpt(*line)));
    value = *number;
  }
  return inp;
}

InpStart start_from_inp(const InpMaterial& inp, const IncrementalDriverSettings& settings,
                        const std::string& where, const std::string& folder,
                        std::vector<std::string>& warnings) {
  Translation t = settings.umat.empty() ? Translator(inp, where, warnings).translate()
                                        : as_plugin(inp, settings);
  const auto index = static_cast<std::size_t>(std::max(settings.void_ratio_index, 0));
  if (index > inp.state.size())
    throw BadInput(
        fmt::format("void_ratio_index={}: out of range; the start has {} state variables", index,
                    inp.state.size()));
  if (index > 0) t.void_ratio = inp.state[index - 1];
  if (settings.void_ratio) {
    t.void_ratio = settings.void_ratio;
    if (index > 0 && t.law == "umat")
      t.parameters.numbers["void_ratio_index"] = settings.void_ratio_index;
  }
  if (!t.void_ratio || !(*t.void_ratio > 0))
    throw BadInput(where, 0,
                   "the void ratio of the start is missing: give void_ratio=NUMBER, or "
                   "void_ratio_index=N if it is state variable N");
  InpStart start;
  start.void_ratio = *t.void_ratio;
  start.memory = std::move(t.memory);
  MaterialSet& set = start.material;
  set.law = sim::find_law(t.law);
  if (set.law == nullptr) throw BadInput(where, 0, fmt::format("unknown law {}", t.law));
  const auto words = inp_words(inp.name);
  set.name = fmt::format("{}/{}", t.law, words.empty() ? "unnamed" : words[0]);
  set.description = "as the files of an incrementalDriver have it";
  set.source = where;
  set.parameters = std::move(t.parameters);
  set.parameters.folder = settings.umat.empty() ? folder : "";
  try {
    set.material = set.law->make(
        set.parameters, [](const std::string& name) { return find_material(name).material; });
  } catch (const std::invalid_argument& error) {
    throw BadInput(where, 0, error.what());
  }
  return start;
}

}  // namespace triax::lab
