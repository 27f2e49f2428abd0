#include "sim/stability/domain.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "sim/stability/first_negative.hpp"

namespace triax::sim {
namespace {

/// What is known of a state, and why not more.
struct Assessed {
  DomainState state;
  std::string refusal;
};

template <class Space>
class ColumnWalk {
 public:
  ColumnWalk(const Law<Space>& law, const DomainGrid& grid, int column,
             const DomainCriteria& criteria)
      : law_(law), grid_(grid), criteria_(criteria) {
    result_.column = column;
    result_.p = grid.p(column);
  }

  DomainColumn run() {
    std::vector<std::string> refusals;
    for (int row = 0; row < grid_.rows; ++row) {
      Assessed here = assess(grid_.q(row));
      refusals.push_back(std::move(here.refusal));
      result_.states.push_back(std::move(here.state));
    }
    for (const double side : {1.0, -1.0}) {
      std::vector<DomainState*> outward;
      for (DomainState& state : result_.states)
        if (side * state.q >= 0) outward.push_back(&state);
      if (side < 0) std::ranges::reverse(outward);
      name_what_is_behind_the_limit(outward);
      (side > 0 ? result_.compression : result_.extension) = boundary(outward);
    }
    for (std::size_t row = 0; row < refusals.size() && result_.refusal.empty(); ++row)
      if (result_.states[row].kind != DomainStateKind::beyond_limit)
        result_.refusal = refusals[row];
    return std::move(result_);
  }

 private:
  using Value = std::optional<double>;

  /// The response at (p, q), or what kind of state it is that has none.
  template <class Use>
  Assessed with_response(double q, const Use& use) const {
    Assessed here{.state = {.q = q}};
    const auto state = law_.start(domain_stress<Space>(result_.p, q), grid_.void_ratio);
    if (const auto objection = law_.objection(state)) {
      if (law_.at_limit(state))
        here.state.kind = DomainStateKind::beyond_limit;
      else
        here.refusal = *objection;
      return here;
    }
    try {
      use(std::make_shared<const IncrementalResponse<Space>>(law_, state), here);
    } catch (const std::runtime_error& failure) {
      here = {.state = {.q = q}, .refusal = failure.what()};
    }
    return here;
  }

  /// The plastic limit is one of all stresses: with dε₂ = 0 a state beyond it may still answer.
  static bool carries_all_stresses(const IncrementalResponse<Space>& response) {
    if constexpr (Space::kSize == 2) return true;  // the probes themselves say so
    constexpr int kDirections = 36;
    for (int i = 0; i < kDirections; ++i) {
      const PlaneVector v = unit_direction(2 * std::numbers::pi * i / kDirections);
      Vector<Space> stress;
      if constexpr (Space::kSize == 6) stress = as_tensor(Vector<Axisymmetric>(v.y(), v.x()));
      const auto rate = response.to_stress(stress);
      if (!rate.controllable && rate.culprit != kRefused) return false;
    }
    return true;
  }

  using Shared = std::shared_ptr<const IncrementalResponse<Space>>;

  bool carries_stresses(const Shared& response) const {
    if (!carries_all_stresses(*response)) return false;
    const Prober prober = make_prober(response, ProbeKind::stress);
    for (int i = 0; i < grid_.directions; ++i) {
      const Probe p = prober(2 * std::numbers::pi * i / grid_.directions);
      if (!p.answered && !p.refused) return false;
    }
    return true;
  }

  Assessed assess(double q) const {
    return with_response(q, [this](const auto& response, Assessed& here) {
      if (!carries_all_stresses(*response)) {
        here.state.kind = DomainStateKind::beyond_limit;
        return;
      }
      const Circle circle = probe_circle(make_prober(response, ProbeKind::stress),
                                         {.directions = grid_.directions, .keep_probes = false});
      DomainState& state = here.state;
      state.refused_directions = circle.refused;
      if (circle.refused > 0) here.refusal = refusal_of_direction(*response);
      if (circle.refused == grid_.directions) return;
      if (circle.unanswered > circle.refused) {
        state.kind = DomainStateKind::beyond_limit;
        return;
      }
      state.kind = circle.unstable() ? DomainStateKind::unstable : DomainStateKind::stable;
      state.least_work = circle.least.normalised;
      state.least_angle = circle.least.angle;
      for (const Cone& cone : circle.cones) state.cones.push_back({cone.from, cone.to});
    });
  }

  /// The law's words on the first direction that it does not follow.
  std::string refusal_of_direction(const IncrementalResponse<Space>& response) const {
    if constexpr (Space::kSize == 2)
      for (int i = 0; i < grid_.directions && !law_.finite(); ++i) {
        const PlaneVector v = unit_direction(2 * std::numbers::pi * i / grid_.directions);
        const auto rate = response.to_stress({v.y(), v.x()});
        if (rate.culprit != kRefused) continue;
        if (const auto words = law_.refusal(response.state(), rate)) return *words;
      }
    return "the law gives no answer in some directions";
  }

  Probe probe(double q, double angle) const {
    Probe found;
    with_response(q, [&](const auto& response, Assessed&) {
      found = make_prober(response, ProbeKind::stress)(angle);
    });
    return found;
  }

  bool within_limit(double q) const {
    const auto look = [this](const auto& response, Assessed& here) {
      here.state.kind =
          carries_stresses(response) ? DomainStateKind::stable : DomainStateKind::beyond_limit;
    };
    return with_response(q, look).state.kind != DomainStateKind::beyond_limit;
  }

