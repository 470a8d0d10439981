// Which positions do the axes have at any time? Samples are exact: they come from the closed forms of the
// planned motion. g++ -std=c++20 03_trajectory.cpp $(pkg-config --cflags --libs libgsim) -o example &&
// ./example
#include <cstdio>

#include <gsim/engine/run.h>

int main() {
    using namespace gsim;
    engine::Request request;
    request.text = engine::Text("G1 X100 F6000\nG2 X200 Y100 I0 J100\nM2\n", "part.nc");
    auto run = engine::Run::open(request);
    if (!run || !run->prepare()) return std::fprintf(stderr, "the program cannot be run\n"), 2;
    std::printf("    t_s     x_mm     y_mm  speed_mm_s\n");
    const auto requested = run->on_samples(
        [](std::span<const engine::Sample> samples) {
            for (const engine::Sample& sample : samples)
                std::printf("%7.3f %8.3f %8.3f %11.3f\n", sample.t_s, sample.axes[0], sample.axes[1],
                            sample.speed_mm_s);
        },
        0.5);
    if (!requested) return std::fprintf(stderr, "%s\n", requested.error().message.c_str()), 2;
    return run->go() ? 0 : 2;
}
