// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/soil/sands.hpp"

#include <cmath>

#include "lab/devices/noise.hpp"
#include "sim/materials/mohr_coulomb.hpp"
#include "sim/materials/norsand.hpp"
#include "sim/materials/sanisand.hpp"
#include "sim/mechanics/axisymmetric.hpp"

namespace triax::bench {
namespace {

constexpr std::uint64_t kSandStream = 900;

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : seed_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * lab::standard_uniform(seed_, kSandStream, number_++);
  }

 private:
  std::uint64_t seed_, number_ = 0;
};

VirtualSand norsand(Draw draw, bool power) {
  sim::NorSandParameters p;
  p.critical_stress_ratio = draw.between(1.15, 1.45);
  p.volumetric_coupling = draw.between(0.2, 0.4);
  p.state_dilatancy = draw.between(2.5, 4.5);
  p.hardening_modulus = draw.between(80, 250);
  p.shear_modulus_pa = draw.between(30e6, 80e6);
  p.shear_modulus_pressure_pa = 100e3;
  p.shear_modulus_exponent = 0.5;
  p.poisson_ratio = 0.2;
  SoilTruth truth;
  truth.m = p.critical_stress_ratio;
  if (power) {
    p.critical_void_ratio = draw.between(0.85, 1.05);
    p.critical_slope = draw.between(0.03, 0.08);
    p.critical_exponent = draw.between(0.4, 0.8);
    p.critical_pressure_pa = 100e3;
    truth.e0 = p.critical_void_ratio;
    truth.slope = p.critical_slope;
    truth.exponent = p.critical_exponent;
    truth.critical_void_ratio = [p](double p_kPa) {
      return p.critical_void_ratio - p.critical_slope * std::pow(p_kPa / 100, p.critical_exponent);
    };
  } else {
    p.critical_void_ratio = draw.between(0.85, 1.05);
    p.critical_slope = draw.between(0.015, 0.05);
    p.critical_pressure_pa = 1e3;
    truth.gamma = p.critical_void_ratio;
    truth.lambda = p.critical_slope;
    truth.critical_void_ratio = [p](double p_kPa) {
      return p.critical_void_ratio - p.critical_slope * std::log(p_kPa);
    };
  }
  return {truth, [p](const Specimen& s) -> LawPointer {
            auto of = p;
            of.critical_void_ratio += s.void_ratio_shift;
            of.critical_stress_ratio *= s.friction_factor;
            of.pore_fluid_bulk_modulus_pa = s.undrained ? 2e9 : 0;
            return std::make_shared<sim::NorSand>(of);
          }};
}

VirtualSand sanisand(Draw draw) {
  sim::SanisandParameters p;
  p.shear_modulus_factor = draw.between(100, 150);
  p.poisson_ratio = 0.05;
  p.critical_stress_ratio = draw.between(1.15, 1.4);
  p.extension_ratio = draw.between(0.68, 0.8);
  p.critical_void_ratio = draw.between(0.88, 0.98);
  p.critical_slope = draw.between(0.015, 0.03);
  p.critical_exponent = draw.between(0.6, 0.8);
  p.yield_radius = 0.01;
  p.hardening_factor = draw.between(6, 9);
  p.hardening_void_ratio_factor = 0.968;
  p.bounding_exponent = draw.between(1.0, 1.4);
  p.dilatancy_factor = draw.between(0.6, 0.9);
  p.dilatancy_exponent = draw.between(2.5, 3.5);
  p.fabric_limit = 4;
  p.fabric_rate = 600;
  p.atmospheric_pressure_pa = 100e3;
  SoilTruth truth;
  truth.m = p.critical_stress_ratio;
  truth.m_extension = p.critical_stress_ratio * p.extension_ratio;
  truth.e0 = p.critical_void_ratio;
  truth.slope = p.critical_slope;
  truth.exponent = p.critical_exponent;
  truth.critical_void_ratio = [p](double p_kPa) {
    return p.critical_void_ratio - p.critical_slope * std::pow(p_kPa / 100, p.critical_exponent);
  };
  return {truth, [p](const Specimen& s) -> LawPointer {
            auto of = p;
            of.critical_void_ratio += s.void_ratio_shift;
            of.critical_stress_ratio *= s.friction_factor;
            return std::make_shared<sim::Sanisand<sim::Axisymmetric>>(of);
          }};
}

/// σ₁′ = K σ₃′ + 2 c √K with all of it times the specimen's factor: K and c √K grow alike.
VirtualSand mohr_coulomb(Draw draw) {
  sim::MohrCoulombParameters p;
  p.young_modulus_pa = draw.between(20e6, 60e6);
  p.reference_pressure_pa = 100e3;
  p.poisson_ratio = 0.25;
  p.friction_angle = sim::radians(draw.between(28, 40));
  p.cohesion_pa = draw.between(0, 25e3);
  p.dilation_angle = 0;
  SoilTruth truth;
  truth.cohesion_kPa = p.cohesion_pa / 1e3;
  truth.friction_angle_deg = sim::degrees(p.friction_angle);
  return {truth, [p](const Specimen& s) -> LawPointer {
            auto of = p;
            const double sine = std::sin(p.friction_angle), k = (1 + sine) / (1 - sine);
            const double own = k * s.friction_factor;
            of.friction_angle = std::asin((own - 1) / (own + 1));
            of.cohesion_pa = p.cohesion_pa * std::sqrt(k) * s.friction_factor / std::sqrt(own);
            return std::make_shared<sim::MohrCoulomb<sim::Axisymmetric>>(of);
          }};
}

}  // namespace

VirtualSand draw_sand(Sand sand, std::uint64_t seed) {
  const Draw draw(seed);
  switch (sand) {
    case Sand::norsand_log:
      return norsand(draw, false);
    case Sand::norsand_power:
      return norsand(draw, true);
    case Sand::sanisand:
      return sanisand(draw);
    case Sand::mohr_coulomb:
      break;
  }
  return mohr_coulomb(draw);
}

}  // namespace triax::bench
