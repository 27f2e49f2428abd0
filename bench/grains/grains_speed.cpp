// SPDX-License-Identifier: GPL-3.0-or-later
// grains_speed STATE [THREADS [STEPS [REPEATS [portable]]]]
//   particle-steps per second of the engine on a packing, as "triax THREADS PARTICLE_STEPS_PER_S"
//   (median of the repeats); details on lines with #.
// grains_speed make STATE [GRAINS]
//   makes such a packing: isotropic, 100 kPa.
// grains_speed shared STATE [STEPS [ROUNDS]]
//   one thread and two in turn, beside no, one and two busy processes that it starts itself, as
//   "shared BUSY ONE TWO RATIO LEAST MOST": medians over the rounds, and of two over one in the
//   same round its median, least and most. What else the machine does meanwhile disturbs both
//   alike.
// STATE: "N lox hix loy hiy loz hiz", then "x y z r" for each grain, in metres.
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <random>
#include <string>
#include <vector>

#include "bench/grains/busy_processes.hpp"
#include "sim/grains/engine/grains.hpp"
#include "sim/grains/state/grain_measures.hpp"
#include "sim/mechanics/axisymmetric.hpp"

using namespace triax::sim;

namespace {

constexpr double kStress = 1e5;
constexpr double kTimeStep = 1.5e-6;

GrainState read_state(const std::string& path) {
  std::ifstream in(path);
  std::size_t count = 0;
  GrainBox box;
  in >> count;
  for (int a = 0; a < 3; ++a) in >> box.low_m[a] >> box.high_m[a];
  std::vector<Sphere> spheres(in ? count : 0);
  for (Sphere& s : spheres) in >> s.centre_m[0] >> s.centre_m[1] >> s.centre_m[2] >> s.radius_m;
  if (!in || spheres.empty()) {
    std::fprintf(stderr, "%s: not a packing\n", path.c_str());
    std::exit(2);
  }
  return make_grain_state(spheres, box, ContactLaw{}, kTimeStep);
}

void write_state(const std::string& path, const GrainState& state) {
  std::ofstream out(path);
  out << std::setprecision(15) << state.grains.size();
  for (int a = 0; a < 3; ++a) out << ' ' << state.box.low_m[a] << ' ' << state.box.high_m[a];
  for (const Sphere& s : spheres_of(state))
    out << '\n'
        << s.centre_m[0] << ' ' << s.centre_m[1] << ' ' << s.centre_m[2] << ' ' << s.radius_m;
  out << '\n';
}

/// Diameter at the share p of the number of grains, 2 to 9.5 mm.
double diameter_m(double p) {
  constexpr std::array<double, 8> kShare{0, 0.09, 0.25, 0.5, 0.69, 0.9, 0.95, 1};
  constexpr std::array<double, 8> kSize{2, 3, 4, 5, 6, 7, 8, 9.5};
  std::size_t k = 1;
  while (k < 7 && p > kShare[k]) ++k;
  return 1e-3 *
         std::lerp(kSize[k - 1], kSize[k], (p - kShare[k - 1]) / (kShare[k] - kShare[k - 1]));
}

/// Grains on a lattice of the largest size, shaken and compressed with little friction.
GrainState make_packing(int count) {
  constexpr double kSpacing = 9.6e-3;
  std::mt19937_64 random(1);
  const auto uniform = [&] { return static_cast<double>(random() >> 11U) * 0x1p-53; };
  std::vector<double> diameters(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) diameters[i] = diameter_m((i + 0.5) / count);
  for (int i = count - 1; i > 0; --i)
    std::swap(diameters[i], diameters[random() % static_cast<unsigned>(i + 1)]);
  const int side = static_cast<int>(std::ceil(std::cbrt(count)));
  std::vector<Sphere> spheres;
  for (int i = 0; i < count; ++i)
    spheres.push_back({{kSpacing * (i % side + 0.5), kSpacing * (i / side % side + 0.5),
                        kSpacing * (i / side / side + 0.5)},
                       0.5 * diameters[i]});
  const double length = kSpacing * side;
  ContactLaw law;
  law.friction_angle = radians(5);
  GrainState state = make_grain_state(spheres, {{0, 0, 0}, {length, length, length}}, law);
  for (Grain& g : state.grains)
    for (double& v : g.velocity) v = 2 * uniform() - 1;
  Grains grains(state, 2);
  grains.set_margin({1e-3, 1e-4});
  const AxisDrive drive = stress_drive(kStress, 0.4);
  grains.drive({drive, drive, drive});
  GrainMeasures m;
  do {
    if (grains.step(2000) < 2000 || grains.state().steps > 1000000) {
      std::fprintf(stderr, "the packing does not come to rest\n");
      std::exit(1);
    }
    m = measure(grains.state());
  } while (m.unbalanced > 1e-3 || m.wall_stress_pa[0] < 0.99 * kStress ||
           m.wall_stress_pa[1] < 0.99 * kStress || m.wall_stress_pa[2] < 0.99 * kStress);
  std::printf("# made in %ld steps: n %.4f, Z %.3f, %ld float, %ld outside\n",
              static_cast<long>(grains.state().steps), m.porosity, m.coordination,
              static_cast<long>(m.floating_grains), static_cast<long>(m.grains_outside));
  return grains.state();
}

double seconds() {
  using Clock = std::chrono::steady_clock;
  return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

void print_details(const GrainState& s) {
  const GrainMeasures m = measure(s);
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::printf(
      "# stress %.5g %.5g %.5g Pa, unbalanced %.3g, n %.5f, Z %.4f, contacts %ld, near %zu, ",
      m.wall_stress_pa[0], m.wall_stress_pa[1], m.wall_stress_pa[2], m.unbalanced, m.porosity,
      m.coordination, static_cast<long>(m.grain_contacts), s.neighbours.near.size());
  std::printf("listed %zu, sliding %ld, outside %ld, %.1f MiB\n", s.neighbours.listed_i.size(),
              static_cast<long>(m.sliding_contacts), static_cast<long>(m.grains_outside),
              static_cast<double>(usage.ru_maxrss) / 1024);
}

GrainState strained(const GrainState& state) {
  Grains grains(state);
  grains.drive({stress_drive(kStress), strain_rate_drive(0.05), stress_drive(kStress)});
  grains.step(500);
  return grains.state();
}

/// Particle-steps per second of some steps.
double rate_of(Grains& grains, std::int64_t steps) {
  const double start = seconds();
  grains.step(steps);
  return static_cast<double>(steps) * static_cast<double>(grains.state().grains.size()) /
         (seconds() - start);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// One engine lives at a time, so that no thread is there when processes are started.
void compare_shared(const GrainState& state, std::int64_t steps, int rounds) {
  std::array<std::array<std::vector<double>, 2>, 3> rates;
  std::array<std::vector<double>, 3> ratios;
  for (int round = 0; round < rounds; ++round)
    for (int busy = 0; busy < 3; ++busy) {
      const triax::bench::BusyProcesses others(busy);
      for (int threads = 1; threads <= 2; ++threads) {
        Grains grains(state, threads);
        grains.step(steps / 10);
        rates[busy][threads - 1].push_back(rate_of(grains, steps));
      }
      ratios[busy].push_back(rates[busy][1].back() / rates[busy][0].back());
    }
  std::printf("# busy processes, particle-steps/s on one thread and two, two over one: median, ");
  std::printf("least, most of %d\n", rounds);
  for (int busy = 0; busy < 3; ++busy) {
    const auto [least, most] = std::minmax_element(ratios[busy].begin(), ratios[busy].end());
    std::printf("shared %d %.4g %.4g %.2f %.2f %.2f\n", busy, median(rates[busy][0]),
                median(rates[busy][1]), median(ratios[busy]), *least, *most);
  }
}

void time_steps(Grains& grains, int threads, std::int64_t steps, int repeats) {
  std::vector<double> rates;
  for (int r = 0; r < repeats; ++r) {
    const std::int64_t sorts = grains.state().sorts;
    rates.push_back(rate_of(grains, steps));
    std::printf("# repeat %d: %.4g, sorted %ld times\n", r, rates.back(),
                static_cast<long>(grains.state().sorts - sorts));
  }
  print_details(grains.state());
  std::printf("# best %.4g\ntriax %d %.4g\n", *std::max_element(rates.begin(), rates.end()),
              threads, median(rates));
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> args(argv + 1, argv + argc);
  const auto number = [&](std::size_t k, int otherwise) {
    return k < args.size() ? std::atoi(args[k].c_str()) : otherwise;
  };
  if (args.empty()) return 2;
  if (args[0] == "make") {
    if (args.size() < 2) return 2;
    write_state(args[1], make_packing(number(2, 10000)));
    return 0;
  }
  if (args[0] == "shared") {
    if (args.size() < 2) return 2;
    compare_shared(strained(read_state(args[1])), number(2, 2000), std::max(1, number(3, 7)));
    return 0;
  }
  const int threads = number(1, 1);
  const bool portable = args.size() > 4 && args[4] == "portable";
  Grains grains(strained(read_state(args[0])), threads,
                portable ? InstructionSet::portable : best_instruction_set());
  time_steps(grains, threads, number(2, 3000), number(3, 5));
  return 0;
}
