// How does a drawing become a part program? It becomes a path, and a post-processor writes the path as
// G-code. g++ -std=c++20 08_drawing_to_gcode.cpp $(pkg-config --cflags --libs libgsim) -o example &&
// ./example DRAWING
#include <cstdio>

#include <gsim/engine/drawing_path.h>
#include <gsim/engine/path_translation.h>

int main(int argc, char** argv) {
    using namespace gsim;
    if (argc != 2) return std::fprintf(stderr, "usage: example DRAWING.svg\n"), 2;
    engine::DrawingRequest drawing;
    drawing.drawing = argv[1];
    drawing.cutting.speed_mm_min = 1200;
    drawing.cutting.kerf_mm = 1;
    drawing.cutting_path.origin_mm = {100, 100, 0};  // position of the origin of the drawing
    auto cuts = engine::DrawingPath::open(drawing);
    if (!cuts) return std::fprintf(stderr, "%s\n", cuts.error().message.c_str()), 2;
    if (const auto read = cuts->read(); !read)
        return std::fprintf(stderr, "%s\n", read.error().message.c_str()), 1;
    if (const auto made = cuts->make(); !made)
        return std::fprintf(stderr, "%s\n", made.error().message.c_str()), 1;
    std::string path_file;
    cuts->write([&](std::string_view part) { return path_file.append(part), true; });

    engine::PathRequest path;
    path.path = "part.json";
    path.bytes = [&path_file, at = std::size_t{0}](char* buffer, std::size_t size) mutable {
        const std::size_t count = path_file.copy(buffer, size, at);
        at += count;
        return count;
    };
    path.post = "rs274ngc";
    auto program = engine::PathTranslation::open(path);
    if (!program) return std::fprintf(stderr, "%s\n", program.error().message.c_str()), 2;
    if (const auto read = program->read(); !read)
        return std::fprintf(stderr, "%s\n", read.error().message.c_str()), 1;
    if (const auto planned = program->plan(); !planned)
        return std::fprintf(stderr, "%s\n", planned.error().message.c_str()), 1;
    const auto written = program->write([](const std::string&) -> engine::TextSink {
        return [](std::string_view part) {
            return std::fwrite(part.data(), 1, part.size(), stdout) == part.size();
        };
    });
    return written ? 0 : 2;
}
