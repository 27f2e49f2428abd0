// grains_speed STATE [THREADS [STEPS [REPEATS [portable|avx2]]]]: particle-steps per second of the
// engine on a packing, as "triax THREADS PARTICLE_STEPS_PER_S" (median), detail on lines with #.
// STATE: "N lox hix loy hiy loz hiz", then "x y z r" for each grain, in metres.
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "sim/grains/grain_measures.hpp"
#include "sim/grains/grains.hpp"

using namespace triax::sim;

namespace {

GrainState read_state(const std::string& path, double time_step_s) {
  std::ifstream in(path);
  std::size_t count = 0;
  GrainBox box;
  in >> count;
  for (int a = 0; a < 3; ++a) in >> box.low_m[a] >> box.high_m[a];
  std::vector<Sphere> spheres(count);
  for (Sphere& s : spheres) in >> s.centre_m[0] >> s.centre_m[1] >> s.centre_m[2] >> s.radius_m;
  if (!in) {
    std::fprintf(stderr, "%s: not a packing\n", path.c_str());
    std::exit(2);
  }
  return make_grain_state(spheres, box, ContactLaw{}, time_step_s);
}

double seconds() {
  using Clock = std::chrono::steady_clock;
  return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const int threads = argc > 2 ? std::atoi(argv[2]) : 1;
  const long steps = argc > 3 ? std::atol(argv[3]) : 2000;
  const int repeats = argc > 4 ? std::atoi(argv[4]) : 5;
  const bool portable = argc > 5 && std::string(argv[5]) == "portable";
  Grains grains(read_state(argv[1], 1.5e-6), threads,
                portable ? InstructionSet::portable : best_instruction_set());
  grains.drive({stress_drive(1e5), strain_rate_drive(0.05), stress_drive(1e5)});
  grains.step(500);
  std::vector<double> rates;
  for (int r = 0; r < repeats; ++r) {
    const std::int64_t sorts = grains.state().sorts;
    const double start = seconds();
    grains.step(steps);
    const double rate = static_cast<double>(grains.state().grains.size()) *
                        static_cast<double>(steps) / (seconds() - start);
    std::printf("# repeat %d: %.4g, sorts %ld\n", r, rate,
                static_cast<long>(grains.state().sorts - sorts));
    rates.push_back(rate);
  }
  const GrainMeasures m = measure(grains.state());
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::printf("# stress %.5g %.5g %.5g Pa, unbalanced %.3g, n %.5f, Z %.4f, listed %zu, near %zu, ",
              m.wall_stress_pa[0], m.wall_stress_pa[1], m.wall_stress_pa[2], m.unbalanced,
              m.porosity, m.coordination, grains.state().neighbours.listed_i.size(),
              grains.state().neighbours.near.size());
  std::printf("contacts %ld, sliding %ld, %.1f MiB\n", static_cast<long>(m.grain_contacts),
              static_cast<long>(m.sliding_contacts), static_cast<double>(usage.ru_maxrss) / 1024);
  std::sort(rates.begin(), rates.end());
  std::printf("triax %d %.4g\n", threads, rates[rates.size() / 2]);
  return 0;
}
