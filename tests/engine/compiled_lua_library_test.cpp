// The compiled Lua library, one for many runs: only the time that it takes differs.

#include <thread>

#include <gmock/gmock.h>

#include "engine/run.h"
#include "tests/engine/memory_files.h"

namespace gsim::engine::shared_library_test {
namespace {

using testing::HasSubstr;

struct Part {
    const char* name;
    const char* dialect;
    const char* text;
};

// Cycles, offsets, arcs, an error of the program that the library reports, and a script's own.
constexpr Part kParts[] = {
    {"a.nc", "ab9", "G0 X100 Y100\nF6000\nG1 X200\nG2 X100 Y100 I-50 J-50\nG4 P1\nM2\n"},
    {"b.ngc", "rs274ngc", "G21 G90 F600\nG54\nG10 L2 P1 X5\nG81 X10 Y10 Z-2 R1\nG80\nM2\n"},
    {"c.ngc", "rs274ngc", "G21\nG1 X10\nM2\n"},
    {"d.ngc", "rs274ngc", "F100\nG2 X10 Y10 I1 J0\nM2\n"},
    {"e.lua", "ab9", "local _ENV = require 'gsim'\nF(600)\nG1{x=10}\nG1{q=3}\n"},
};

std::string outcome(const Part& part, const std::optional<CompiledLuaLibrary>& library) {
    Request request = make_request(part.name, {{part.name, part.text}});
    request.language.dialect = part.dialect;
    request.compiled_lua_library = library;
    std::string reported;
    auto run = Run::open(std::move(request), [&](const Diagnostic& each) { reported += each.text + "\n"; });
    if (!run) return run.error().message;
    if (const auto ready = run->prepare(); !ready) return reported + ready.error().message;
    return reported + run->go().value().json();
}

TEST(CompiledLuaLibrary, KeepsReportsAndErrorsUnchanged) {
    const CompiledLuaLibrary library;
    for (int turn = 0; turn < 3; ++turn) {
        for (const Part& part : kParts) {
            SCOPED_TRACE(part.name);
            EXPECT_EQ(outcome(part, library), outcome(part, {}));
        }
    }
    EXPECT_THAT(outcome(kParts[2], library), HasSubstr("feed"));
    EXPECT_THAT(outcome(kParts[4], library), HasSubstr("e.lua"));
}

TEST(CompiledLuaLibrary, SupportsSeveralThreads) {
    const CompiledLuaLibrary library;
    std::vector<std::string> found(8);
    {
        std::vector<std::jthread> threads;
        for (std::size_t i = 0; i < found.size(); ++i)
            threads.emplace_back([&, i] { found[i] = outcome(kParts[i % 2], library); });
    }
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i], outcome(kParts[i % 2], {}));
}

}  // namespace
}  // namespace gsim::engine::shared_library_test
