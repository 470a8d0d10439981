// How much faster is a program at another feed override? Runs in one process share the compiled Lua library.
// g++ -std=c++20 09_feed_override.cpp $(pkg-config --cflags --libs libgsim) -o example && ./example
#include <cstdio>

#include <gsim/engine/run.h>

int main() {
    using namespace gsim;
    const engine::CompiledLuaLibrary library;
    for (const double percent : {50.0, 100.0, 150.0}) {
        engine::Request request;
        request.text = engine::Text("G1 X100 F3000\nG1 Y100\nG1 X0\nG1 Y0\nM2\n", "square.nc");
        request.overrides.feed_percent = percent;
        request.compiled_lua_library = library;
        auto run = engine::Run::open(request);
        if (!run || !run->prepare()) return std::fprintf(stderr, "the program cannot be run\n"), 2;
        const auto report = run->go();
        if (!report) return std::fprintf(stderr, "%s\n", report.error().message.c_str()), 2;
        std::printf("%3.0f %%: %.3f s\n", percent, report->cycle_time_s);
    }
    return 0;
}
