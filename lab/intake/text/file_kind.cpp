// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/intake/text/file_kind.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"

namespace triax::lab {
namespace {

using namespace std::string_view_literals;

constexpr const char* kUnpack = "unpack it and give the records in it";
constexpr const char* kExport = "export the readings as CSV from the software that wrote it";
constexpr const char* kMatlab = "write the readings with writetable as CSV";
constexpr const char* kPaper = "ask for the readings as CSV or as a workbook (.xlsx)";

/// Bytes at a place by which a binary format is known.
struct Signature {
  std::string_view bytes;
  std::size_t at;
  const char* name;
  const char* remedy;
};

constexpr std::array kSignatures{
    Signature{"%PDF-"sv, 0, "a PDF document", kPaper},
    Signature{R"({\rtf)"sv, 0, "an RTF document", kPaper},
    Signature{"\x89PNG\r\n"sv, 0, "an image (PNG)", kPaper},
    Signature{"\xFF\xD8\xFF"sv, 0, "an image (JPEG)", kPaper},
    Signature{"GIF8"sv, 0, "an image (GIF)", kPaper},
    Signature{"II*\0"sv, 0, "an image (TIFF)", kPaper},
    Signature{"MM\0*"sv, 0, "an image (TIFF)", kPaper},
    Signature{"WEBP"sv, 8, "an image (WebP)", kPaper},
    Signature{"\0\0\0\0"sv, 6, "an image (BMP)", kPaper},  // with "BM", see has_signature
    Signature{"\x1F\x8B"sv, 0, "a gzip archive", kUnpack},
    Signature{"1AY&SY"sv, 4, "a bzip2 archive", kUnpack},
    Signature{"\xFD"
              "7zXZ\0"sv,
              0, "an xz archive", kUnpack},
    Signature{"\x28\xB5\x2F\xFD"sv, 0, "a Zstandard archive", kUnpack},
    Signature{"7z\xBC\xAF\x27\x1C"sv, 0, "a 7-Zip archive", kUnpack},
    Signature{"Rar!\x1A\x07"sv, 0, "a RAR archive", kUnpack},
    Signature{"ustar"sv, 257, "a tar archive", kUnpack},
    Signature{"PAR1"sv, 0, "a Parquet file", "write the table as CSV"},
    Signature{"ARROW1"sv, 0, "an Arrow file", "write the table as CSV"},
    Signature{"FEA1"sv, 0, "a Feather file", "write the table as CSV"},
    Signature{"\x93NUMPY"sv, 0, "a NumPy array", "write the table as CSV"},
    Signature{"\x89HDF\r\n\x1A\n"sv, 0, "an HDF5 file", "write the readings in it as CSV"},
    Signature{"CDF\1"sv, 0, "a NetCDF file", "write the readings in it as CSV"},
    Signature{"CDF\2"sv, 0, "a NetCDF file", "write the readings in it as CSV"},
    Signature{"MATLAB 5.0 MAT-file"sv, 0, "a MATLAB file (.mat)", kMatlab},
    Signature{"MATLAB 7.3 MAT-file"sv, 0, "a MATLAB file (.mat)", kMatlab},
    Signature{"SQLite format 3\0"sv, 0, "an SQLite database",
              "use it with --db if triax wrote it, else export the readings as CSV"},
    Signature{"TDSm"sv, 0, "a TDMS file of LabVIEW", kExport},
    Signature{"\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1"sv, 0, "an .xls file or an encrypted workbook",
              "save it as .xlsx without a password, or as CSV"},
    Signature{"\x09\x08\x10\0"sv, 0, "an .xls file", "save it as .xlsx or as CSV"},
    Signature{"\x7F"
              "ELF"sv,
              0, "a program", "give the file with the readings"},
    Signature{"MZ\x90\0"sv, 0, "a program", "give the file with the readings"}};

bool has_signature(std::string_view bytes, const Signature& one) {
  constexpr std::string_view kBmp = "BM";
  if (bytes.size() < one.at || !bytes.substr(one.at).starts_with(one.bytes)) return false;
  return one.at != 6 || bytes.starts_with(kBmp);
}

/// A zip archive by the name of its first part: those of a workbook are left to its reader.
std::optional<FileKind> find_zip(std::string_view bytes) {
  constexpr std::size_t kNameLength = 26;
  constexpr std::size_t kName = 30;
  constexpr std::array kOfWorkbooks{"[Content_Types].xml", "_rels/",   "xl/",
                                    "docProps/",           "mimetype", "customXml/",
                                    "content.xml",         "META-INF/"};
  if (!bytes.starts_with("PK\3\4") || bytes.size() < kName) return std::nullopt;
  const std::size_t length = static_cast<unsigned char>(bytes[kNameLength]) +
                             256U * static_cast<unsigned char>(bytes[kNameLength + 1]);
  const auto name = bytes.substr(kName, length);
  if (std::ranges::any_of(kOfWorkbooks, [&](const char* one) { return name.starts_with(one); }))
    return std::nullopt;
  return FileKind{fmt::format("a zip archive with {}", excerpt(name)), kUnpack};
}

std::optional<FileKind> find_markup(std::string_view text) {
  const std::string lower = folded(text);
  if (lower.starts_with("<!doctype html") || lower.starts_with("<html") ||
      lower.starts_with("<table"))
    return FileKind{"a web page (HTML)",
                    "open it in a spreadsheet program and save it as .xlsx or CSV"};
  const bool is_xml = lower.starts_with("<?xml") || lower.starts_with("<!--") ||
                      (lower.size() > 2 && lower[0] == '<' && lower[1] >= 'a' && lower[1] <= 'z' &&
                       lower.find("xmlns") != std::string::npos);
  if (!is_xml && !lower.starts_with("<diggs")) return std::nullopt;
  if (lower.find("diggs") != std::string::npos)
    return FileKind{"a DIGGS file (XML)", "ask for the readings as CSV, or for results as AGS4"};
  if (lower.find("excel.sheet") != std::string::npos ||
      lower.find("office:spreadsheet") != std::string::npos)
    return FileKind{"an XML spreadsheet of Excel 2003", "save it as .xlsx or CSV"};
  return FileKind{"an XML file", kExport};
}

/// An object with a key, or a list of objects, lists, texts or numbers. "[Data]" is a section.
bool is_json(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const auto next = text.find_first_not_of(kBlanks, 1);
  if (next == std::string_view::npos) return false;
  if (text.front() == '{') return text[next] == '"' || text[next] == '}';
  if (text.front() != '[') return false;
  if (text[next] == '{' || text[next] == '[' || text[next] == '"') return true;
  const auto end = text.find_first_not_of("0123456789.eE+-", next);
  return end != next && end != std::string_view::npos &&
         text.find_first_not_of(kBlanks, end) != std::string_view::npos &&
         text[text.find_first_not_of(kBlanks, end)] == ',';
}

std::optional<FileKind> find_text_kind(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  if (text.empty()) return std::nullopt;
  if (text.front() == '<') return find_markup(text);
  if (is_json(text)) return FileKind{"a JSON file", kExport};
  if (text.starts_with("#GEFID"))
    return FileKind{"a GEF file", "write the readings as CSV with a line of headings"};
  if (begins_ags3(text))
    return FileKind{"an AGS 3 file (its groups begin with **)", "request the delivery as AGS4"};
  return std::nullopt;
}

}  // namespace

std::optional<FileKind> find_file_kind(std::string_view first) {
  first = first.substr(0, kFileKindBytes);
  const auto* const found = std::ranges::find_if(
      kSignatures, [&](const Signature& one) { return has_signature(first, one); });
  if (found != kSignatures.end()) return FileKind{found->name, found->remedy};
  if (auto zip = find_zip(first)) return zip;
  for (const std::string_view mark : {"\xEF\xBB\xBF"sv, "\xFF\xFE"sv, "\xFE\xFF"sv})
    if (first.starts_with(mark)) first.remove_prefix(mark.size());
  std::string text(first);
  std::erase(text, '\0');  // UTF-16
  return find_text_kind(text);
}

void refuse_other_kinds(ByteSource& source) {
  std::string first(kFileKindBytes, '\0');
  source.rewind();
  std::size_t taken = 0;
  while (const auto count = source.read({first.data() + taken, first.size() - taken}))
    taken += count;
  source.rewind();
  first.resize(taken);
  if (const auto kind = find_file_kind(first))
    throw BadInput(
        source.name(), 0,
        fmt::format("this is {}, not a table of readings: {}", kind->name, kind->remedy));
}

bool begins_ags3(std::string_view line) {
  line = trimmed(line);
  constexpr std::size_t kNameEnd = 6;  // of "**PROJ" without quotes
  const bool is_quoted = line.starts_with('"');
  if (is_quoted) line.remove_prefix(1);
  if (!line.starts_with("**") || line.size() < kNameEnd) return false;
  const auto name = line.substr(2, kNameEnd - 2);
  return std::ranges::all_of(name, [](char c) { return c >= 'A' && c <= 'Z'; }) &&
         (is_quoted || line.size() == kNameEnd || line[kNameEnd] == ',' || line[kNameEnd] == '\n' ||
          line[kNameEnd] == '\r');
}

}  // namespace triax::lab
