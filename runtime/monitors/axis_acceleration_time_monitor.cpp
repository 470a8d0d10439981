#include "runtime/monitors/axis_acceleration_time_monitor.h"

#include <algorithm>
#include <cmath>

#include "runtime/motion_sources/motion_replay.h"
#include "runtime/motion_sources/null_segment_sink.h"
#include "runtime/simulator/make_planner_setup.h"

namespace gsim::simulation {

AxisAccelerationTimeMonitor::AxisAccelerationTimeMonitor(const machine::Machine& machine)
    : null_sink_(std::make_unique<NullSegmentSink>()),
      word_times_(machine.times),
      planner_(make_planner_setup(machine), null_sink_.get()) {
    if (std::any_of(machine.axes.begin(), machine.axes.end(),
                    [](const machine::Axis& axis) { return std::isinf(axis.max_acceleration); }))
        on_unrecordable("an axis has no max_acceleration");
}

void AxisAccelerationTimeMonitor::on_unrecordable(std::string_view reason) {
    if (error_.empty()) error_ = reason;
}

void AxisAccelerationTimeMonitor::on_start_position(const rrs::JointPos& joints) {
    if (const auto started = planner_.set_position({joints, std::nullopt}); !started)
        on_unrecordable(started.error().message);
}

void AxisAccelerationTimeMonitor::on_request(const MotionRequest& request) {
    if (!error_.empty()) return;
    if (const auto enqueue = replay_request(request, word_times_, planner_); !enqueue)
        on_unrecordable(enqueue.error().message);
}

void AxisAccelerationTimeMonitor::ended() {
    planner_.dwells().plan_to_final_standstill();
    planner_.flush();
}

std::optional<double> AxisAccelerationTimeMonitor::time_s() const {
    if (!error_.empty()) return std::nullopt;
    return planner_.time_s();
}

}  // namespace gsim::simulation
