#pragma once
#include "sim/stability/domain.hpp"

namespace triax::sim {

/// The criteria of other kinds that go with a material and a grid, each computed from the state
/// alone. The material must outlive them; ask them from one thread at a time.
///
/// determinant    det Mˢ of the compliance in the plane, in a zone that holds its null vector:
///                octolinear in closed form (octolinear_cones.hpp), other laws by the half Hessian
///                of W₂ (stability_determinant.hpp). Not of laws that integrate themselves.
/// localisation   the least det of an acoustic tensor of the tangents in the plane
///                (localisation.hpp). Of laws with a tensor form, and only where asked for: some
///                milliseconds a state.
DomainCriteria domain_criteria(const Material& material, const DomainGrid& grid,
                               bool localisation = false);

}  // namespace triax::sim
