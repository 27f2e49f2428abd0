// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/materials/interpolated.hpp"

#include "sim/materials/moduli_table.hpp"
#include "sim/materials/probed_moduli.hpp"
#include "sim/materials/sanisand_moduli.hpp"

namespace triax::sim {

template <class Space>
PointState<Space> Interpolated<Space>::start(const Vector<Space>& stress, double void_ratio) const {
  return base_->start(stress, void_ratio);
}

template <class Space>
std::vector<std::string> Interpolated<Space>::memory_names() const {
  return base_->memory_names();
}

template <class Space>
std::optional<std::string> Interpolated<Space>::objection(const State& state) const {
  if (auto general = Law<Space>::objection(state)) return general;
  if constexpr (Space::kSize == 6)
    if (state.stress.template tail<3>().norm() > 1e-9 * state.stress.norm())
      return "the stress has shear components: the law is written for principal axes that stay "
             "fixed";
  return base_->objection(state);
}

template <class Space>
std::optional<std::string> Interpolated<Space>::warning(const State& state) const {
  return base_->warning(state);
}

template <class Space>
void Interpolated<Space>::response(const State& state, Response<Space>& out) const {
  InterpolatedForm<Space>& form = interpolated_form(out);
  form.quadratic = kind_ == Interpolation::inl2;
  base_->moduli(state, form.plus, form.minus);
}

template class Interpolated<Axisymmetric>;
template class Interpolated<Tensor>;

namespace {

template <class Space>
std::shared_ptr<const Law<Space>> interpolated(
    Interpolation kind, std::shared_ptr<const GeneralisedTriaxial<Space>> base) {
  return std::make_shared<Interpolated<Space>>(kind, std::move(base));
}

Material on_sanisand(Interpolation kind, const SanisandParameters& p) {
  Material m;
  m.axisymmetric =
      interpolated<Axisymmetric>(kind, std::make_shared<SanisandModuli<Axisymmetric>>(p));
  m.tensor = interpolated<Tensor>(kind, std::make_shared<SanisandModuli<Tensor>>(p));
  m.based_on = "generalised-triaxial moduli from SANISAND in closed form";
  return m;
}

Material on_table(Interpolation kind, const ParameterSet& set) {
  Material m;
  m.axisymmetric = interpolated<Axisymmetric>(kind, std::make_shared<ModuliTable>(set));
  m.no_tensor = "a table of moduli of triaxial tests holds axisymmetric states only";
  m.based_on = "generalised-triaxial moduli from a table";
  return m;
}

/// Why a law makes no base; empty where it does.
std::string unfit(const Material& base) {
  if (!base.tensor) return base.no_tensor;
  if (base.tensor->finite())
    return "a law that integrates its increments itself gives no rate at a state";
  const auto response = base.tensor->response(base.tensor->isotropic(100e3, 0.9));
  if (const auto* form = std::get_if<StiffnessForm<Tensor>>(&response); form && form->nonlinear)
    return "its responses to single unloadings are so contractive that their sum contracts under "
           "isotropic unloading from the start; use this law directly, it is incrementally "
           "nonlinear "
           "itself";
  if (std::holds_alternative<InterpolatedForm<Tensor>>(response))
    return "it is such an interpolation itself";
  return {};
}

Material on_law(Interpolation kind, const std::string& name, const MaterialFinder& find) {
  const Material base = find(name);
  if (const std::string reason = unfit(base); !reason.empty())
    throw std::invalid_argument("base is " + name + ", which cannot be a base: " + reason);
  // Probing SANISAND on its yield surface is its closed form.
  if (const auto* sanisand = dynamic_cast<const Sanisand<Tensor>*>(base.tensor.get())) {
    Material m = on_sanisand(kind, sanisand->parameters());
    m.based_on = "generalised-triaxial moduli from " + name + " in closed form";
    return m;
  }
  Material m;
  m.axisymmetric =
      interpolated<Axisymmetric>(kind, std::make_shared<ProbedModuli<Axisymmetric>>(base.tensor));
  m.tensor = interpolated<Tensor>(kind, std::make_shared<ProbedModuli<Tensor>>(base.tensor));
  m.based_on = "generalised-triaxial moduli from " + name + " by probing";
  return m;
}

LawDescription description(Interpolation kind, std::string name, std::string title) {
  LawDescription d;
  d.name = std::move(name);
  d.title = std::move(title);
  d.source = "Darve, Sibille, Daouadji and Nicot (2007), Eqs. 25 to 27; moduli from the base";
  d.parameters = {{.key = "base",
                   .meaning = "\"sanisand\" (parameters below), \"table\" (lists below) or LAW/SET "
                              "that is probed",
                   .kind = ParameterKind::text,
                   .chooses = true}};
  for (const auto& p : descriptions(sanisand_table())) d.parameters.push_back(p);
  for (const auto& p : moduli_table_parameters()) d.parameters.push_back(p);
  d.make = [kind](const ParameterSet& set, const MaterialFinder& find) {
    const auto base = set.texts.find("base");
    if (base == set.texts.end() || base->second == "sanisand")
      return on_sanisand(kind, parameters_from(set, sanisand_table()));
    for (const auto& row : sanisand_table())
      if (set.numbers.contains(row.description.key))
        throw std::invalid_argument(row.description.key + " is not used with the base " +
                                    base->second);
    if (base->second == "table") return on_table(kind, set);
    return on_law(kind, base->second, find);
  };
  return d;
}

}  // namespace

LawDescription inl2_law() {
  return description(Interpolation::inl2, "inl2", "INL2, incrementally nonlinear of second order");
}
LawDescription octolinear_law() {
  return description(Interpolation::octolinear, "octolinear",
                     "octolinear, incrementally piecewise linear in eight zones");
}

}  // namespace triax::sim
