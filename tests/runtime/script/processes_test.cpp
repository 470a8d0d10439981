// Processes in Lua: their order, their clocks, signals, interrupts, and how they end.

#include "tests/lua_lib/run.h"

namespace gsim::script::processes_test {
namespace {

/// The times of all changes of a signal.
std::vector<double> times(const Outcome& r, const std::string& signal) {
    std::vector<double> list;
    for (const simulation::SignalChange& change : r.report.concurrency.signals) {
        if (change.signal == signal) list.push_back(change.t_s);
    }
    return list;
}

/// Returns the time between standstills over `length` at F6000.
double move_s(double length) {
    return trapezoid_s(length, 100, kAcceleration_mm_s2);
}

TEST(Processes, SetsSignalWhenRobotArrives) {
    const Outcome r = run_lua(
        "process('listener', function() wait_until('there') signal('heard') end)\n"
        "F(6000) G1{x=100} G1{x=300} signal('there')\n"
        "wait_until('heard') G1{x=400}\n");
    ASSERT_TRUE(r.completed()) << r.message();
    const double there_s = move_s(100) + move_s(200);
    ASSERT_EQ(times(r, "there").size(), 1U);
    EXPECT_NEAR(times(r, "there")[0], there_s, 1e-9);
    EXPECT_NEAR(times(r, "heard")[0], there_s, 1e-9);
    EXPECT_NEAR(r.report.cycle_time_s, there_s + move_s(100), 1e-9);
}

TEST(Processes, RobotIsIdleUntilSignal) {
    const Outcome r = run_lua(
        "device('feeder', function() wait(4) signal('part', 7) end)\n"
        "F(6000) G1{x=100} wait_until('part', 7) G1{x=200} wait(0.5)\n");
    ASSERT_TRUE(r.completed()) << r.message();
    EXPECT_NEAR(r.report.cycle_time_s, 4 + move_s(100) + 0.5, 1e-9);
    EXPECT_NEAR(r.report.times.dwell_s, 4 - move_s(100) + 0.5, 1e-9);
    ASSERT_EQ(r.report.concurrency.processes.size(), 2U);
    EXPECT_EQ(r.report.concurrency.processes[0].name, "main");
    EXPECT_NEAR(r.report.concurrency.processes[0].idle_s, 4 - move_s(100), 1e-9);
    EXPECT_EQ(r.report.concurrency.processes[1].state, "done");
}

TEST(Processes, FirstCreatedRunsFirstAtEqualTimes) {
    const Outcome r = run_lua(
        "local order = ''\n"
        "for _, name in ipairs{'c', 'a', 'b'} do\n"
        "  process(name, function() for i = 1, 2 do wait(1) order = order .. name end end)\n"
        "end\n"
        "process('end', function() wait(3) assert(order == 'cabcab', order) end)\n");
    EXPECT_TRUE(r.completed()) << r.message();
}

TEST(Processes, WaitReturnsFalseAtTimeout) {
    const Outcome r = run_lua(
        "process('late', function() wait(5) signal('x') end)\n"
        "assert(wait_until('x', true, 2) == false) signal('gave up')\n"
        "assert(wait_until('x', nil, 10) == true) signal('got it')\n"
        "assert(wait_until(function() return value('x') end, 1) == true)\n"
        "assert(wait_until(function() return value('y') == 3 end, 1) == false) signal('end')\n");
    ASSERT_TRUE(r.completed()) << r.message();
    EXPECT_NEAR(times(r, "gave up").at(0), 2, 1e-12);
    EXPECT_NEAR(times(r, "got it").at(0), 5, 1e-12);
    EXPECT_NEAR(times(r, "end").at(0), 6, 1e-12);
}

TEST(Processes, ReportsDeadlockWithEachWait) {
    const Outcome r = run_lua(
        "process('left', function()\n  wait_until 'right ready'\nend)\n"
        "process('right', function()\n  wait(2)\n  wait_until('left ready', 3)\nend)\n");
    expect_alarm(r, 2,
                 {"no process can continue", "'left' (part.lua:2) waits for 'right ready' to be on",
                  "'right' (part.lua:6) waits for 'left ready' to be 3"});
}

TEST(Processes, InterruptRunsAtNextLineAfterSignal) {
    const Outcome r = run_lua(
        "device('door', function() wait(1.5) signal('open') wait(2) signal('open', false) end)\n"
        "on_signal('open', function() signal('seen') wait_until('open', false) end)\n"
        "F(6000)\n"
        "G1{x=100}\n"
        "G1{x=200}\n"
        "G1{x=300}\n"
        "on_signal('open', nil)\n");
    ASSERT_TRUE(r.completed()) << r.message();
    const double two_s = 2 * move_s(100);  // 2.4 s: the second move is active when the door opens
    EXPECT_NEAR(times(r, "seen").at(0), two_s, 1e-9);
    EXPECT_NEAR(r.report.cycle_time_s, 3.5 + move_s(100), 1e-9);
}

TEST(Processes, RemovedInterruptDoesNotRun) {
    const Outcome r = run_lua(
        "process('door', function() signal('open') end)\n"
        "on_signal('open', function() error('interrupted') end)\n"
        "on_signal('open', nil)\n"
        "wait(1)\nG0{x=1}\n");
    EXPECT_TRUE(r.completed()) << r.message();
}

TEST(Processes, RobotBelongsToOneProcess) {
    const Outcome r = run_lua(
        "process('thief', function()\n  wait(1)\n  G0{x=10}\nend)\n"
        "F(600) G1{x=100} wait(5) G1{x=200}\n");
    expect_alarm(r, 3, {"belongs to the process 'main'"});
    const Outcome after = run_lua("process('heir', function() wait(1) F(6000) G1{x=100} end)\n");
    EXPECT_TRUE(after.completed()) << after.message();
    EXPECT_NEAR(after.report.cycle_time_s, 1 + move_s(100), 1e-9);
}

TEST(Processes, ErrorsHaveLineAndEndRun) {
    expect_alarm(run_lua("process('a', function()\n  wait(1)\n  local x = {} .. 5\nend)\nwait(5)\n"), 3,
                 {"concatenate"});
    expect_alarm(run_lua("process('a', function()\n  wait(1)\n  G0{x=9999}\nend)\n"), 3, {"axis X"});
    expect_alarm(run_lua("process('a', 5)\n"), 1, {"process"});
    expect_alarm(run_lua("\nsignal('a', 0/0)\n"), 2, {"finite"});
    expect_alarm(run_lua("\nsignal('', 1)\n"), 2, {"name of a signal"});
    expect_alarm(run_lua("\nwait(-1)\n"), 2, {"seconds, 0 or more"});
    expect_alarm(run_lua("robot('left')\n"), 1,
                 {"unknown robot 'left'; robots are defined in a robots file (--robots)"});
    expect_alarm(run_lua("conveyor('belt')\n"), 1,
                 {"unknown conveyor 'belt'; conveyors are defined in a robots file (--robots)"});
    expect_alarm(run_lua("\ntable.sort({2, 1}, function() wait_until('x') end)\n"), 2, {"yield"});
}

TEST(Processes, PcallSpansWait) {
    const Outcome r = run_lua(
        "process('a', function() wait(1) signal('x') end)\n"
        "local ok, e = pcall(function() wait_until('x') error('mine') end)\n"
        "assert(ok == false and e:find('mine'))\n"
        "assert(pcall(function() wait_until('y', true, 1) return 1 end))\n");
    EXPECT_TRUE(r.completed()) << r.message();
}

TEST(Processes, LimitsHoldInAllProcesses) {
    Conditions conditions;
    conditions.options.limits.steps = 100'000;
    expect_stopped(run_lua("process('a', function() wait(1) while true do end end)\n", conditions),
                   "--max-steps");
    expect_stopped(run_lua("process('a', function()\n"
                           "  while true do pcall(function() while true do end end) end end)\n",
                           conditions),
                   "--max-steps");
    conditions.options.limits = {.memory_bytes = std::size_t{16} << 20U};
    expect_stopped(
        run_lua("process('a', function() local s = 'x' while true do s = s .. s end end)\n", conditions),
        "--memory");
    Conditions short_run;
    short_run.limits.max_time_s = 100;
    expect_stopped(run_lua("process('a', function() while true do wait(1) end end)\n", short_run),
                   "--max-time");
    Conditions few_blocks;
    few_blocks.limits.max_blocks = 1000;
    expect_stopped(run_lua("process('a', function() while true do wait(0) end end)\nwait(1)\n", few_blocks),
                   "--max-blocks");
}

TEST(Processes, ReportOmitsProcessesIfNoneStarted) {
    const Outcome r = run_lua("F(6000) G1{x=100} wait(1)\nsignal('x')\n");
    ASSERT_TRUE(r.completed()) << r.message();
    EXPECT_TRUE(r.report.concurrency.processes.empty());
    EXPECT_NEAR(r.report.cycle_time_s, move_s(100) + 1, 1e-9);
}

TEST(Processes, InputsAndOutputsAreSignals) {
    Conditions conditions;
    conditions.options.dialect = "rs274ngc";
    conditions.options.setup = Script::from_text(
        "process('plc', function() wait_until('DO1') wait(2) signal('DI2') end)", "s.lua", 0);
    const Outcome r =
        run("M64 P1\nM66 P2 L3 Q10\nG0 X[#5399 * 10]\nM66 P3 L3 Q1\nG0 Y[20 - #5399]\nM2\n", conditions);
    ASSERT_TRUE(r.completed()) << r.message();
    EXPECT_NEAR(r.end()[0], 10, 1e-9);  // it came
    EXPECT_NEAR(r.end()[1], 21, 1e-9);  // it did not: -1
    EXPECT_NEAR(r.report.concurrency.processes.at(0).idle_s, 3, 1e-9);
}

TEST(Processes, ProgramWaitsWithinChunksOfLongScript) {
    Script script;
    const std::string text = "wait_until('x') v[1] = 1\nG0{x=v[1]} wait(1) G0{x=2}\n";
    script.file_name = "part.nc";
    script.size = text.size();
    script.read = [text](std::uint64_t begin, std::uint64_t end) { return text.substr(begin, end - begin); };
    script.functions.push_back({"program(nil, ", {{0, 25, 1}, {25, text.size(), 2}}});
    Conditions conditions;
    conditions.options.setup =
        Script::from_text("process('a', function() wait(2) signal('x') end)", "setup.lua", 0);
    const Outcome r = run_script(script, conditions);
    EXPECT_TRUE(r.completed()) << r.message();
    EXPECT_NEAR(r.end()[0], 2, 1e-9);
    EXPECT_GT(r.report.cycle_time_s, 3);
}

}  // namespace
}  // namespace gsim::script::processes_test
