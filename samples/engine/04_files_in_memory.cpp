// Can a server run programs without files? The library reads all of its files from a function of the caller.
// g++ -std=c++20 04_files_in_memory.cpp $(pkg-config --cflags --libs libgsim) -o example && ./example
#include <cstdio>
#include <map>

#include <gsim/engine/run.h>

int main() {
    using namespace gsim;
    const std::map<std::string, std::string> files = {
        {"part.nc", "G0 X0 Y0\nM98 P7\nM98 P7\nM2\n"},
        {"O0007.nc", "O7\nG91 G1 X60 F600\nG90\nM99\n"},
    };
    engine::Request request;
    request.program = "part.nc";
    request.host.files = engine::Files::given([&](const std::string& name) -> std::optional<std::string> {
        const auto file = files.find(name);
        if (file == files.end()) return std::nullopt;
        return file->second;
    });
    auto run = engine::Run::open(request);
    if (!run) return std::fprintf(stderr, "%s\n", run.error().message.c_str()), 2;
    if (const auto prepared = run->prepare(); !prepared)
        return std::fprintf(stderr, "%s\n", prepared.error().message.c_str()), 1;
    run->on_moves([](std::span<const engine::Move> moves) {
        for (const engine::Move& move : moves)
            std::printf("%s:%u ends at X%g\n", std::string(move.file).c_str(), move.line, move.end[0]);
    });
    return run->go() ? 0 : 2;
}
