// Does a program stay within the travel of a machine? The report lists every violation, and the run
// continues. g++ -std=c++20 06_axis_limits.cpp $(pkg-config --cflags --libs libgsim) -o example && ./example
// MACHINE.toml
#include <cstdio>

#include <gsim/engine/run.h>

int main(int argc, char** argv) {
    using namespace gsim;
    if (argc != 2) return std::fprintf(stderr, "usage: example MACHINE.toml\n"), 2;
    engine::Request request;
    request.machine = argv[1];
    request.text = engine::Text("G0 X50 Y50\nG1 Y5000 F3000\nG1 X-20\nM2\n", "part.nc");
    auto run = engine::Run::open(request);
    if (!run) return std::fprintf(stderr, "%s\n", run.error().message.c_str()), 2;
    if (const auto prepared = run->prepare(); !prepared)
        return std::fprintf(stderr, "%s\n", prepared.error().message.c_str()), 1;
    const auto report = run->go();
    if (!report) return std::fprintf(stderr, "%s\n", report.error().message.c_str()), 2;
    for (const engine::Violation& violation : report->violations)
        std::printf("line %u: %c reaches %g, the limit is %g\n", violation.location.line, violation.axis,
                    violation.value, violation.limit);
    if (report->alarm)
        std::printf("alarm %s: %s\n", report->alarm->code.c_str(), report->alarm->message.c_str());
    for (const engine::AxisRange& range : report->ranges)
        std::printf("%c moves from %g to %g, of %g to %g\n", range.letter, range.min, range.max,
                    range.limit_min, range.limit_max);
    return 0;
}
