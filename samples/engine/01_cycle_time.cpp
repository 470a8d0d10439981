// How long does a program take on a machine, and what is the time of each move?
// g++ -std=c++20 01_cycle_time.cpp $(pkg-config --cflags --libs libgsim) -o example && ./example
#include <cstdio>

#include <gsim/engine/run.h>

int main() {
    using namespace gsim;
    engine::Request request;  // the built-in machine, because the request names no other one
    request.text = engine::Text("G0 X100 Y50\nG1 X300 F6000\nG2 X400 Y150 I0 J100\nM2\n", "part.nc");
    auto run = engine::Run::open(request);
    if (!run) return std::fprintf(stderr, "%s\n", run.error().message.c_str()), 2;
    if (const auto prepared = run->prepare(); !prepared)
        return std::fprintf(stderr, "%s\n", prepared.error().message.c_str()), 1;
    run->on_moves([](std::span<const engine::Move> moves) {
        for (const engine::Move& move : moves)
            std::printf("line %u: %.3f mm in %.3f s\n", move.line, move.length_mm, move.end_s - move.start_s);
    });
    const auto report = run->go();
    if (!report) return std::fprintf(stderr, "%s\n", report.error().message.c_str()), 2;
    std::printf("%s: %.3f s\n", std::string(name(report->status)).c_str(), report->cycle_time_s);
    return report->is_clean() ? 0 : 1;
}
