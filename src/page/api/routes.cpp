// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/api/routes.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "lab/base/text.hpp"
#include "src/page/api/changes_api.hpp"
#include "src/page/api/stability_api.hpp"
#include "src/page/api/tests_api.hpp"
#include "src/page/web/page_files.hpp"

namespace triax::src {
namespace {

/// A path; "#" stands for the number of a test.
struct Route {
  bool post;
  std::string_view path;
  WorkQueue queue;
  PageAnswer (*answer)(PageLaboratory&, const PageRequest&, std::int64_t test);
};

PageAnswer live_of(PageLaboratory& laboratory, const PageRequest& request, std::int64_t test) {
  auto after = request.last_event ? request.last_event : request.target.value("after");
  if (after && !live_position(*after))
    throw Refused(400,
                  lab::excerpt(*after) + " is not a reading; expected the number of a reading");
  return {.live = LiveStart{laboratory.live.feed_of(test), std::move(after)}};
}

constexpr auto kRoutes = std::to_array<Route>({
    {false, "api/tests", WorkQueue::light, [](auto& l, auto&, auto) { return list_of_tests(l); }},
    {false, "api/tests/#", WorkQueue::light,
     [](auto& l, auto&, auto id) { return test_of(l, id); }},
    {false, "api/tests/#/outline", WorkQueue::drawing,
     [](auto& l, auto&, auto id) { return outline_of(l, id); }},
    {false, "api/tests/#/window", WorkQueue::drawing,
     [](auto& l, auto& r, auto id) { return window_of(l, id, r.target); }},
    {false, "api/tests/#/export", WorkQueue::heavy,
     [](auto& l, auto& r, auto id) { return export_of(l, id, r); }},
    {false, "api/tests/#/sheet", WorkQueue::heavy,
     [](auto& l, auto& r, auto id) { return sheet_of(l, id, r); }},
    {false, "api/tests/#/live", WorkQueue::light, live_of},
    {true, "api/records", WorkQueue::records,
     [](auto& l, auto& r, auto) { return take_record(l, r, RecordTask::replay); }},
    {true, "api/records/proposal", WorkQueue::records,
     [](auto& l, auto& r, auto) { return take_record(l, r, RecordTask::propose); }},
    {true, "api/records/preview", WorkQueue::records,
     [](auto& l, auto& r, auto) { return take_record(l, r, RecordTask::preview); }},
    {true, "api/dialects", WorkQueue::light,
     [](auto& l, auto& r, auto) { return write_chosen_dialect(l, r.body); }},
    {true, "api/runs", WorkQueue::heavy,
     [](auto& l, auto& r, auto) { return begin_run(l, r.body); }},
    {true, "api/runs/#/hold", WorkQueue::orders,
     [](auto& l, auto& r, auto id) { return order_run(l, id, RunOrder::Kind::hold, r.body); }},
    {true, "api/runs/#/resume", WorkQueue::orders,
     [](auto& l, auto& r, auto id) { return order_run(l, id, RunOrder::Kind::resume, r.body); }},
    {true, "api/runs/#/stop", WorkQueue::orders,
     [](auto& l, auto& r, auto id) { return order_run(l, id, RunOrder::Kind::stop, r.body); }},
    {true, "api/browsers", WorkQueue::light,
     [](auto& l, auto&, auto) { return another_browser(l); }},
    {false, "api/programmes", WorkQueue::light,
     [](auto&, auto&, auto) { return list_of_programmes(); }},
    {false, "api/materials", WorkQueue::light,
     [](auto&, auto&, auto) { return list_of_materials(); }},
    {true, "api/probe", WorkQueue::heavy,
     [](auto& l, auto& r, auto) { return probe(r, l.ending); }},
    {true, "api/domain", WorkQueue::heavy,
     [](auto& l, auto& r, auto) { return domain(r, l.ending); }},
});

/// Whether the path is that of the route; `test` is what stands for "#".
bool fits(const Route& route, const std::vector<std::string>& path, std::int64_t& test) {
  std::string_view rest = route.path;
  for (const std::string& part : path) {
    const auto end = std::min(rest.find('/'), rest.size());
    const std::string_view wanted = rest.substr(0, end);
    if (wanted == "#") {
      const auto number = lab::whole_text_as<std::int64_t>(part);
      if (!number || *number <= 0) return false;
      test = *number;
    } else if (wanted != part) {
      return false;
    }
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return rest.empty();
}

std::string_view type_of(std::string_view name) {
  const auto ending = name.substr(std::min(name.rfind('.'), name.size()));
  if (ending == ".html") return "text/html; charset=utf-8";
  if (ending == ".css") return "text/css; charset=utf-8";
  if (ending == ".js" || ending == ".mjs") return "text/javascript; charset=utf-8";
  if (ending == ".svg") return "image/svg+xml";
  return "text/plain; charset=utf-8";
}

PageAnswer file_called(std::string_view name) {
  const auto found = std::ranges::find(lab::kPageFiles, name, &lab::EmbeddedFile::name);
  if (found == lab::kPageFiles.end()) throw Refused(404, "page does not exist");
  return {.type = std::string(type_of(name)),
          .body = std::string(found->text),
          .fields = {{"Cache-Control", "no-cache"}}};
}

}  // namespace

WorkQueue queue_of(const PageRequest& request) {
  for (const Route& route : kRoutes) {
    std::int64_t test = 0;
    const auto& path = request.target.path;
    if (route.post == request.post && !path.empty() && fits(route, path, test)) return route.queue;
  }
  return WorkQueue::light;
}

PageAnswer answer(PageLaboratory& laboratory, const PageRequest& request) {
  const auto& path = request.target.path;
  if (!request.post && path.empty()) return file_called("index.html");
  if (!request.post && path.size() == 2 && path[0] == "web" && path[1] != "index.html")
    return file_called(path[1]);
  bool other_method = false;
  for (const Route& route : kRoutes) {
    std::int64_t test = 0;
    if (path.empty() || !fits(route, path, test)) continue;
    if (route.post == request.post) return route.answer(laboratory, request, test);
    other_method = true;
  }
  if (other_method)
    throw Refused(405, request.post ? "use GET for this address" : "use POST for this address");
  throw Refused(404, "address does not exist");
}

}  // namespace triax::src
