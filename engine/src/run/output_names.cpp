#include <algorithm>
#include <iterator>

#include "engine/run.h"

namespace gsim::engine {

namespace {

struct OutputName {
    OutputKind output_kind;
    const char* word;
};

constexpr OutputName kOutputNames[] = {
#define GSIM_DOCUMENT(name, number, option, help, ...) {OutputKind::name, #name},
#include "engine/outputs.def"
};

}  // namespace

std::vector<std::string> output_names() {
    std::vector<OutputName> words(std::begin(kOutputNames), std::end(kOutputNames));
    std::sort(words.begin(), words.end(),
              [](const OutputName& a, const OutputName& b) { return a.output_kind < b.output_kind; });
    std::vector<std::string> names;
    names.reserve(words.size());
    for (const OutputName& each : words) names.emplace_back(each.word);
    return names;
}

std::optional<OutputKind> find_output(std::string_view name) {
    for (const OutputName& each : kOutputNames) {
        if (each.word == name) return each.output_kind;
    }
    return std::nullopt;
}

}  // namespace gsim::engine
