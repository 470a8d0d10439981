// write_parts FOLDER PATH-FILE: writes the parts that are not flat as STEP files, for samples/parts.

#include <STEPControl_Writer.hxx>
#include <cstdio>
#include <filesystem>

#include "tests/cam/solid/part_models.h"

int main(int argc, char** argv) {
    using namespace gsim::solid::models;
    if (argc != 3) return 2;
    const std::filesystem::path folder = argv[1];
    const auto write = [&](const char* name, const TopoDS_Shape& shape) {
        STEPControl_Writer writer;
        return writer.Transfer(shape, STEPControl_AsIs) == IFSelect_RetDone &&
               writer.Write((folder / name).c_str()) == IFSelect_RetDone;
    };
    return write("wheel.step", wheel(argv[2])) && write("bracket.step", bracket()) &&
                   write("frustum.step", frustum())
               ? 0
               : 1;
}
