// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/diggs/diggs_document.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/base/xml_stream.hpp"

namespace triax::lab {
namespace {

constexpr std::uint64_t kMaxDiggsBytes = std::uint64_t{256} << 20;
constexpr std::size_t kMaxElementText = std::size_t{1} << 20;

/// An element that is open.
struct OpenElement {
  std::string name;
  std::string uom, id, href, title;
  std::string dimension;  ///< srsDimension, its own or of the element around it
  std::int64_t line = 0;
  std::string text;
};

/// "#a" and "a" refer to the same id.
std::string id_of(std::string_view href) {
  if (href.starts_with('#')) href.remove_prefix(1);
  return std::string(href);
}

class DiggsReader {
 public:
  explicit DiggsReader(ByteSource& source)
      : stream_({.name = source.name(),
                 .read = [&source](std::span<char> into) { return source.read(into); },
                 .kind = "DIGGS file",
                 .remedy = "export it again",
                 .has_lines = true},
                {.start = [this](std::string_view name, XmlAttributes a) { start(name, a); },
                 .end = [this](std::string_view) { end(); },
                 .text = [this](std::string_view piece) { add_text(piece); }}) {
    document_.file = source.name();
  }

  DiggsDocument read() {
    while (stream_.advance()) {
    }
    for (DiggsTest& test : document_.tests) resolve(test);
    return std::move(document_);
  }

 private:
  void start(std::string_view name, XmlAttributes attributes);
  void begin_object(const OpenElement& element, std::string_view parent, XmlAttributes attributes);
  void begin_in_test(const OpenElement& element, XmlAttributes attributes);
  void refer(const OpenElement& element, std::string_view parent);
  void end();
  void add_text(std::string_view piece);
  void take(OpenElement& element, std::string_view parent);
  void take_name(const OpenElement& element, std::string_view parent);
  void take_of_test(OpenElement& element, std::string_view parent);
  void take_of_specimen(OpenElement& element, std::string_view parent);
  void take_of_result_set(OpenElement& element, std::string_view parent);
  void take_of_parameter(const OpenElement& element);
  void take_of_trial(OpenElement& element, std::string_view parent);
  void resolve(DiggsTest& test) const;

  bool is_within(std::string_view name) const {
    return std::ranges::find(open_, name, &OpenElement::name) != open_.end();
  }
  /// The element `up` levels above the innermost open one; empty where there is none.
  std::string_view above(std::size_t up) const {
    return up < open_.size() ? std::string_view(open_[open_.size() - 1 - up].name)
                             : std::string_view();
  }
  std::string name_of(const std::string& id) const {
    const auto found = names_.find(id);
    return found == names_.end() ? id : found->second;
  }

