// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/domain.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "sim/stability/first_negative.hpp"

namespace triax::sim {
namespace {

/// How near the end of all answers a criterion counts as met there only, as a share of q: what
/// derivatives by differences are worth, of a law that integrates itself.
constexpr double kAtEnd = 1e-5;

/// What is known of a state, and why not more.
struct Assessed {
  DomainState state;
  std::string refusal;
  bool gap = false;  ///< a direction has no answer although the law does not refuse it
};

/// Directions without an answer.
struct Unanswered {
  int refused = 0, missing = 0;
  /// With refusals a missing answer may be a direction that the law was not made for as well.
  bool at_limit() const { return missing > 0 && refused == 0; }
};

template <class Space>
class ColumnWalk {
 public:
  ColumnWalk(const Law<Space>& law, const DomainGrid& grid, int column,
             const DomainCriteria& criteria)
      : law_(law), grid_(grid), criteria_(criteria) {
    result_.column = column;
    result_.p = grid.p(column);
    has_isotropic_state_ =
        !law_.objection(law_.start(domain_stress<Space>(result_.p, 0), grid_.void_ratio));
  }

  DomainColumn run() {
    std::vector<Assessed> rows;
    rows.reserve(static_cast<std::size_t>(grid_.rows));
    for (int row = 0; row < grid_.rows; ++row) rows.push_back(assess(grid_.q(row)));
    for (const double side : {1.0, -1.0}) {
      std::vector<Assessed*> outward;
      for (Assessed& row : rows)
        if (side * row.state.q >= 0) outward.push_back(&row);
      if (outward.empty()) continue;
      if (side < 0) std::ranges::reverse(outward);
      std::vector<Assessed> inner = up_to(outward.front()->state.q);
      std::vector<Assessed*> line;
      line.reserve(inner.size() + outward.size());
      for (Assessed& state : inner) line.push_back(&state);
      line.insert(line.end(), outward.begin(), outward.end());
      name_what_is_behind_the_limit(line);
      (side > 0 ? result_.compression : result_.extension) = boundary(line);
    }
    for (Assessed& row : rows) {
      if (result_.refusal.empty()) result_.refusal = std::move(row.refusal);
      result_.states.push_back(std::move(row.state));
    }
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
      // Where the law has no isotropic state either, what it objects to is no stress ratio.
      if (has_isotropic_state_ && law_.at_limit(state))
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
  static Unanswered of_all_stresses(const IncrementalResponse<Space>& response) {
    Unanswered found;
    if constexpr (Space::kSize == 6) {  // in axisymmetry the probes themselves say so
      constexpr int kDirections = 36;
      for (int i = 0; i < kDirections; ++i) {
        const PlaneVector v = unit_direction(2 * std::numbers::pi * i / kDirections);
        const auto rate = response.to_stress(as_tensor(Vector<Axisymmetric>(v.y(), v.x())));
        if (!rate.controllable)
          ++(rate.limiting_variable == kRefused ? found.refused : found.missing);
      }
    }
    return found;
  }

  using Shared = std::shared_ptr<const IncrementalResponse<Space>>;

  Unanswered unanswered(const Shared& response) const {
    if (const Unanswered all = of_all_stresses(*response); all.at_limit()) return all;
    Unanswered found;
    const Prober prober = make_prober(response, ProbeKind::stress);
    for (int i = 0; i < grid_.directions; ++i) {
      const Probe p = prober(2 * std::numbers::pi * i / grid_.directions);
      if (!p.answered) ++(p.refused ? found.refused : found.missing);
    }
    return found;
  }

  Assessed assess(double q) const {
    return with_response(q, [this](const Shared& response, Assessed& here) {
      DomainState& state = here.state;
      if (of_all_stresses(*response).at_limit()) {
        state.kind = DomainStateKind::beyond_limit;
        return;
      }
      const Circle circle = probe_circle(make_prober(response, ProbeKind::stress),
                                         {.directions = grid_.directions, .keep_probes = false});
      state.refused_directions = circle.refused;
      if (circle.refused > 0) here.refusal = refusal_of_direction(*response);
      here.gap = circle.unanswered > circle.refused;
      if (here.gap && circle.refused == 0) state.kind = DomainStateKind::beyond_limit;
      if ((here.gap && circle.refused == 0) || circle.unanswered == grid_.directions) return;
      state.kind = circle.unstable()       ? DomainStateKind::unstable
                   : circle.unanswered > 0 ? DomainStateKind::unknown
                                           : DomainStateKind::stable;
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
        if (rate.limiting_variable != kRefused) continue;
        if (const auto words = law_.refusal(response.state(), rate)) return *words;
      }
    return "the law gives no result in some directions";
  }

  Probe probe(double q, double angle) const {
    Probe found;
    with_response(q, [&](const auto& response, Assessed&) {
      found = make_prober(response, ProbeKind::stress)(angle);
    });
    return found;
  }

  /// Kind and gap of a state, without its circle.
  Assessed standing(double q) const {
    return with_response(q, [this](const Shared& response, Assessed& here) {
      const Unanswered found = unanswered(response);
      here.gap = found.missing > 0;
      here.state.kind = found.at_limit() ? DomainStateKind::beyond_limit : DomainStateKind::unknown;
    });
  }

  /// The isotropic state and others on the way to the first row of a side, exclusive: a criterion
  /// may be met below the grid.
  std::vector<Assessed> up_to(double q) const {
    constexpr double kMost = 24;
    std::vector<Assessed> inner;
    if (q == 0) return inner;
    const int count =
        static_cast<int>(std::clamp(std::ceil(std::abs(q) / row_height()), 1.0, kMost));
    for (int i = 0; i < count; ++i) inner.push_back(assess(q * i / count));
    return inner;
  }

  static void name_what_is_behind_the_limit(const std::vector<Assessed*>& outward) {
    bool behind = false;
    for (Assessed* at : outward) {
      if (behind) *at = {.state = {.q = at->state.q, .kind = DomainStateKind::beyond_limit}};
      behind = behind || at->state.kind == DomainStateKind::beyond_limit;
    }
  }

  double row_height() const {
    const double height = grid_.rows > 1 ? (grid_.q_to - grid_.q_from) / (grid_.rows - 1) : 0;
    return height > 0 ? height : std::abs(grid_.q_from);
  }

  double precision(double q) const {
    return kDomainPrecision * std::max(std::abs(q), row_height());
  }

  /// The last state that holds, between one that does and one that does not.
  template <class Holds>
  double last_between(double in, double out, const Holds& holds) const {
    while (std::abs(out - in) > precision(out)) {
      const double middle = in + (out - in) / 2;
      if (middle == in || middle == out) break;
      (holds(middle) ? in : out) = middle;
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

  Value limit(const std::vector<Assessed*>& outward) const {
    Value before;
    for (const Assessed* at : outward) {
      if (at->state.kind == DomainStateKind::refused) break;
      if (at->state.kind == DomainStateKind::beyond_limit)
        return before ? Value(last_between(*before, at->state.q,
                                           [this](double q) {
                                             return standing(q).state.kind !=
                                                    DomainStateKind::beyond_limit;
                                           }))
                      : std::nullopt;
      before = at->state.q;
    }
    return std::nullopt;
  }

  /// Where, behind `before`, directions begin to have no answer: `limit` or a gap on this side of
  /// it.
  double end_of_answers(double before, const Assessed& beyond, const Value& limit) const {
    const auto whole = [this](double q) {
      const Assessed at = standing(q);
      return !at.gap && at.state.kind != DomainStateKind::beyond_limit;
    };
    const bool at_limit = beyond.state.kind == DomainStateKind::beyond_limit && limit;
    if (at_limit && whole(*limit)) return *limit;
    return last_between(before, at_limit ? *limit : beyond.state.q, whole);
  }

  DomainBoundary boundary(const std::vector<Assessed*>& outward) const {
    DomainBoundary found;
    found.limit_q = limit(outward);
    std::vector<double> rows;
    std::vector<Value> least;
    Value end;
    const auto add = [&](const DomainState& state) {
      rows.push_back(state.q);
      least.push_back(state.least_work ? Value(*state.least_work - kUnstable) : std::nullopt);
    };
    for (const Assessed* at : outward) {
      const bool beyond = at->gap || at->state.kind == DomainStateKind::beyond_limit;
      if (beyond && !rows.empty()) {
        end = end_of_answers(rows.back(), *at, found.limit_q);
        if (*end != rows.back()) add(assess(*end).state);
      }
      if (beyond || at->state.kind == DomainStateKind::refused) break;
      add(at->state);
    }
    // What is met only where answers end is that end: W₂ and determinants vanish with control.
    const auto before_end = [&](const Value& q) {
      const double near = kAtEnd * std::max(std::abs(end.value_or(0)), row_height());
      return q && end && std::abs(*end - *q) <= near ? std::nullopt : q;
    };
    found.first_unstable_q = before_end(first_met(
        rows, [&](std::size_t i) { return least[i]; }, [this](double q) { return least_work(q); }));
    if (found.first_unstable_q)
      found.first_unstable_angle = assess(*found.first_unstable_q).state.least_angle;
    const auto unloading = [this](double q) { return isotropic_unloading(q); };
    found.isotropic_unloading_q = before_end(first_met(
        rows, [&](std::size_t i) { return unloading(rows[i]); }, unloading));
    for (const DomainCriterion& criterion : criteria_)
      if (const Value q = before_end(first_met(rows, criterion.witness, criterion.most_rows)))
        found.others_q.emplace(criterion.name, *q);
    return found;
  }

  const Law<Space>& law_;
  const DomainGrid& grid_;
  const DomainCriteria& criteria_;
  DomainColumn result_;
  bool has_isotropic_state_ = false;
};

double place(double from, double to, int index, int count) {
  if (count < 2 || index == 0) return from;
  return index == count - 1 ? to : from + (to - from) * index / (count - 1);
}

template <class Space>
DomainColumn column_of(const Law<Space>* law, const std::string& why_not, const DomainGrid& grid,
                       int column, const DomainCriteria& criteria) {
  if (law == nullptr)
    throw std::invalid_argument(why_not.empty() ? "the law is not formulated for this plane"
                                                : why_not);
  return domain_column(*law, grid, column, criteria);
}

}  // namespace

std::optional<double> DomainBoundary::other_q(std::string_view name) const {
  const auto found = others_q.find(name);
  return found == others_q.end() ? std::nullopt : std::optional(found->second);
}

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
