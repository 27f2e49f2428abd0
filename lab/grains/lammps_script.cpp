// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/grains/lammps_script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "sim/grains/state/triaxial_axes.hpp"

namespace triax::lab {
namespace {

using Kind = sim::GrainPathKind;

constexpr char kAxis[] = "xyz";
constexpr double kSkin = 0.1;    ///< of the neighbour lists, over the smallest radius
constexpr double kReach = 0.05;  ///< how much nearer to a wall grains are watched, over the same
constexpr int kWatchEvery = 20;  ///< steps between looks at which grains are near a wall
constexpr double kServoGain = 0.05, kWallSpeed_m_per_s = 0.2;
constexpr double kServoMemory = 5e-4;     ///< of a moving wall: what the steps summed up to goes on
constexpr double kLeastStiffness = 0.01;  ///< of an axis, over E: as the walls here
constexpr double kNormalDashpot = 1e-3;   ///< over the tangential one
constexpr int kRestCheck = 500, kRestSteps = 40000;
constexpr double kRestUnbalanced = 1e-3, kRestStress = 2e-3;

/// Sums up text.
class Script {
 public:
  template <class... Values>
  void operator()(fmt::format_string<Values...> line, Values&&... values) {
    fmt::format_to(std::back_inserter(text), line, std::forward<Values>(values)...);
    text += '\n';
  }
  std::string text;
};

void write_head(Script& out, const SizeBins& bins, const LammpsOptions& options) {
  out("# simulated: {}", options.title);
  out("# Written by triax for LAMMPS of 29 Sep 2021 with the packages GRANULAR and ASPHERE.");
  out("# Run it in the folder of its files:   mpirun -n 8 lmp -in THIS_FILE");
  out("# It writes {}.", options.table_file);
  out("#");
  out("# What differs from triax:");
  out("# - stiffness by {} bins of size: off by {:.2g} % (root mean square) and {:.2g} % at most "
      "over the contacts",
      bins.radius_m.size(), 100 * bins.stiffness_error_rms, 100 * bins.stiffness_error_most);
  out("# - contacts start without tangential forces; the grains settle first, with the stresses of "
      "the start held");
  out("# - local damping of forces only; turning is damped by tangential dashpots at contacts");
  out("# - walls under stress are held by a servo of its own; ends are looked for at rows only");
  out("# - kinetic energy of the instant; unbalanced (with the local damping) over the mean normal "
      "force");
  out("");
}

void write_setting(Script& out, const sim::GrainState& s, const LammpsOptions& options,
                   double smallest) {
  out("units si\natom_style sphere\nboundary s s s\nnewton off\ncomm_modify vel yes");
  out("read_data {}", options.data_file);
  out("timestep {}", s.time_step_s);
  out("neighbor {} bin", kSkin * smallest);
  out("neigh_modify delay 0 every 1 check yes");
}

/// Turning is damped by tangential dashpots of the damping ratio α/π, which takes of a vibration
/// what local damping does; a normal dashpot of next to nothing is there for them to refer to.
void write_contacts(Script& out, const sim::ContactLaw& law, const SizeBins& bins) {
  const auto mass = [&](double r) {
    return 4 * std::numbers::pi / 3 * law.density_kg_per_m3 * r * r * r;
  };
  out("\npair_style granular");
  for (std::size_t i = 0; i < bins.radius_m.size(); ++i)
    for (std::size_t j = i; j < bins.radius_m.size(); ++j) {
      const double ri = bins.radius_m[i], rj = bins.radius_m[j];
      const double stiffness = sim::normal_stiffness(law, ri, rj);
      const double reduced = mass(ri) * mass(rj) / (mass(ri) + mass(rj));
      const double damping = 2 * law.damping / std::numbers::pi * std::sqrt(stiffness / reduced);
      out("pair_coeff {} {} hooke {:.10g} {:.10g} tangential linear_history {:.10g} {} {:.10g} "
          "damping mass_velocity limit_damping",
          i + 1, j + 1, stiffness, damping * kNormalDashpot, law.tangential_ratio * stiffness,
          1 / kNormalDashpot, sim::friction_coefficient(law));
    }
}

/// Walls are forces on the grains near them. The box of axis a is L0 exp(-e) long about its middle.
void write_walls(Script& out, const sim::GrainState& s, double smallest) {
  out("\n# Walls");
  out("fix size all store/state 0 radius");
  out("variable kw equal {}", sim::wall_stiffness(s.law, 1.0));
  out("variable reach equal {}", kReach * smallest);
  out("variable s0 equal 0");
  for (int a = 0; a < 3; ++a) {
    const char x = kAxis[a];
    out("variable e{}0 equal 0.0\nvariable e{} equal v_e{}0", x, x, x);
    out("variable L{} equal \"{}*exp(-v_e{})\"", x, s.box.length_m(a), x);
    out("variable {}lo equal \"{}-0.5*v_L{}\"", x, 0.5 * (s.box.low_m[a] + s.box.high_m[a]), x);
    out("variable {0}hi equal \"v_{0}lo+v_L{0}\"", x);
    out("variable {0}near atom \"({0}-f_size-v_reach<v_{0}lo)||({0}+f_size+v_reach>v_{0}hi)\"", x);
    out("group at{0} dynamic all var {0}near every {1}", x, kWatchEvery);
    out("variable p{0}lo atom \"v_kw*f_size*(f_size>{0}-v_{0}lo)*(f_size-{0}+v_{0}lo)\"", x);
    out("variable p{0}hi atom \"v_kw*f_size*(f_size>v_{0}hi-{0})*(f_size-v_{0}hi+{0})\"", x);
    out("variable p{0} atom v_p{0}lo-v_p{0}hi", x);
    out("fix wall{0} at{0} addforce {1} {2} {3}", x, a == 0 ? "v_px" : "0.0",
        a == 1 ? "v_py" : "0.0", a == 2 ? "v_pz" : "0.0");
    out("compute w{0} at{0} reduce sum v_p{0}lo v_p{0}hi", x);
  }
  for (int a = 0; a < 3; ++a)
    out("variable s{0} equal \"0.5*(c_w{0}[1]+c_w{0}[2])/(v_L{1}*v_L{2})\"", kAxis[a],
        kAxis[(a + 1) % 3], kAxis[(a + 2) % 3]);
}

/// Local damping of forces, after all other forces are there.
void write_motion(Script& out, double damping) {
  if (damping > 0) {
    out("\n# Local damping of the forces\nvariable half equal 0.5*dt");
    for (const char x : std::string("xyz"))
      out("variable damp{0} atom "
          "\"-{1}*abs(f{0})*((v{0}+v_half*f{0}/mass>0)-(v{0}+v_half*f{0}/mass<0))\"",
          x, damping);
    out("fix damp all addforce v_dampx v_dampy v_dampz");
  }
  out("fix motion all nve/sphere");
}

void write_measures(Script& out, std::int64_t every) {
  out("\n# What is read off");
  out("compute moving all ke\ncompute turning all erotate/sphere");
  out("variable energy equal c_moving+c_turning");
  out("variable resultant atom sqrt(fx*fx+fy*fy+fz*fz)");
  out("compute resultants all reduce ave v_resultant");
  out("compute normal all pair/local force\ncompute normals all reduce sum c_normal");
  out("compute touching all contact/atom\ncompute touchings all reduce sum c_touching");
  out("variable unbalanced equal "
      "\"c_resultants*0.5*c_touchings/(abs(c_normals)+1.0e-30)\"");
  out("fix now all ave/time {0} 1 {0} v_ex v_ey v_ez v_sx v_sy v_sz v_energy v_unbalanced", every);
  out("variable s1 equal f_now[6]\nvariable s3 equal 0.5*(f_now[4]+f_now[5])");
  out("variable p equal (v_s1+2*v_s3)/3\nvariable q equal v_s1-v_s3");
  out("thermo_style custom step\nthermo_modify norm no lost error\nthermo {}", every);
}

double axis_stiffness(const sim::GrainState& s, int axis) {
  const auto& k = s.walls.stiffness_n_per_m;
  const double touching =
      0.25 * (k[2 * axis] + k[2 * axis + 1]) * s.box.length_m(axis) / s.box.area_m2(axis);
  return std::max(touching, kLeastStiffness * s.law.stiffness_over_diameter_pa);
}

/// Servo of the axes named: e grows in each step by d, what brings the stress to its goal, and by
/// `memory` of all d before, so that a wall that has to keep moving does not lag behind.
void write_servo(Script& out, const sim::GrainState& s, const std::string& axes, double memory) {
  std::string errors, steps;
  for (int a = 0; a < 3; ++a) {
    const char x = kAxis[a];
    const bool driven = axes.find(x) != std::string::npos;
    const double gain = kServoGain / axis_stiffness(s, a);
    const double limit = 2 * kWallSpeed_m_per_s * s.time_step_s / s.box.length_m(a);
    if (driven)
      out("variable d{0} equal \"{1:.10g}*(v_goal{0}-v_s{0})/(1+{2:.10g}*abs(v_goal{0}-v_s{0}))\"",
          x, gain, gain / limit);
    else
      out("variable d{} equal 0.0", x);
    out("variable r{0} equal \"v_d{0}+{1}*f_memory[{2}]*(step-v_s0)\"", x, memory, a + 1);
    errors += fmt::format(" v_d{}", x);
    steps += fmt::format(" v_r{}", x);
  }
  // The sums are read one step after they were made, when there are step − s0 terms in them.
  out("fix servo all ave/time 1 1 1{} ave running", steps);
  out("fix memory all ave/time 1 1 1{} ave running", errors);
  for (int a = 0; a < 3; ++a)
    if (axes.find(kAxis[a]) != std::string::npos)
      out("variable e{0} equal \"v_e{0}0+f_servo[{1}]*(step-v_s0)\"", kAxis[a], a + 1);
}

/// The strains reached are where the next drive starts from.
void write_hand_over(Script& out) {
  for (int a = 0; a < 3; ++a) out("variable e{}0 equal $(f_now[{}]:%.17g)", kAxis[a], a + 1);
  out("variable s0 equal $(step)");
  for (int a = 0; a < 3; ++a) out("variable e{0} equal v_e{0}0", kAxis[a]);
}

void write_rest(Script& out, const sim::GrainState& s, std::int64_t every) {
  out("\n# Rest: the stresses of the start are held until the grains are at rest without the "
      "tangential forces.");
  for (int a = 0; a < 3; ++a)
    out("variable goal{} equal {:.10g}", kAxis[a], sim::wall_stress(s.walls, s.box, a));
  write_servo(out, s, "xyz", 0);
  out("variable error equal \"abs(f_now[4]-v_goalx)+abs(f_now[5]-v_goaly)+abs(f_now[6]-v_goalz)\"");
  out("variable most equal {:.10g}",
      kRestStress * 3 * sim::mean_stress(sim::axisymmetric_stress(s)));
  const std::int64_t check = (kRestCheck + every - 1) / every * every;
  out("run 0 post no\nlabel rest\nrun {} pre no post no", check);
  out("if \"($(v_error) < $(v_most)) && ($(f_now[8]) < {})\" then \"jump SELF rested\"",
      kRestUnbalanced);
  out("if \"$(step) < {}\" then \"jump SELF rest\"", kRestSteps);
  out("label rested");
  out("print \"rest: $(step) steps, stresses $(f_now[4]) $(f_now[5]) $(f_now[6]) Pa, unbalanced "
      "$(f_now[8])\"");
  out("unfix servo\nunfix memory");
  write_hand_over(out);
}

void write_goals(Script& out, const sim::GrainPath& path, const std::string& axes) {
  for (const char x : axes) {
    const int a = x - 'x';
    if (path.kind != Kind::isotropic || !(path.stress_rate_pa_per_s > 0)) {
      out("variable goal{} equal {}", x, path.pressure_pa);
      continue;
    }
    out("variable from{} equal $(f_now[{}]:%.17g)", x, a + 4);
    out("variable way{0} equal {1}-v_from{0}", x, path.pressure_pa);
    out("variable risen{} equal \"{}*(step-v_s0)*dt\"", x, path.stress_rate_pa_per_s);
    out("variable goal{0} equal \"v_from{0}+v_way{0}*(v_risen{0}>=abs(v_way{0}))"
        "+v_risen{0}*(v_risen{0}<abs(v_way{0}))*((v_way{0}>0)-(v_way{0}<0))\"",
        x);
  }
}

void write_drives(Script& out, const sim::GrainState& s, const sim::GrainPath& path) {
  const std::string servoed = path.kind == Kind::isotropic ? "xyz"
                              : path.kind == Kind::drained ? "xy"
                                                           : "";
  write_goals(out, path, servoed);
  if (!servoed.empty()) write_servo(out, s, servoed, path.kind == Kind::drained ? kServoMemory : 0);
  for (int a = 0; a < 3; ++a) {
    if (servoed.find(kAxis[a]) != std::string::npos) continue;
    const double rate =
        a == sim::kAxial ? path.strain_rate_per_s : -0.5 / path.ratio * path.strain_rate_per_s;
    out("variable e{0} equal \"v_e{0}0+{1}*(step-v_s0)*dt\"", kAxis[a], rate);
  }
}

void write_row(Script& out, const LammpsOptions& options, double ratio) {
  out("variable t equal (step-v_s0)*dt");
  for (int a = 0; a < 3; ++a) out("variable n{0} equal f_now[{1}]-v_e{0}0", kAxis[a], a + 1);
  out("variable n3 equal 0.5*(v_nx+v_ny)");
  out("print \"{}\" file {} screen no", kLammpsColumns, options.table_file);
  out("label row");
  std::string row = "$(v_t:%.9g),$(v_nz:%.9g),$(v_n3:%.9g),$(v_nz+2*v_n3:%.9g)";
  for (const char* of : {"v_s1", "v_s3", "v_p", "v_q"}) row += fmt::format(",$({}/1000:%.9g)", of);
  row += fmt::format(",$((v_s1-v_s3/{})/1000:%.9g),$(f_now[7]:%.6g),$(f_now[8]:%.6g)", ratio);
  for (const char x : std::string("xyz")) row += fmt::format(",$(v_n{}:%.9g)", x);
  for (int a = 0; a < 3; ++a) row += fmt::format(",$(f_now[{}]/1000:%.9g)", a + 4);
  out("print \"{}\" append {} screen no", row, options.table_file);
}

/// Ends as GrainPath has them.
void write_ends(Script& out, const sim::GrainPath& path, std::int64_t every) {
  const auto end = [&](const std::string& where, const char* what) {
    out("if \"{}\" then \"print 'end: {}'\" \"jump SELF done\"", where, what);
  };
  end(fmt::format("$(step-v_s0) >= {}", path.most_steps), "the bound of steps");
  if (path.kind == Kind::isotropic) {
    const double most = path.pressure_share * path.pressure_pa;
    std::string where;
    for (int a = 0; a < 3; ++a)
      where += fmt::format("($(abs(f_now[{}]-{})) <= {}) && ", a + 4, path.pressure_pa, most);
    end(where + fmt::format("($(f_now[8]) <= {})", path.unbalanced), "at rest");
  } else {
    end(fmt::format("$(abs(v_nz)) >= {:.12g}", path.axial_strain * (1 - 1e-9)), "axial strain");
    end(fmt::format("$(v_p) < $({}*v_p0)", path.collapse_share), "collapse");
    if (path.stress_ratio)
      end(fmt::format("($(v_p) > 0) && ($(v_q) {} $({}*v_p))",
                      path.strain_rate_per_s < 0 ? "<=" : ">=", *path.stress_ratio),
          "stress ratio");
  }
  out("run {} pre no post no\njump SELF row\nlabel done", every);
}

/// Steps from row to row.
std::int64_t row_steps(const sim::GrainState& s, const sim::GrainPath& path) {
  if (path.kind == Kind::isotropic) return kRestCheck;
  const double time = path.axial_strain / std::abs(path.strain_rate_per_s) / path.samples;
  return std::max<std::int64_t>(1, std::llround(time / s.time_step_s));
}

}  // namespace

std::string lammps_script(const sim::GrainState& state, const sim::GrainPath& path,
                          const SizeBins& bins, const LammpsOptions& options) {
  const std::int64_t every = row_steps(state, path);
  const double smallest = std::ranges::min(state.grains, {}, &sim::Grain::radius).radius;
  Script out;
  write_head(out, bins, options);
  write_setting(out, state, options, smallest);
  write_contacts(out, state.law, bins);
  write_walls(out, state, smallest);
  write_motion(out, state.law.damping);
  write_measures(out, every);
  write_rest(out, state, every);
  out("\n# The path");
  write_drives(out, state, path);
  out("variable p0 equal $(v_p:%.17g)");
  out("run 0 post no");
  write_row(out, options, path.ratio);
  write_ends(out, path, every);
  return std::move(out.text);
}

}  // namespace triax::lab
