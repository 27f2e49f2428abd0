// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Stages of a record of raw channels that has no stage column, from its readings.
#include <cstdint>
#include <span>
#include <vector>

#include "lab/records/table_reader.hpp"
#include "lab/results/record_header.hpp"

namespace triax::lab {

/// Collects the rows of a record, at most kSamples of them at equal distances, and splits them into
/// stages at two kinds of rows:
///
/// 1. Shear begins with the last row without a deviator load. If the cell pressure still increases
///    under that load with the drainage open, it begins where that ends. A held q begins where q
///    becomes constant while the cell pressure or the back pressure changes.
/// 2. The drainage opens or closes. With the drainage closed no water flows: the measured volume
///    change f of a stretch of rows is zero. With the drainage open the pore pressure follows the
///    back pressure: the volume w that a change of u − u_b would drive out, Δ(u − u_b)/K with K =
///    kBulk p′, is zero. A stretch that is called closed costs f, one that is called open costs w,
///    and each stretch costs kChange times the smallest volume that counts. The rows are split
///    into the stretches that together cost least.
class StageSplit {
 public:
  static constexpr std::size_t kSamples = 1024;
  /// Drained bulk modulus over p′: of sand in unloading 50 to 200. Twice or half of it changes no
  /// drainage where f/(f + w) is below 1/5 or above 4/5.
  static constexpr double kBulk = 100;
  static constexpr double kChange = 2;

  struct Stage {
    std::int64_t line = 0;                  ///< of its first row
    StageRole role = StageRole::unknown;    ///< shear or consolidation; unknown: before shear
    Drainage drainage = Drainage::unknown;  ///< unknown: neither f nor w shows it
    AxialControl control = AxialControl::unknown;
  };

  /// The next row. Rows come in the order of the file.
  void add(const Row& row);
  /// At least one stage. A record that begins with shear and does not change its drainage has one.
  std::vector<Stage> stages(const SpecimenInfo& specimen) const;

 private:
  struct Sample {
    std::int64_t line = 0;
    double force = kMissing, cell = kMissing, pore = kMissing, back = kMissing, volume = kMissing;
  };

  std::vector<Sample> samples_;
  std::int64_t rows_ = 0, stride_ = 1;
  Sample last_;
};

}  // namespace triax::lab