  DiggsDocument document_;
  std::vector<OpenElement> open_;
  std::optional<DiggsTest> test_;
  std::map<std::string, std::string, std::less<>> names_;    ///< of features, by id
  std::map<std::string, std::string, std::less<>> clients_;  ///< of projects, by id
  bool is_client_ = false;                                   ///< the role that is open
  XmlStream stream_;
};

void DiggsReader::start(std::string_view name, XmlAttributes attributes) {
  const std::string parent = open_.empty() ? std::string() : open_.back().name;
  OpenElement element{.name = std::string(name),
                      .uom = std::string(attributes["uom"]),
                      .id = std::string(attributes["id"]),
                      .href = id_of(attributes["href"]),
                      .title = std::string(attributes["title"]),
                      .dimension = std::string(attributes["srsDimension"]),
                      .line = stream_.line(),
                      .text = {}};
  if (element.dimension.empty() && !open_.empty()) element.dimension = open_.back().dimension;
  begin_object(element, parent, attributes);
  refer(element, parent);
  open_.push_back(std::move(element));
}

void DiggsReader::begin_object(const OpenElement& element, std::string_view parent,
                               XmlAttributes attributes) {
  if (element.name == "Role") is_client_ = false;
  if (element.name == "Test" && parent == "measurement") {
    test_.emplace();
    test_->line = element.line;
    test_->id = element.id;
  } else if (parent == "procedure" && element.name != "TriaxialTest") {
    ++document_.other_procedures[element.name];
  } else if (test_) {
    begin_in_test(element, attributes);
  }
}

void DiggsReader::begin_in_test(const OpenElement& element, XmlAttributes attributes) {
  DiggsTest& test = *test_;
  if (element.name == "TriaxialTest") {
    test.has_procedure = true;
  } else if (element.name == "SoilSpecimen" || element.name == "RockSpecimen") {
    test.specimens.emplace_back().id = element.id;
  } else if (element.name == "TriaxialTestTrial") {
    test.trials.emplace_back().line = element.line;
  } else if (element.name == "ResultSet") {
    test.result_sets.emplace_back().line = element.line;
  } else if (element.name == "Property" && !test.result_sets.empty()) {
    test.result_sets.back().properties.emplace_back();
  } else if (element.name == "Parameter") {
    test.parameters.emplace_back().line = element.line;
  } else if (element.name == "ShearingIncrement" && !test.trials.empty()) {
    test.trials.back().shearing.emplace_back().line = element.line;
  } else if ((element.name == "ConsolidationIncrement" ||
              element.name == "BackPressureIncrement") &&
             !test.trials.empty()) {
    ++test.trials.back().other_increments;
  } else if (element.name == "dataValues" && !test.result_sets.empty()) {
    DiggsResultSet& set = test.result_sets.back();
    const auto mark = [&](const char* name, std::string& into) {
      if (const auto value = attributes[name]; !value.empty()) into = value;
    };
    mark("cs", set.cell_separator);
    mark("ts", set.tuple_separator);
    mark("decimal", set.decimal_mark);
    set.line = element.line;
  }
}

/// References are attributes of elements that may be empty.
void DiggsReader::refer(const OpenElement& element, std::string_view parent) {
  if (!test_) return;
  const auto& to = element.href.empty() ? element.title : element.href;
  if (element.name == "specimenRef" && !test_->trials.empty())
    test_->trials.back().specimen = element.href;
  else if (element.name == "sampleRef" && parent == "SoilSpecimen")
    test_->specimens.back().sample = element.title.empty() ? element.href : element.title;
  else if (parent != "Test")
    return;
  else if (element.name == "projectRef")
    test_->project = to;
  else if (element.name == "samplingFeatureRef")
    test_->location = to;
  else if (element.name == "sampleRef")
    test_->sample = element.title.empty() ? element.href : element.title;
}

void DiggsReader::add_text(std::string_view piece) {
  if (open_.empty()) return;
  OpenElement& element = open_.back();
  if (element.name != "dataValues" && element.text.size() + piece.size() > kMaxElementText)
    throw BadInput(
        document_.file, stream_.line(),
        fmt::format("the text of element {} is longer than 1 MB", excerpt(element.name)));
  element.text += piece;
}

void DiggsReader::end() {
  OpenElement element = std::move(open_.back());
  open_.pop_back();
  const std::string parent = open_.empty() ? std::string() : open_.back().name;
  if (element.name == "Test" && test_) {
    if (test_->has_procedure) document_.tests.push_back(std::move(*test_));
    test_.reset();
    return;
  }
  take(element, parent);
}

void DiggsReader::take(OpenElement& element, std::string_view parent) {
  if (parent != "ResultSet" && parent != "Parameter") element.text = trimmed(element.text);
  if (element.name == "rolePerformed") is_client_ = folded(element.text).starts_with("client");
  take_name(element, parent);
  if (!test_) return;
  if (parent == "ResultSet" || parent == "Property") return take_of_result_set(element, parent);
  if (parent == "Parameter") return take_of_parameter(element);
  take_of_test(element, parent);
  take_of_specimen(element, parent);
  if (!test_->trials.empty()) take_of_trial(element, parent);
}

/// Names of what tests refer to, and of the client of a project.
void DiggsReader::take_name(const OpenElement& element, std::string_view parent) {
  if (element.name != "name" || element.text.empty()) return;
  const auto holder = above(1);
  if (holder == "project" || holder == "samplingFeature" || holder == "sample")
    names_.try_emplace(open_.back().id, element.text);
  if (parent != "BusinessAssociate" || !is_client_) return;
  const auto project = std::ranges::find(open_, "Project", &OpenElement::name);
  if (project != open_.end()) clients_.try_emplace(project->id, element.text);
}

void DiggsReader::take_of_test(OpenElement& element, std::string_view parent) {
  if (parent == "Test" && element.name == "name")
    test_->name = element.text;
  else if (element.name == "triaxialTestType")
    test_->type = element.text;
  else if ((element.name == "pos" || element.name == "posList") && is_within("location"))
    test_->depth = {element.text, element.dimension, element.line};
}

void DiggsReader::take_of_specimen(OpenElement& element, std::string_view parent) {
  if (test_->specimens.empty()) return;
  DiggsSpecimen& specimen = test_->specimens.back();
  const DiggsValue value{element.text, element.uom, element.line};
  if (parent == "SpecimenConditions") {
    if (above(1) == "conditionPreTest") specimen.before[element.name] = value;
    if (above(1) == "conditionPostTest") specimen.after[element.name] = value;
  } else if (parent == "SoilSpecimen" || parent == "RockSpecimen") {
    if (element.name == "name")
      specimen.name = element.text;
    else if (element.name == "description")
      specimen.description = element.text;
    else if (!element.text.empty())
      specimen.other[element.name] = value;
  }
}

void DiggsReader::take_of_result_set(OpenElement& element, std::string_view parent) {
  if (test_->result_sets.empty()) return;
  DiggsResultSet& set = test_->result_sets.back();
  if (parent == "ResultSet" && element.name == "dataValues") {
    set.values = std::move(element.text);
    return;
  }
  if (parent != "Property" || set.properties.empty()) return;
  DiggsProperty& property = set.properties.back();
  if (element.name == "propertyName") property.name = element.text;
  if (element.name == "propertyClass") property.property_class = element.text;
  if (element.name == "uom") property.uom = element.text;
  if (element.name == "nullValue") property.null_value = element.text;
}

void DiggsReader::take_of_parameter(const OpenElement& element) {
  if (test_->parameters.empty()) return;
  DiggsParameter& parameter = test_->parameters.back();
  if (element.name == "parameterName") parameter.name = trimmed(element.text);
  if (element.name == "parameterValue") parameter.value = element.text;
  if (element.name == "parameterUnits") parameter.unit = trimmed(element.text);
}

void DiggsReader::take_of_trial(OpenElement& element, std::string_view parent) {
  DiggsTrial& trial = test_->trials.back();
  const auto line = element.line;
  if (parent == "ShearingIncrement" && !trial.shearing.empty()) {
    const auto* const place = std::ranges::find(kIncrementElements, element.name);
    if (place != kIncrementElements.end())
      trial.shearing.back().values[static_cast<std::size_t>(place - kIncrementElements.begin())] = {
          std::move(element.text), std::move(element.uom), line};
  } else if ((parent.starts_with("TriaxialTest") && parent.ends_with("Stage")) ||
             parent == "MembraneInfo") {
    if (!element.text.empty()) trial.values[element.name] = {element.text, element.uom, line};
  }
}

void DiggsReader::resolve(DiggsTest& test) const {
  if (const auto client = clients_.find(test.project); client != clients_.end())
    test.client = client->second;
  test.project = name_of(test.project);
  test.location = name_of(test.location);
  test.sample = name_of(test.sample);
  for (DiggsSpecimen& specimen : test.specimens) specimen.sample = name_of(specimen.sample);
}

/// The first bytes, from behind a byte-order mark and spaces.
std::string beginning(ByteSource& source) {
  constexpr std::size_t kHead = 4096;
  std::string head(kHead, '\0');
  source.rewind();
  head.resize(source.read(head));
  source.rewind();
  if (head.starts_with("\xEF\xBB\xBF")) head.erase(0, 3);
  head.erase(0, std::min(head.find_first_not_of(" \t\r\n"), head.size()));
  return head;
}

}  // namespace

bool looks_like_diggs(ByteSource& source) {
  const std::string head = beginning(source);
  const bool is_utf16 = head.starts_with("\xFE\xFF") || head.starts_with("\xFF\xFE");
  if (!head.starts_with('<') && !is_utf16) return false;
  if (folded(source.name()).ends_with(".diggs")) return true;
  std::optional<bool> is_diggs;
  try {
    XmlStream stream({.name = source.name(),
                      .read = [&](std::span<char> into) { return source.read(into); },
                      .kind = "DIGGS file",
                      .remedy = {},
                      .has_lines = true},
                     {.start =
                          [&](std::string_view name, XmlAttributes) {
                            if (!is_diggs) is_diggs = name == "Diggs";
                          },
                      .end = {},
                      .text = {}});
    while (!is_diggs && stream.advance()) {
    }
  } catch (const BadInput&) {
    // A file that is broken before its root may still be meant: reading it reports the fault.
    if (!is_diggs) is_diggs = head.find("Diggs") != std::string::npos;
  }
  source.rewind();
  return is_diggs.value_or(false);
}

DiggsDocument read_diggs(ByteSource& source) {
  if (source.size() > kMaxDiggsBytes)
    throw BadInput(source.name(), 0, "larger than 256 MB; export fewer tests into one DIGGS file");
  source.rewind();
  return DiggsReader(source).read();
}

}  // namespace triax::lab
