#include "tests/accuracy/operator_inputs.h"

#include <algorithm>
#include <charconv>
#include <map>

#include <fmt/format.h>

namespace gsim::accuracy {

namespace {

struct Percents {
    double feed = 100;
    double rapid = 100;
};

// Applies a byte and returns true if it changes an override.
bool turn(std::string_view byte, Percents& percents) {
    if (byte == "0x90") {
        percents.feed = 100;
    } else if (byte == "0x91") {
        percents.feed += 10;
    } else if (byte == "0x92") {
        percents.feed -= 10;
    } else if (byte == "0x93") {
        percents.feed += 1;
    } else if (byte == "0x94") {
        percents.feed -= 1;
    } else if (byte == "0x95") {
        percents.rapid = 100;
    } else if (byte == "0x96") {
        percents.rapid = 50;
    } else if (byte == "0x97") {
        percents.rapid = 25;
    } else {
        return false;
    }
    percents.feed = std::clamp(percents.feed, 10.0, 200.0);
    return true;
}

}  // namespace

Result<std::string> overrides_of(std::string_view inputs) {
    Percents percents;
    std::map<double, Percents> changes;
    while (!inputs.empty()) {
        const std::string_view input = inputs.substr(0, inputs.find(';'));
        inputs.remove_prefix(std::min(input.size() + 1, inputs.size()));
        const std::size_t colon = input.find(':');
        double at_s = 0;
        const auto read = std::from_chars(input.data(), input.data() + std::min(colon, input.size()), at_s);
        if (colon == std::string_view::npos || read.ec != std::errc())
            return Unexpected(fmt::format("'{}' is no input at a time", input));
        if (!turn(input.substr(colon + 1), percents))
            return Unexpected(fmt::format("'{}' is none that turns an override", input.substr(colon + 1)));
        changes[at_s] = percents;
    }
    std::string text;
    for (const auto& [at_s, now] : changes)
        text += fmt::format("[[override]]\nat_s = {:.6f}\nfeed_percent = {:.1f}\nrapid_percent = {:.1f}\n\n",
                            at_s, now.feed, now.rapid);
    return text;
}

}  // namespace gsim::accuracy
