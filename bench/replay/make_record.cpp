// SPDX-License-Identifier: GPL-3.0-or-later
// bench_make_record ROWS OUT.csv: writes the synthetic record.
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "bench/replay/synthetic_record.hpp"

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: bench_make_record ROWS OUT.csv\n", stderr);
    return 2;
  }
  const long rows = std::atol(argv[1]);
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(argv[2], "w"),
                                                             &std::fclose);
  if (!file || rows < 2) return 2;
  std::fputs(
      "time_s,axial_displacement_mm,axial_force_kN,cell_pressure_kPa,back_pressure_kPa,"
      "pore_pressure_kPa,back_volume_mm3\n",
      file.get());
  triax::bench::SyntheticRecord record(rows);
  for (long i = 0; i < rows; ++i) {
    const auto r = record.row(i);
    std::fprintf(file.get(), "%.1f,%.4f,%.6f,%.3f,%.3f,%.3f,%.1f\n", r.time_s, r.displacement_mm,
                 r.force_kN, r.cell_kPa, r.back_kPa, r.pore_kPa, r.volume_mm3);
  }
  return 0;
}
