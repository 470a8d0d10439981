// Two runs in one process, each with an engine, a simulator and a cell of its own: the runs are independent.

#include <condition_variable>
#include <mutex>
#include <thread>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "collision/cell/cell_file.h"
#include "engine/src/run/word_table.h"
#include "runtime/monitors/cell_monitor.h"
#include "runtime/report/report.h"
#include "tests/lua_lib/run.h"

namespace gsim::script::two_runs_test {
namespace {

/// Components of one run.
struct Part {
    double post_x_mm;
    std::string dialect;
    std::string lua;
};

const std::string kCell = R"(
[cell]
name = "post"
clearance_mm = 30.0
[[object]]
name = "post"
shape = {{ cylinder_mm = [20.0, 50.0] }}
frame = {{ x_mm = {:.3f}, y_mm = 100.0 }}
[[shape]]
name = "tip"
on = "tool"
shape = {{ sphere_mm = 10.0 }}
)";

const std::array<Part, 2> kParts{
    Part{150, "ab9",
         "local _ENV = require 'gsim' F(6000)\nfor i = 1, 60 do G1{x=2 * i, y=100 * (i % 2)} end\n"
         "local s, pose = rrs.GetCellFrame('post') pose[1][4] = 40 rrs.ModifyCellFrame('post', pose)\n"
         "for i = 60, 1, -1 do G1{x=2 * i, y=100 * (i % 2)} end\n"},
    Part{40, "rs274ngc",
         "local _ENV = require 'gsim.rs274ngc' G21() G64() F(3000)\n"
         "process('mate', function() for i = 1, 40 do wait(0.25) signal('tick', i) end end)\n"
         "for i = 1, 60 do G1{x=i, y=10 + 3 * i} G3{x=i, y=10 + 3 * i, i=4, j=0} wait(0.1) end\n"}};

/// `pause` is called at each block that gets read.
std::string part_report(const Part& part, const std::function<void()>& pause) {
    const machine::Machine machine = built_in_machine();
    simulation::CellMonitor cell(
        cell::read_cell(fmt::format(fmt::runtime(kCell), part.post_x_mm), "cell.toml", machine).value(),
        machine);
    simulation::Simulator simulator(machine, {});
    simulator.set_cell(cell);
    class Pauses final : public simulation::RunOutput {
      public:
        explicit Pauses(const std::function<void()>& pause) : pause_(pause) {}
        void on_move(const simulation::RecordedMove& /*move*/) override { pause_(); }

      private:
        const std::function<void()>& pause_;
    } pauses(pause);
    simulator.add_output(pauses);
    Engine::Options options;
    options.dialect = part.dialect;
    options.codes = engine::word_table(*grammar::find_dialect(part.dialect));
    Script script = Script::from_text(part.lua, "part.lua", 0);
    script.dialect = part.dialect;
    Engine engine(simulator, options);
    engine.run(std::move(script));
    simulation::Report report = simulator.finish("part.lua");
    engine.report(report);
    return simulation::to_json(report);
}

/// Lets two threads go on in turns, until one of them is done.
class Turns {
  public:
    void on_move(int which) {
        std::unique_lock lock(mutex_);
        whose_ = 1 - which;
        changed_.notify_all();
        changed_.wait(lock, [&] { return whose_ == which || done_; });
    }
    void finish() {
        const std::scoped_lock lock(mutex_);
        done_ = true;
        changed_.notify_all();
    }

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    int whose_ = 0;
    bool done_ = false;
};

std::array<std::string, 2> both(const std::function<void(int)>& pause, const std::function<void()>& finish) {
    std::array<std::string, 2> reports;
    std::array<std::thread, 2> threads;
    for (const int which : {0, 1}) {
        const auto index = static_cast<std::size_t>(which);
        threads[index] = std::thread([&, which, index] {
            reports[index] = part_report(kParts[index], [&, which] { pause(which); });
            finish();
        });
    }
    for (std::thread& thread : threads) thread.join();
    return reports;
}

TEST(ConcurrentRuns, GiveSameReportsAsAlone) {
    const std::string first = part_report(kParts[0], [] {});
    const std::string second = part_report(kParts[1], [] {});
    EXPECT_NE(first.find("\"collisions\": [\n"), std::string::npos);
    EXPECT_NE(second.find("\"collisions\": [\n"), std::string::npos);
    EXPECT_EQ(first.find("\"alarm\": {"), std::string::npos) << first;
    EXPECT_EQ(second.find("\"alarm\": {"), std::string::npos) << second;
    Turns turns;
    const auto in_turns = both([&](int which) { turns.on_move(which); }, [&] { turns.finish(); });
    EXPECT_EQ(in_turns[0], first);
    EXPECT_EQ(in_turns[1], second);
    const auto at_once = both([](int) {}, [] {});
    EXPECT_EQ(at_once[0], first);
    EXPECT_EQ(at_once[1], second);
}

}  // namespace
}  // namespace gsim::script::two_runs_test
