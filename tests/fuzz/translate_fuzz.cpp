// libFuzzer's program: any bytes are a part program.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include <fmt/format.h>

#include "tests/fuzz/translation_check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view gcode(reinterpret_cast<const char*>(data), size);
    if (const auto broken = gsim::fuzz::broken_promise(gcode)) {
        fmt::print(stderr, "translate_fuzz: {}\n", *broken);
        std::abort();
    }
    return 0;
}
