// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/stability/localisation.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <vector>

#include "sim/stability/plane_rate.hpp"

namespace triax::sim {
namespace {

using Normal = Eigen::Vector3d;
using BandStrain = Eigen::Matrix<double, 6, 3>;

/// B: a ↦ sym(a ⊗ n).
BandStrain band_strain(const Normal& n) {
  constexpr double r = 1 / std::numbers::sqrt2;
  BandStrain b;
  b << n(0), 0, 0,            //
      0, n(1), 0,             //
      0, 0, n(2),             //
      r * n(1), r * n(0), 0,  //
      r * n(2), 0, r * n(0),  //
      0, r * n(2), r * n(1);
  return b;
}

struct Direction {
  Normal normal;
  BandStrain strain;
};
/// Evenly spread over the half sphere n₁ ≥ 0, on a spiral.
std::vector<Direction> half_sphere() {
  constexpr int kPoints = 600;
  const double turn = std::numbers::pi * (3 - std::sqrt(5.0));
  std::vector<Direction> all;
  for (int i = 0; i < kPoints; ++i) {
    const double x = (i + 0.5) / kPoints, r = std::sqrt(1 - x * x);
    const Normal n(x, r * std::cos(turn * i), r * std::sin(turn * i));
    all.push_back({n, band_strain(n)});
  }
  return all;
}
const std::vector<Direction>& grid() {
  static const std::vector<Direction> directions = half_sphere();
  return directions;
}

double acoustic_determinant(const Matrix<Tensor>& d, const BandStrain& b) {
  const Eigen::Matrix3d a = b.transpose() * d * b;
  return a.determinant();
}

double ratio(const Matrix<Tensor>& tangent, const Matrix<Tensor>& reference, const BandStrain& b) {
  return acoustic_determinant(tangent, b) / acoustic_determinant(reference, b);
}

/// Downhill from a normal along two directions across it, by ever smaller steps.
Localisation refine(const Matrix<Tensor>& tangent, const Matrix<Tensor>& reference,
                    Localisation best) {
  // Along a valley that is all but level the normal is not worth the search to its end.
  constexpr int kMostMoves = 500;
  double step = 0.05;
  for (int i = 0; i < kMostMoves && step > 1e-8; ++i) {
    const Normal across = best.normal.unitOrthogonal(), other = best.normal.cross(across);
    Localisation next = best;
    for (int k = 0; k < 8; ++k) {
      const double turn = k * std::numbers::pi / 4;
      const Normal n =
          (best.normal + step * (std::cos(turn) * across + std::sin(turn) * other)).normalized();
      const double value = ratio(tangent, reference, band_strain(n));
      if (value < next.determinant) next = {value, n};
    }
    if (next.determinant < best.determinant)
      best = next;
    else
      step /= 2;
  }
  if (best.normal(0) < 0) best.normal = -best.normal;
  return best;
}

/// The least normals of the grid, some apart from each other: there may be minima of several bands.
std::vector<Localisation> starts(const Matrix<Tensor>& tangent, const Matrix<Tensor>& reference) {
  constexpr std::size_t kStarts = 4;
  constexpr double kApart = 0.95;  // cosine
  std::vector<Localisation> all;
  for (const Direction& d : grid()) all.push_back({ratio(tangent, reference, d.strain), d.normal});
  std::ranges::sort(all, {}, &Localisation::determinant);
  std::vector<Localisation> chosen;
  for (const Localisation& l : all) {
    const auto near = [&](const Localisation& c) {
      return std::abs(c.normal.dot(l.normal)) > kApart;
    };
    if (std::ranges::none_of(chosen, near)) chosen.push_back(l);
    if (chosen.size() == kStarts) break;
  }
  return chosen;
}

double least_on_grid(const Matrix<Tensor>& tangent, const Matrix<Tensor>& reference) {
  double least = std::numeric_limits<double>::infinity();
  for (const Direction& d : grid()) least = std::min(least, ratio(tangent, reference, d.strain));
  return least;
}

/// The increment of a probe as six components; in plane strain its stress leaves dσ₂ to the law.
PointRate<Tensor> rate_of(const IncrementalResponse<Tensor>& response, ProbePlane plane,
                          ProbeKind kind, double angle) {
  const bool flat = plane == ProbePlane::plane_strain;
  if (flat && kind == ProbeKind::stress) return stress_rate(response, angle);
  const double y = std::sin(angle), x = std::cos(angle) / (flat ? 1 : std::numbers::sqrt2);
  const auto components = (Vector<Tensor>() << y, flat ? 0 : x, x, 0, 0, 0).finished();
  return kind == ProbeKind::stress ? response.to_stress(components)
                                   : response.to_strain(components);
}

}  // namespace

Eigen::Matrix3d acoustic_tensor(const Matrix<Tensor>& stiffness, const Eigen::Vector3d& normal) {
  const BandStrain b = band_strain(normal);
  return b.transpose() * stiffness * b;
}

Localisation localisation(const Matrix<Tensor>& tangent, const Matrix<Tensor>& reference) {
  Localisation least{std::numeric_limits<double>::infinity(), Normal::UnitX()};
  for (const Localisation& start : starts(tangent, reference)) {
    const Localisation found = refine(tangent, reference, start);
    if (found.determinant < least.determinant) least = found;
  }
  return least;
}

Matrix<Tensor> reference_stiffness(const Response<Tensor>& response) {
  if (const auto* form = std::get_if<StiffnessForm<Tensor>>(&response)) return form->stiffness;
  const auto& form = std::get<InterpolatedForm<Tensor>>(response);
  const Vector<Tensor> mean = (form.plus + form.minus).diagonal() / 2;
  return mean.cwiseInverse().asDiagonal();
}

std::optional<StateLocalisation> state_localisation(const IncrementalResponse<Tensor>& response,
                                                    ProbePlane plane, int directions) {
  const Matrix<Tensor> reference = reference_stiffness(response.law().response(response.state()));
  std::optional<StateLocalisation> least;
  Matrix<Tensor> of_least, before = Matrix<Tensor>::Zero();
  for (const ProbeKind kind : {ProbeKind::stress, ProbeKind::strain})
    for (int i = 0; i < directions; ++i) {
      const double angle = 2 * std::numbers::pi * i / directions;
      const auto rate = rate_of(response, plane, kind, angle);
      if (!rate.controllable) continue;
      const auto tangent = response.tangent_stiffness(rate);
      // Neighbours in a linear zone have the same tangent.
      if (!tangent || !tangent->allFinite() || *tangent == before) continue;
      before = *tangent;
      const double value = least_on_grid(*tangent, reference);
      if (least && !(value < least->determinant)) continue;
      of_least = *tangent;
      least = StateLocalisation{{value, Normal::UnitX()}, kind, angle};
    }
  if (least) static_cast<Localisation&>(*least) = localisation(of_least, reference);
  return least;
}

}  // namespace triax::sim
