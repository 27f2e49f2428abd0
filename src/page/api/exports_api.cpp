// SPDX-License-Identifier: GPL-3.0-or-later
// Downloads of a test, and its report as a page.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/base/whole_file.hpp"
#include "lab/records/record_writer.hpp"
#include "src/page/api/tests_api.hpp"
#include "src/triaxial/html_report.hpp"
#include "src/triaxial/json_report.hpp"
#include "src/triaxial/pdf_report.hpp"

namespace triax::src {
namespace {

namespace fs = std::filesystem;

study::TestResult result_of(const PageLaboratory& laboratory, std::int64_t id,
                            study::WithCurves curves) {
  try {
    return study::load_test_result(db::Store(laboratory.db), id, curves);
  } catch (const lab::BadInput& error) {
    throw Refused(404, error.what());
  }
}

/// A folder that is gone with this object.
class PassingFolder {
 public:
  PassingFolder() : path_((fs::temp_directory_path() / "triax-XXXXXX").string()) {
    if (::mkdtemp(path_.data()) == nullptr)
      throw lab::WorkFailed(path_ + ": no folder can be created for the download");
  }
  ~PassingFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  PassingFolder(const PassingFolder&) = delete;
  PassingFolder& operator=(const PassingFolder&) = delete;
  std::string operator/(const std::string& name) const { return path_ + '/' + name; }

 private:
  std::string path_;
};

/// Room for a download. Throws Refused if there is none.
MemoryBudget::Share share_of(PageLaboratory& laboratory, std::size_t bytes) {
  if (bytes > laboratory.budget.most())
    throw Refused(413, "this test is too long to be downloaded here; `triax export` has no limit");
  auto share = laboratory.budget.take(bytes);
  if (!share) throw Refused(503, "too many downloads at once; try again later");
  return share;
}

std::string content_of(const std::string& path) {
  std::string bytes(static_cast<std::size_t>(fs::file_size(path)), '\0');
  const auto file = lab::open_file(path);
  std::size_t done = 0;
  while (done < bytes.size()) {
    const auto come = file->read({bytes.data() + done, bytes.size() - done});
    if (come == 0) throw lab::WorkFailed(path + ": cannot be read");
    done += come;
  }
  return bytes;
}

/// The record of `simulate --record`, from what is stored.
std::string csv_of(PageLaboratory& laboratory, std::int64_t id, const PageRequest& request) {
  const auto test = result_of(laboratory, id, study::WithCurves::no).stored;
  const PassingFolder folder;
  const std::string path = folder / "record.csv";
  lab::RecordWriter writer(path, test.header);
  db::Store(laboratory.db)
      .for_each_scan(id, 1, [&](const lab::Reading& reading, const lab::State&) {
        throw_if_cancelled(request);
        writer.write(reading);
      });
  writer.finish(test.header, test.summary.truth);
  static_cast<void>(share_of(laboratory, fs::file_size(path)));
  return content_of(path);
}

/// Letters, figures, points and dashes of ASCII; the rest is no matter of a header field.
std::string file_name(const std::string& test, const std::string& ending) {
  std::string name;
  for (const unsigned char c : test.substr(0, 60))
    name += std::isalnum(c) != 0 || c == '-' || c == '.' ? static_cast<char>(c) : '_';
  return (name.empty() ? "test" : name) + ending;
}

/// With the evidence: who looks at one test on a screen wants it.
ReportSheets sheets_of(const PageLaboratory& laboratory, std::int64_t id) {
  ReportSheets sheets{.evidence = true};
  try {
    sheets.tests.push_back(load_sheet_test(db::Store(laboratory.db), id));
  } catch (const lab::BadInput& error) {
    throw Refused(404, error.what());
  }
  return sheets;
}

std::string html_of(PageLaboratory& laboratory, std::int64_t id, const PageRequest& request) {
  const ReportSheets sheets = sheets_of(laboratory, id);
  return laboratory.desk.ask([&] {
    throw_if_cancelled(request);
    return html_report(sheets);
  });
}

std::string pdf_of(PageLaboratory& laboratory, std::int64_t id, const PageRequest& request) {
  const ReportSheets sheets = sheets_of(laboratory, id);
  return laboratory.desk.ask([&] {
    throw_if_cancelled(request);
    return pdf_bytes(sheets);
  });
}

std::string json_of(PageLaboratory& laboratory, std::int64_t id, const PageRequest&) {
  return json_report({result_of(laboratory, id, study::WithCurves::no)});
}

/// A report has its styles within: it is shown as a page of nobody, in which nothing runs.
constexpr const char* kSheetPolicy =
    "sandbox; default-src 'none'; style-src 'unsafe-inline'; img-src data:; "
    "frame-ancestors 'self'";

struct Format {
  const char* name;
  const char* type;
  std::string (*bytes)(PageLaboratory&, std::int64_t, const PageRequest&);
};
constexpr std::array<Format, 4> kFormats = {{{"csv", "text/csv; charset=utf-8", csv_of},
                                             {"json", "application/json", json_of},
                                             {"html", "text/html; charset=utf-8", html_of},
                                             {"pdf", "application/pdf", pdf_of}}};

}  // namespace

PageAnswer export_of(PageLaboratory& laboratory, std::int64_t id, const PageRequest& request) {
  const std::string asked = request.target.value("format").value_or("");
  const auto* const format = std::ranges::find(kFormats, asked, &Format::name);
  if (format == kFormats.end())
    throw Refused(400, "format=" + lab::excerpt(asked) + ": expected csv, json, html or pdf");
  const auto test = result_of(laboratory, id, study::WithCurves::no).stored;
  PageAnswer answer;
  answer.type = format->type;
  answer.body = format->bytes(laboratory, id, request);
  answer.held = std::make_shared<MemoryBudget::Share>(share_of(laboratory, answer.body.size()));
  answer.fields = {{"Content-Disposition",
                    "attachment; filename=\"" + file_name(test.header.name, '.' + asked) + '"'},
                   {"Content-Security-Policy", kSheetPolicy}};
  return answer;
}

PageAnswer sheet_of(PageLaboratory& laboratory, std::int64_t id, const PageRequest& request) {
  return {.type = "text/html; charset=utf-8",
          .body = html_of(laboratory, id, request),
          .fields = {{"Content-Security-Policy", kSheetPolicy}, {"X-Frame-Options", "SAMEORIGIN"}}};
}

}  // namespace triax::src
