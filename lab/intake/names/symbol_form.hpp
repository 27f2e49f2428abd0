// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QString>
#include <vector>

namespace triax::lab {

/// Symbols that a heading of repair_heading() can be: "ev" is "εv" and "ε1", "(s1-s3)/2" is
/// "σ1-σ3/2". Empty for a heading that is neither a symbol nor an expression of symbols. The rules
/// are in section 7 of lab/intake/lexicon/normalise.toml.
std::vector<QString> symbol_readings(const QString& repaired);

}  // namespace triax::lab
