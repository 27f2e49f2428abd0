// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Normal form of a heading, by the rules of lab/intake/lexicon/normalise.toml. Names of the lexicon
// and headings of files are compared in this form.
#include <QString>
#include <string_view>
#include <vector>

namespace triax::lab {

/// A heading with broken encodings, look-alike characters and combining accents replaced. The other
/// functions take such a text.
QString repair_heading(std::string_view utf8);
/// In lower case and without accents.
QString fold_heading(const QString& repaired);
/// Words and signs in lower case, without accents, plural and abbreviations: "Cell_Press." is
/// "cell", "pressure".
std::vector<QString> heading_tokens(const QString& repaired);
/// The tokens without spaces between them. Headings with equal keys have the same meaning.
QString heading_key(const QString& repaired);
/// Keys of a listed name. A name with umlauts has two: "Höhe" is "hohe" and "hoehe".
std::vector<QString> name_keys(std::string_view name);

/// True for a Chinese, Japanese or Korean character. These scripts have no spaces between words.
bool is_east_asian(QChar character);
/// True for a space and for an underscore.
bool is_heading_blank(QChar character);
/// Without these characters at both ends.
QString without_outer(const QString& text, QStringView characters);

}  // namespace triax::lab
