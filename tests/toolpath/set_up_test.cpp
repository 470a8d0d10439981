// Work frames and tools of paths: the output, its time, and the errors.
#include "toolpath/placement/set_up.h"

#include <gtest/gtest.h>

#include "machine/file/machine_file.h"
#include "tests/build_files/build_files.h"
#include "toolpath/json/json_reader.h"
#include "toolpath/json/json_writer.h"
#include "toolpath/rotary/axis_moves.h"

namespace gsim::path::set_up_test {
namespace {

struct Log : MoveSink {
    std::string reported;
    void move(const AxisMove& move) override { reported += move.rapid ? "rapid " : "line "; }
    void retract() override { reported += "up "; }
    void work_offset(const std::string& name) override { reported += "G" + name + " "; }
    void dwell(double) override {}
    void acceleration(double) override {}
    void action(const std::string& name) override { reported += "[" + name + "] "; }
    void call(const SubPath& use) override { reported += "call" + std::to_string(use.path) + " "; }
    void note(const TargetId&, std::string_view) override {}
};

const char* const kRapid = R"({"motion": "rapid", "position_mm": [10, 20, -5]})";
const char* const kLine = R"({"position_mm": [10, 20, -9], "feed_mm_min": 100})";

Program program_of(const std::string& paths) {
    const auto file = read_json(R"({"paths": [)" + paths + "]}", "f");
    EXPECT_TRUE(file) << file.error().message << paths;
    return file ? file->program : Program{};
}

/// A path of points or uses.
std::string path(const std::string& name_and_keys, const std::string& targets) {
    return R"({"name": )" + name_and_keys + R"(, "targets": [)" + targets + "]}";
}

/// Returns the output of one path's moves in a program, or the error.
std::string reported(const Program& program, std::size_t path, const MoveOptions& options = {}) {
    const machine::Machine machine =
        machine::load_machine(tests::source_path("samples/machines/router3.toml")).value();
    const MachineSpace space = MachineSpace::make(machine).value();
    const States states(program);
    const auto turns = plan_rotary(program, space, states, {}).value();
    Log log;
    const auto done = AxisMoves(program, space, states, turns, options).run(path, log);
    return done ? log.reported : done.error().message;
}

TEST(FramesAndTools, SetsFrameBeforeFirstMotionAndAtChanges) {
    const Program program = program_of(
        path(R"("job", "work_offset": "G54")",
             std::string(kRapid) +
                 R"(, {"path": "part", "work_offset": "55"}, {"path": "part", "work_offset": "G55"}, )" +
                 kRapid) +
        "," + path(R"("part")", std::string(kRapid) + "," + kLine));
    EXPECT_EQ(reported(program, 0), "G54 rapid up G55 call1 call1 up G54 rapid ");
    EXPECT_EQ(reported(program, 1), "rapid line ") << "in the frame of whoever uses it";
}

TEST(FramesAndTools, ChangesToolOnlyIfDifferent) {
    const Program program = program_of(
        path(R"("job")", R"({"path": "rough"}, {"path": "more"}, {"path": "fine", "repeats": 2})") + "," +
        path(R"("rough", "tool": 3)", kRapid) + "," + path(R"("more", "tool": 3)", kRapid) + "," +
        path(R"("fine", "tool": 4, "length_offset": 0, "diameter_offset": 14)", kRapid));
    EXPECT_EQ(
        reported(program, 0),
        "up [tool_select T3] [tool_change T3] [tool_length H3] call1 call2 up [tool_select T4] [tool_change "
        "T4] [tool_length_off] [tool_diameter D14] call3 ");
    for (const std::size_t sub_path : {1U, 2U, 3U}) EXPECT_EQ(reported(program, sub_path), "rapid ");
}

TEST(FramesAndTools, RestartsSpindleAfterToolChange) {
    const Program program = program_of(
        path(
            R"("job")",
            R"({"motion": "rapid", "position_mm": [1, 2, -3], "actions": ["speed 900", "spindle_cw"]}, {"path": "p"})") +
        "," + path(R"("p", "tool": 3)", kRapid));
    MoveOptions options;
    options.tool_change_stops = {.spindle = true};
    EXPECT_EQ(reported(program, 0, options),
              "rapid [speed 900] [spindle_cw] up [tool_select T3] [tool_change T3] [speed 900] [spindle_cw] "
              "[tool_length H3] call1 ");
}

TEST(FramesAndTools, FirstMotionAfterFrameChangeMustBeRapid) {
    const std::string uses = std::string(kRapid) + R"(, {"path": "part", "work_offset": "G55"})";
    const std::string root = R"("job", "work_offset": "G54")";
    EXPECT_NE(
        reported(program_of(path(root, uses) + "," + path(R"("part")", kLine)), 0).find("must be a rapid"),
        std::string::npos);
    EXPECT_NE(reported(program_of(path(root, uses + "," + kLine) + "," + path(R"("part")", kRapid)), 0)
                  .find("must be a rapid"),
              std::string::npos);
    // The first motion of all is as it always was.
    EXPECT_EQ(reported(program_of(path(root, kLine)), 0), "G54 line ");
}

TEST(FramesAndTools, RestoresFrameAfterSubPath) {
    const std::string inner = path(R"("inner", "work_offset": "G56")", kRapid);
    const Program own =
        program_of(path(R"("job", "work_offset": "G54")", R"({"path": "outer"})") + "," +
                   path(R"("outer", "work_offset": "G55")", R"({"path": "inner"})") + "," + inner);
    EXPECT_EQ(reported(own, 0), "G55 call1 ");
    EXPECT_EQ(reported(own, 1), "G56 call2 up G55 ") << "nothing has moved before";
    const Program differs = program_of(
        path(R"("job", "work_offset": "G54")",
             R"({"path": "outer"}, {"path": "outer", "work_offset": "G57"})") +
        "," + path(R"("outer")", std::string(kRapid) + R"(, {"path": "inner"}, )" + kRapid) + "," + inner);
    EXPECT_NE(reported(differs, 1).find("the path needs a separate 'work_offset'"), std::string::npos);
}

TEST(FramesAndTools, RejectsFrameChangeWhileJetIsOn) {
    const Program program =
        program_of(path(R"("job", "work_offset": "G54")",
                        R"({"motion": "rapid", "position_mm": [1, 2, -3], "actions": ["waterjet_on"]},
                {"path": "part", "work_offset": "G55"})") +
                   "," + path(R"("part")", kRapid));
    EXPECT_EQ(reported(program, 0),
              "the jet may be on at a change of the tool or the work offset; turn it off before");
}

// 10 + 595 is beyond X 600; if the position of the frame is unknown, no error is reported.
TEST(FramesAndTools, ChecksMachineRangesInWorkFrame) {
    const Program program =
        program_of(path(R"("job")", R"({"path": "part", "work_offset": "G55"}, {"path": "part"})") + "," +
                   path(R"("part")", kRapid));
    MoveOptions options;
    options.frames_mm["55"] = Vector{595, 0, 0};
    EXPECT_EQ(reported(program, 1, options), "out of reach: X 605 is outside 0 to 600");
    options.frames_mm["55"] = Vector{500, 0, 0};
    EXPECT_EQ(reported(program, 1, options), "rapid ");
    const Program above = program_of(
        path(R"("job", "work_offset": "G55")", R"({"motion": "rapid", "position_mm": [10, 20, 5]})"));
    EXPECT_EQ(reported(above, 0), "out of reach: Z 5 is outside -120 to 0");
    options.frames_mm["55"] = std::nullopt;
    EXPECT_EQ(reported(above, 0, options), "G55 rapid ");
}

TEST(FramesAndTools, RoundTripsThroughJson) {
    const Program program = program_of(
        path(R"("job", "work_offset": "G59.1", "set_offset_mm": [1, 2, 3], "tool": 3, "diameter_offset": 5)",
             R"({"path": "part", "work_offset": "G55", "set_offset_mm": [4, 5, 6]})") +
        "," + path(R"("part", "tool": 7, "length_offset": 0)", kRapid));
    EXPECT_EQ(program.paths[0].frame, (WorkFrame{"59.1", Vector{1, 2, 3}}));
    EXPECT_EQ(program.paths[0].tool, (Tool{3, 3, 5}));
    EXPECT_EQ(program.paths[1].tool, (Tool{7, 0, std::nullopt}));
    EXPECT_EQ(std::get<SubPath>(program.paths[0].targets[0]).frame, (WorkFrame{"55", Vector{4, 5, 6}}));
    EXPECT_EQ(read_json(to_json(program), "f").value().program, program);
}

TEST(FramesAndTools, RejectsInvalidFramesAndTools) {
    const auto error = [](const std::string& name_and_keys, const std::string& targets,
                          bool recorded = false) {
        const std::string offsets = recorded ? R"("work_offsets": {"54": {"X": 1}}, )" : "";
        const auto file =
            read_json("{" + offsets + R"("paths": [)" + path(name_and_keys, targets) + "]}", "f");
        return file ? std::string() : file.error().message;
    };
    EXPECT_EQ(error(R"("a", "work_offset": 55)", kRapid),
              "f:1:41: 'work_offset' must be a string, not a number");
    EXPECT_EQ(error(R"("a", "work_offset": "")", kRapid), "f:1:41: 'work_offset' must not be empty");
    EXPECT_EQ(error(R"("a", "tool": 1.5)", kRapid),
              "f:1:34: 'tool' must be an integer from 0 to 99999999; it is 1.5");
    EXPECT_EQ(error(R"("a", "tool": "T1")", kRapid), "f:1:34: 'tool' must be a number, not a string");
    EXPECT_EQ(error(R"("a", "length_offset": 1)", kRapid), "f:1:12: 'length_offset' requires 'tool'");
    EXPECT_EQ(error(R"("a", "work_offset": "G55", "set_offset_mm": [1, 2])", kRapid),
              "f:1:69: 'set_offset_mm' must contain three numbers; it contains 2");
    EXPECT_EQ(error(R"("a", "work_offset": "G55", "set_offset_mm": 3)", kRapid),
              "f:1:65: 'set_offset_mm' must be an array of three numbers, not a number");
    EXPECT_EQ(error(R"("a", "set_offset_mm": [1, 2, 3])", kRapid),
              "f:1:12: 'set_offset_mm' requires 'work_offset', which names the offset to set");
    EXPECT_NE(error(R"("a")", R"({"position_mm": [1, 2, 3], "work_offset": "G55"})")
                  .find("'work_offset' of a point is only for paths that were recorded"),
              std::string::npos);
    EXPECT_NE(error(R"("a", "tool": 3)", R"({"position_mm": [1, 2, 3], "actions": ["tool_change T4"]})")
                  .find("the action 'tool_change T4' cannot be combined with paths that have a 'tool'"),
              std::string::npos);
    EXPECT_NE(error(R"("a", "tool": 3)", kRapid, true).find("must have its tools in the actions"),
              std::string::npos);
    EXPECT_NE(
        error(R"("a", "work_offset": "55")", kRapid, true).find("must have its work offsets at its points"),
        std::string::npos);
    const auto file =
        read_json(R"({"paths": [)" +
                      path(R"("a", "work_offset": "G55", "set_offset_mm": [1, 2, 3])",
                           R"({"path": "b", "work_offset": "G55", "set_offset_mm": [1, 2, 4]})") +
                      "," + path(R"("b")", kRapid) + "]}",
                  "f");
    EXPECT_NE(file.error().message.find("the work offset '55' is set to two positions"), std::string::npos);
}

}  // namespace
}  // namespace gsim::path::set_up_test
