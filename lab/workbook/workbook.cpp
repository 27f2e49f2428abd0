// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/workbook/workbook.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/base/xml_stream.hpp"
#include "lab/records/dialect.hpp"

namespace triax::lab {
namespace {

constexpr std::size_t kMostSharedText = std::size_t{48} << 20;
/// No text of a cell is longer in any spreadsheet.
constexpr std::size_t kLongestSharedText = std::size_t{32767} * 4;
constexpr std::size_t kMostSheets = 1000;
constexpr std::size_t kMostStyles = 100'000;

void read_xml(const ZipArchive& archive, const std::string& part, XmlListener listener) {
  XmlStream stream(xml_of(archive, part), std::move(listener));
  while (stream.advance()) {
  }
}

/// The path of `target` as a part that `from` names.
std::string part_beside(const std::string& from, std::string_view target) {
  if (target.starts_with('/')) return std::string(target.substr(1));
  const auto slash = from.rfind('/');
  std::string folder = slash == std::string::npos ? "" : from.substr(0, slash + 1);
  while (target.starts_with("../") && !folder.empty()) {
    target.remove_prefix(3);
    const auto parent = folder.rfind('/', folder.size() - 2);
    folder = parent == std::string::npos ? "" : folder.substr(0, parent + 1);
  }
  return folder + std::string(target);
}

struct Relation {
  std::string type, part;
};

std::map<std::string, Relation> relations_of(const ZipArchive& archive, const std::string& part) {
  const auto slash = part.rfind('/');
  const std::string folder = slash == std::string::npos ? "" : part.substr(0, slash + 1);
  const std::string name = slash == std::string::npos ? part : part.substr(slash + 1);
  const std::string file = folder + "_rels/" + name + ".rels";
  std::map<std::string, Relation> all;
  if (!archive.has(file)) return all;
  read_xml(archive, file,
           {.start =
                [&](std::string_view element, XmlAttributes attributes) {
                  if (element != "Relationship" || all.size() > kMostSheets) return;
                  const std::string type(attributes["Type"]);
                  all[std::string(attributes["Id"])] = {type.substr(type.rfind('/') + 1),
                                                        part_beside(part, attributes["Target"])};
                },
            .end = {},
            .text = {}});
  return all;
}

}  // namespace

Workbook::Workbook(ZipArchive archive) : archive_(std::move(archive)) { read_parts(); }

void Workbook::read_parts() {
  constexpr const char* kTypes = "[Content_Types].xml";
  if (!archive_.has(kTypes))
    throw BadInput(
        name(), 0,
        archive_.has("content.xml")
            ? "an OpenDocument workbook (.ods): save it as .xlsx or CSV"
            : "a zip archive, not a workbook (.xlsx): unpack it and give the records in it");
  if (archive_.has_part_ending("vbaProject.bin"))
    throw BadInput(name(), 0,
                   "the workbook has macros, which triax does not accept: save it as .xlsx");
  std::string book = "xl/workbook.xml";
  for (const auto& [id, relation] : relations_of(archive_, ""))
    if (relation.type == "officeDocument") book = relation.part;
  if (book.ends_with(".bin") || archive_.has("xl/workbook.bin"))
    throw BadInput(name(), 0, "a binary workbook (.xlsb): save it as .xlsx or CSV");
  if (!archive_.has(book)) throw BadInput(name(), 0, "an Office document, not a workbook (.xlsx)");
  read_sheets(book);
  for (const auto& [id, relation] : relations_of(archive_, book)) {
    if (relation.type == "sharedStrings") read_shared_texts(relation.part);
    if (relation.type == "styles") read_styles(relation.part);
  }
}

void Workbook::read_sheets(const std::string& part) {
  const auto relations = relations_of(archive_, part);
  const auto start = [&](std::string_view element, XmlAttributes attributes) {
    if (element == "workbookPr")
      from_1904_ = attributes["date1904"] == "1" || attributes["date1904"] == "true";
    const bool hidden = attributes["state"].ends_with("idden");
    if (element != "sheet" || hidden || sheets_.size() >= kMostSheets) return;
    const auto relation = relations.find(std::string(attributes["id"]));
    if (relation != relations.end() && relation->second.type == "worksheet")
      sheets_.push_back({std::string(attributes["name"]), relation->second.part});
  };
  read_xml(archive_, part, {.start = start, .end = {}, .text = {}});
  if (sheets_.empty()) throw BadInput(name(), 0, "the workbook has no visible worksheet");
}

void Workbook::read_shared_texts(const std::string& part) {
  bool taken = false;
  int phonetic = 0;
  const auto start = [&](std::string_view element, XmlAttributes) {
    if (element == "rPh") ++phonetic;
    taken = element == "t" && phonetic == 0;
  };
  const auto end = [&](std::string_view element) {
    if (element == "rPh") --phonetic;
    if (element == "t") taken = false;
    if (element != "si") return;
    texts_.end_text();
    if (texts_.bytes() > kMostSharedText)
      throw BadInput(name(), 0,
                     "the workbook contains more than 48 MB of text; save its worksheet as CSV");
  };
  std::string clean;
  const auto text = [&](std::string_view piece) {
    if (!taken) return;
    if (texts_.pending_size() + piece.size() > kLongestSharedText)
      throw BadInput(name(), 0,
                     "a text that is too long for a spreadsheet; save the worksheet as CSV");
    clean.assign(piece);
    std::ranges::replace_if(
        clean, [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
    texts_.add(clean);
  };
  read_xml(archive_, part, {.start = start, .end = end, .text = text});
}

void Workbook::read_styles(const std::string& part) {
  std::map<int, CellStyle> formats;
  bool cells = false;
  const auto start = [&](std::string_view element, XmlAttributes attributes) {
    if (element == "cellXfs") cells = true;
    const auto id = whole_text_as<int>(attributes["numFmtId"]).value_or(0);
    if (element == "numFmt" && formats.size() < kMostStyles)
      formats[id] = style_of_format(attributes["formatCode"]);
    if (element != "xf" || !cells || styles_.size() >= kMostStyles) return;
    const auto own = formats.find(id);
    styles_.push_back(own == formats.end() ? style_of_builtin(id) : own->second);
  };
  const auto end = [&](std::string_view element) {
    if (element == "cellXfs") cells = false;
  };
  read_xml(archive_, part, {.start = start, .end = end, .text = {}});
}

const SheetEntry& Workbook::sheet(const std::string& wanted) const {
  for (const SheetEntry& entry : sheets_)
    if (matches_name(entry.name, wanted)) return entry;
  std::vector<std::string> names;
  for (const SheetEntry& entry : sheets_) names.push_back(excerpt(entry.name));
  throw BadInput(
      name(), 0,
      fmt::format("no worksheet {}; must be one of: {}", excerpt(wanted), joined(names)));
}

std::optional<std::string_view> Workbook::shared_text(std::size_t index) const {
  return texts_.at(index);
}

CellStyle Workbook::style(std::size_t index) const {
  return index < styles_.size() ? styles_[index] : CellStyle::number;
}

bool looks_like_workbook(ByteSource& source) {
  std::array<char, 8> begin{};
  source.rewind();
  const auto count = source.read(begin);
  source.rewind();
  const std::string_view bytes(begin.data(), count);
  return bytes.starts_with("PK\3\4") || bytes.starts_with("PK\5\6");
}

}  // namespace triax::lab
