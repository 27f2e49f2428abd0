// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/served/served_rig.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "lab/base/bad_input.hpp"
#include "lab/base/toml_reader.hpp"
#include "lab/programmes/fault_reader.hpp"
#include "lab/rig/rig_software.hpp"
#include "lab/wire/scpi/scpi_conversation.hpp"

namespace triax::lab {
namespace {

constexpr auto kLineFaults =
    std::to_array<std::pair<const char*, WireFault>>({{"NONE", WireFault::none},
                                                      {"SILENT", WireFault::silent},
                                                      {"SLOW", WireFault::slow},
                                                      {"HALF", WireFault::half_frame},
                                                      {"GARBAGE", WireFault::garbage},
                                                      {"RESET", WireFault::reset},
                                                      {"REFUSE", WireFault::refuse}});

constexpr auto kFrameFaults =
    std::to_array<std::pair<const char*, FrameFault>>({{"NONE", FrameFault::none},
                                                       {"UNIT", FrameFault::wrong_unit},
                                                       {"CHECK", FrameFault::wrong_check}});

constexpr auto kPretences = std::to_array<std::pair<const char*, Pretence>>(
    {{"ON", Pretence::other_make}, {"TWIN", Pretence::twin}, {"OFF", Pretence::itself}});

template <class Kinds>
auto kind_of(const std::string& word, const Kinds& kinds) {
  for (const auto& [name, kind] : kinds)
    if (word == name) return kind;
  std::string known;
  for (const auto& [name, kind] : kinds) known += fmt::format(", {}", name);
  throw Refused(Refused::Why::out_of_range, fmt::format("must be one of: {}", known.substr(2)));
}

}  // namespace

struct ServedRig::Impl {
  Impl(LineLoop& waiting, const RigFile& described, const Programme& programme,
       ServingOptions wanted)
      : loop(waiting),
        rig(described),
        options(std::move(wanted)),
        plant(programme, rig.served().seed.value_or(programme.seed)),
        drives(plant, options.lock_step ? 0 : rig.served().watchdog_s,
               [this] { return loop.now_s(); }),
        server(loop) {
    for (const RigInstrument& one : rig.instruments) {
      instruments.push_back(std::make_unique<ServedInstrument>(one, plant, drives));
      listen(one.name, one.served_at.value_or(one.link),
             [served = instruments.back().get()] { return served->conversation(); });
    }
    control.name = "control";
    control.identity = fmt::format("triax,rig,{},1", kSimulatedWord);
    add_clock();
    add_faults();
    add_line_faults();
    add_common_commands(table, control);
    if (rig.served().control)
      listen("control", *rig.served().control,
             [this] { return std::make_unique<ScpiConversation>(table, control); });
    if (!options.lock_step) begin_clock();
  }

  void listen(const std::string& name, LinkAddress link, WireServer::Factory talk) {
    if (!link.is_serial()) link.host = options.listen;
    open.push_back({name, server.listen(link, std::move(talk), {.clients = options.clients})});
  }

  ServedInstrument& instrument(const std::string& name) {
    for (const auto& one : instruments)
      if (one->described().name == name) return *one;
    throw Refused(Refused::Why::out_of_range, fmt::format("no instrument has the name {}", name));
  }
  const LinkAddress& link_of(const std::string& name) {
    instrument(name);
    return std::ranges::find(open, name, &Open::name)->link;
  }

  void tick(double dt_s) {
    plant.tick(dt_s);
    for (const auto& one : instruments) one->process(plant.time_s());
  }

  void begin_clock();
  void turn_clock();
  void add_clock();
  void add_faults();
  void add_line_faults();

