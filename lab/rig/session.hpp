#pragma once
// The one stream: back end -> Reading -> reduction -> State -> collapse monitor -> Event, and the
// signals by which recorder, progress bar and panel listen to it.
#include <QObject>
#include <functional>

#include "lab/collapse/monitor.hpp"
#include "lab/reduction/reduction.hpp"
#include "lab/rig/back_end.hpp"

namespace triax::lab {

struct SessionOptions {
  ReductionOptions reduction;
  double speed =
      0;  ///< 0: as fast as possible; else test time runs this many times faster than the clock
  /// Asked after every reading and while the clock is waited for; true breaks the test off.
  std::function<bool()> stop = {};
};

class Session : public QObject {
  Q_OBJECT
 public:
  /// Runs a whole test; returns what it came to. A test that was broken off is judged as far as it
  /// went, with a warning that says when. Throws what the back end throws, after which every
  /// reading that was signalled stands. Signals are delivered in this thread, in order.
  TestSummary run(BackEnd& back_end, const SessionOptions& options);

 signals:
  void started(const triax::lab::RecordHeader& header);
  void scanned(const triax::lab::Reading& reading, const triax::lab::State& state);
  void second_order_work(const triax::lab::SecondOrderWorkPoint& point);
  void happened(const triax::lab::Event& event);
  void progressed(double fraction);  ///< about a hundred times a second of clock time at most
};

}  // namespace triax::lab
