// What if a program never ends? Limits and a cancel flag end the run; the report says why, and has the
// results so far. g++ -std=c++20 10_time_limit.cpp $(pkg-config --cflags --libs libgsim) -o example &&
// ./example
#include <cstdio>

#include <gsim/engine/run.h>

int main() {
    using namespace gsim;
    engine::Request request;
    request.text = engine::Text("WHILE [1 EQ 1] DO1\nG1 X100 F6000\nG1 X0\nEND1\n", "endless.nc");
    request.language.dialect = "ab9";
    request.limits.machine_s = 60;
    auto run = engine::Run::open(request);
    if (!run) return std::fprintf(stderr, "%s\n", run.error().message.c_str()), 2;
    if (const auto prepared = run->prepare(); !prepared)
        return std::fprintf(stderr, "%s\n", prepared.error().message.c_str()), 1;
    const auto report = run->go();
    if (!report) return std::fprintf(stderr, "%s\n", report.error().message.c_str()), 2;
    std::printf("%s after %.1f s and %llu moves\n", std::string(name(report->status)).c_str(),
                report->cycle_time_s, static_cast<unsigned long long>(report->counts.moves));
    if (report->alarm) std::printf("%s\n", report->alarm->message.c_str());
    return 0;
}