  LineLoop& loop;
  const RigFile& rig;
  ServingOptions options;
  ServedPlant plant;
  ServedDrives drives;
  WireServer server;
  std::vector<std::unique_ptr<ServedInstrument>> instruments;
  WireDevice control;
  ScpiTable table;
  std::vector<Open> open;
  LineTimer clock;
  double tick_s = kTick_s;  ///< of the clock
  double due_s = 0;
  double lost_s = 0;
};

void ServedRig::Impl::begin_clock() {
  tick_s = std::min(kTick_s, RigSoftware::kTick_s / options.speed);
  due_s = loop.now_s() + tick_s;
  clock = loop.at(due_s, [this] { turn_clock(); });
}

void ServedRig::Impl::turn_clock() {
  const double late_s = loop.now_s() - due_s;
  if (late_s > kMostLate_s) {
    lost_s += late_s;
    due_s += late_s;
  }
  drives.watch();
  tick(tick_s * options.speed);
  due_s += tick_s;
  clock = loop.at(due_s, [this] { turn_clock(); });
}

void ServedRig::Impl::add_clock() {
  table.add("CLOCk:MODE?", 0, "LOCK, or REAL and how many times faster than the clock",
            [this](ScpiCall& call) {
              call.reply = options.lock_step ? "LOCK" : fmt::format("REAL,{}", options.speed);
            });
  table.add("CLOCk:TIME?", 0, "test time, s",
            [this](ScpiCall& call) { call.reply = fmt::format("{}", plant.time_s()); });
  table.add("CLOCk:STEP?", 1,
            "in lock step: advances the test by so many seconds; returns the time and the state "
            "of the frame",
            [this](ScpiCall& call) {
              const double dt_s = call.parameters.number("s");
              if (!options.lock_step)
                throw Refused(Refused::Why::conflict, "the clock runs by itself");
              if (!(dt_s > 0) || dt_s > RigSoftware::kTick_s)
                throw Refused(
                    Refused::Why::out_of_range,
                    fmt::format("a step must be above 0 and at most {} s", RigSoftware::kTick_s));
              tick(dt_s);
              call.reply =
                  fmt::format("{},{}", plant.time_s(), static_cast<int>(plant.frame_state()));
            });
  table.add("PLANt:STATe?", 0, "state of the frame, and why it stopped", [this](ScpiCall& call) {
    call.reply =
        fmt::format("{},\"{}\"", static_cast<int>(plant.frame_state()), plant.stands_because());
  });
}

void ServedRig::Impl::add_faults() {
  table.add("FAULt:ADD", 1,
            "a fault from now on, as a programme describes it: \"device = 'pore_pressure', kind = "
            "'drift', drift_kPa_per_min = 2\"",
            [this](ScpiCall& call) {
              const std::string text = "faults = [{from_s = 0, " + call.parameters.text() + "}]";
              try {
                const TomlTable document = TomlTable::parse(text, "FAULt:ADD");
                for (const TomlTable& one : document.tables("faults"))
                  plant.add_fault(read_fault(one, plant.programme()));
              } catch (const BadInput& error) {
                throw Refused(Refused::Why::out_of_range, error.what());
              }
            });
  table.add("FAULt:CLEar", 0, "ends all faults", [this](ScpiCall&) { plant.clear_faults(); });
  table.add("FAULt:COUNt?", 0, "number of faults",
            [this](ScpiCall& call) { call.reply = fmt::to_string(plant.faults().size()); });
}

void ServedRig::Impl::add_line_faults() {
  table.add("LINE:FAULt", 3,
            "\"NAME\",NONE|SILENT|SLOW|HALF|GARBAGE|RESET|REFUSE and by how many s a slow line is "
            "late: what is wrong with an instrument's line",
            [this](ScpiCall& call) {
              const LinkAddress& link = link_of(call.parameters.text());
              const WireFault fault = kind_of(call.parameters.word(), kLineFaults);
              const double slow_s = call.parameters.more() ? call.parameters.number("s") : 0;
              server.set_fault(link, fault, slow_s);
            });
  table.add("LINE:FRAMe", 2, "\"NAME\",NONE|UNIT|CHECK: what is wrong in its Modbus frames",
            [this](ScpiCall& call) {
              ServedInstrument& one = instrument(call.parameters.text());
              one.set_frame_fault(kind_of(call.parameters.word(), kFrameFaults));
            });
  table.add("LINE:CLOCk", 3,
            "\"NAME\",RATE,JUMP_S: its own clock jumps by so many s and runs so many times as fast",
            [this](ScpiCall& call) {
              ServedInstrument& one = instrument(call.parameters.text());
              const double rate = call.parameters.number(), jump_s = call.parameters.number("s");
              one.set_clock(rate, jump_s);
            });
  table.add("LINE:PRETend", 2,
            "\"NAME\",ON|TWIN|OFF: report another make (ON), another instrument of the same make "
            "(TWIN), or its own identity (OFF)",
            [this](ScpiCall& call) {
              ServedInstrument& one = instrument(call.parameters.text());
              one.pretend(kind_of(call.parameters.word(), kPretences));
            });
}

ServedRig::ServedRig(LineLoop& loop, const RigFile& rig, const Programme& programme,
                     const ServingOptions& options)
    : impl_(std::make_unique<Impl>(loop, rig, programme, options)) {}
ServedRig::~ServedRig() = default;

const std::vector<ServedRig::Open>& ServedRig::open() const { return impl_->open; }
const ServedPlant& ServedRig::plant() const { return impl_->plant; }
double ServedRig::lost_s() const { return impl_->lost_s; }

const ScpiTable& ServedRig::control() const { return impl_->table; }

}  // namespace triax::lab
