// What does a program mean? The translation to Lua is a script that people can read and change.
// g++ -std=c++20 05_translate.cpp $(pkg-config --cflags --libs libgsim) -o example && ./example
#include <cstdio>

#include <gsim/engine/translation.h>

int main() {
    using namespace gsim;
    engine::TranslationRequest request;
    request.text =
        engine::Text("#1 = 10\nWHILE [#1 GT 0] DO1\nG1 X#1 F500\n#1 = [#1 - 2.5]\nEND1\nM2\n", "part.nc");
    request.language.dialect = "ab9";
    request.annotate = true;
    auto translation = engine::Translation::open(request);
    if (!translation) return std::fprintf(stderr, "%s\n", translation.error().message.c_str()), 2;
    const auto made = translation->make(
        [](const engine::Diagnostic& diagnostic) { std::fprintf(stderr, "%s\n", diagnostic.text.c_str()); });
    if (!made) return std::fprintf(stderr, "%s\n", made.error().message.c_str()), 1;
    const auto written = translation->write([](std::string_view part) {
        return std::fwrite(part.data(), 1, part.size(), stdout) == part.size();
    });
    return written ? 0 : 2;
}