  static void name_what_is_behind_the_limit(const std::vector<DomainState*>& outward) {
    bool behind = false;
    for (DomainState* state : outward) {
      behind = behind || state->kind == DomainStateKind::beyond_limit;
      if (behind && state->kind == DomainStateKind::refused)
        state->kind = DomainStateKind::beyond_limit;
    }
  }

  double precision(double q) const {
    const double row = grid_.rows > 1 ? (grid_.q_to - grid_.q_from) / (grid_.rows - 1) : 0;
    return kDomainPrecision * std::max(std::abs(q), row);
  }

  /// The last state within the limit, between one that is and one that is not.
  double limit_between(double in, double out) const {
    while (std::abs(out - in) > precision(out)) {
      const double middle = in + (out - in) / 2;
      (within_limit(middle) ? in : out) = middle;
    }
    return in;
  }

  // Values of the criteria: negative where met.
  Value least_work(double q) const {
    const DomainState state = assess(q).state;
    return state.least_work ? Value(*state.least_work - kUnstable) : std::nullopt;
  }
  Value isotropic_unloading(double q) const {
    static constexpr double kEqual = 1.25 * std::numbers::pi;  // dσ₁ = dσ₃ < 0 in plane strain
    const double angle = grid_.plane == ProbePlane::axisymmetric ? kIsotropicUnloading : kEqual;
    const Probe unloading = probe(q, angle);
    return unloading.answered ? Value(unloading.normalised - kUnstable) : std::nullopt;
  }

  /// Follows one criterion along rows that lead away from q = 0.
  template <class AtRow, class At>
  Value first_met(const std::vector<double>& rows, const AtRow& at_row, const At& at) const {
    Value before;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Value here = at_row(i);
      if (!here) return std::nullopt;
      if (*here < 0 && !before) return rows[i] == 0 ? Value(0) : std::nullopt;
      if (*here < 0)
        return first_negative(rows[i - 1], *before, rows[i], *here, precision(rows[i]), at);
      before = here;
    }
    return std::nullopt;
  }

  /// `most` rows at most are looked at, evenly spread, the last among them.
  Value first_met(const std::vector<double>& rows, const DomainWitness& witness,
                  std::size_t most) const {
    if (!witness || rows.empty()) return std::nullopt;
    const std::size_t steps = std::min(most, rows.size()) - 1;
    std::vector<double> some = {rows.front()};
    for (std::size_t i = 1; i <= steps; ++i) some.push_back(rows[i * (rows.size() - 1) / steps]);
    const auto at = [&](double q) { return Value(witness(result_.p, q).value_or(1)); };
    return first_met(
        some, [&](std::size_t i) { return at(some[i]); }, at);
  }

  DomainBoundary boundary(const std::vector<DomainState*>& outward) const {
    DomainBoundary found;
    std::vector<double> rows;
    std::vector<Value> least;
    const auto add = [&](const DomainState& state) {
      rows.push_back(state.q);
      least.push_back(state.least_work ? Value(*state.least_work - kUnstable) : std::nullopt);
    };
    for (const DomainState* state : outward) {
      if (state->kind == DomainStateKind::refused) break;
      if (state->kind == DomainStateKind::beyond_limit) {
        if (!rows.empty()) {
          found.limit_q = limit_between(rows.back(), state->q);
          if (*found.limit_q != rows.back()) add(assess(*found.limit_q).state);
        }
        break;
      }
      add(*state);
    }
    found.first_unstable_q = first_met(
        rows, [&](std::size_t i) { return least[i]; }, [this](double q) { return least_work(q); });
    if (found.first_unstable_q)
      found.first_unstable_angle = assess(*found.first_unstable_q).state.least_angle;
    const auto unloading = [this](double q) { return isotropic_unloading(q); };
    found.isotropic_unloading_q = first_met(
        rows, [&](std::size_t i) { return unloading(rows[i]); }, unloading);
    found.determinant_q = first_met(rows, criteria_.determinant, rows.size());
    found.localisation_q = first_met(rows, criteria_.localisation, kLocalisationRows);
    return found;
  }

  const Law<Space>& law_;
  const DomainGrid& grid_;
  const DomainCriteria& criteria_;
  DomainColumn result_;
};

double place(double from, double to, int index, int count) {
  if (count < 2 || index == 0) return from;
  return index == count - 1 ? to : from + (to - from) * index / (count - 1);
}

template <class Space>
DomainColumn column_of(const Law<Space>* law, const std::string& why_not, const DomainGrid& grid,
                       int column, const DomainCriteria& criteria) {
  if (law == nullptr)
    throw std::invalid_argument(why_not.empty() ? "the law has no form for this plane" : why_not);
  return domain_column(*law, grid, column, criteria);
}

}  // namespace

double DomainGrid::p(int column) const { return place(p_from, p_to, column, columns); }
double DomainGrid::q(int row) const { return place(q_from, q_to, row, rows); }

DomainColumn domain_column(const Law<Axisymmetric>& law, const DomainGrid& grid, int column,
                           const DomainCriteria& criteria) {
  return ColumnWalk<Axisymmetric>(law, grid, column, criteria).run();
}
DomainColumn domain_column(const Law<Tensor>& law, const DomainGrid& grid, int column,
                           const DomainCriteria& criteria) {
  return ColumnWalk<Tensor>(law, grid, column, criteria).run();
}

DomainColumn domain_column(const Material& material, const DomainGrid& grid, int column,
                           const DomainCriteria& criteria) {
  return grid.plane == ProbePlane::axisymmetric
             ? column_of(material.axisymmetric.get(), {}, grid, column, criteria)
             : column_of(material.tensor.get(), material.no_tensor, grid, column, criteria);
}

}  // namespace triax::sim
