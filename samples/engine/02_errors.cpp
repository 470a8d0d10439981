// What is wrong with a program? Each error has a source location, a code for programs and a text for people.
// g++ -std=c++20 02_errors.cpp $(pkg-config --cflags --libs libgsim) -o example && ./example
#include <cstdio>

#include <gsim/engine/run.h>

int main() {
    using namespace gsim;
    engine::Request request;
    request.text = engine::Text("G0 X10 Y10\nG1 Q5 X20 F500\nG3 X30\nM2\n", "part.nc");
    auto run = engine::Run::open(request, [](const engine::Diagnostic& diagnostic) {
        std::printf("%s:%u:%u %s\n    %s\n", diagnostic.file.c_str(), diagnostic.line, diagnostic.column,
                    diagnostic.code.c_str(), diagnostic.text.c_str());
        if (!diagnostic.hint.empty()) std::printf("    hint: %s\n", diagnostic.hint.c_str());
    });
    if (!run) return std::fprintf(stderr, "%s\n", run.error().message.c_str()), 2;
    const auto prepared = run->prepare();
    if (prepared) return std::printf("no errors\n"), 0;
    std::printf("the program %s\n", prepared.error().in_program ? "has errors" : "was not read");
    return 0;
}
