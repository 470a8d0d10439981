#include "batch/plan/design.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <boost/random/sobol.hpp>

#include "batch/plan/random.h"

namespace gsim::batch {

namespace {

/// Returns a uniformly distributed number below `count`.
std::size_t random_index(Random& random, std::size_t count) {
    return static_cast<std::size_t>(uniform_random(random) * static_cast<double>(count));
}

std::vector<double> random_shares(std::size_t settings, std::uint64_t runs, std::uint64_t seed) {
    Random random(seed);
    std::vector<double> shares(settings * runs);
    std::generate(shares.begin(), shares.end(), [&] { return uniform_random(random); });
    return shares;
}

/// McKay, Beckman, Conover 1979: shuffles the intervals of each setting, and draws a random position in each.
std::vector<double> latin_hypercube_shares(std::size_t settings, std::uint64_t runs, std::uint64_t seed) {
    Random random(seed);
    std::vector<double> shares(settings * runs);
    std::vector<std::uint64_t> parts(runs);
    for (std::size_t setting = 0; setting < settings; ++setting) {
        std::iota(parts.begin(), parts.end(), std::uint64_t{0});
        for (std::size_t remaining = parts.size(); remaining > 1; --remaining)
            std::swap(parts[remaining - 1], parts[random_index(random, remaining)]);
        for (std::uint64_t run = 0; run < runs; ++run)
            shares[run * settings + setting] =
                (static_cast<double>(parts[run]) + uniform_random(random)) / static_cast<double>(runs);
    }
    return shares;
}

/// Uses the numbers of Joe and Kuo with one common random shift (modulo 1), so that other seeds are other
/// designs. Starts with the second point, because before the shift the first one is 0 in all dimensions.
std::vector<double> sobol_shares(std::size_t settings, std::uint64_t runs, std::uint64_t seed) {
    if (settings == 0) return {};
    boost::random::sobol sequence(settings);
    Random random(seed);
    std::vector<double> shift(settings);
    std::generate(shift.begin(), shift.end(), [&] { return uniform_random(random); });
    constexpr double kSteps = 18446744073709551616.0;  // 2^64
    std::vector<double> shares(settings * runs);
    for (std::size_t i = 0; i < shares.size(); ++i) {
        const double share = static_cast<double>(sequence()) / kSteps + shift[i % settings];
        shares[i] = share - std::floor(share);
    }
    return shares;
}

std::size_t value_count(const Setting& setting) {
    return std::get<Choices>(setting.domain).values.size();
}

}  // namespace

Design::Design(std::vector<Setting> settings, const DesignOptions& options)
    : settings_(std::move(settings)), sampling_(options.sampling) {
    if (sampling_ == Sampling::grid) {
        for (const Setting& setting : settings_) size_ *= value_count(setting);
        return;
    }
    if (sampling_ == Sampling::listed) {
        listed_ = options.listed;
        size_ = listed_.size();
        return;
    }
    size_ = options.runs;
    switch (sampling_) {
        case Sampling::random: shares_ = random_shares(settings_.size(), size_, options.seed); break;
        case Sampling::latin_hypercube:
            shares_ = latin_hypercube_shares(settings_.size(), size_, options.seed);
            break;
        case Sampling::sobol: shares_ = sobol_shares(settings_.size(), size_, options.seed); break;
        case Sampling::listed:
        case Sampling::grid: break;
    }
}

std::vector<SettingValue> Design::variant(std::uint64_t number) const {
    if (sampling_ == Sampling::grid) return grid_variant(number);
    if (sampling_ == Sampling::listed) return listed_[number];
    std::vector<SettingValue> values;
    for (std::size_t i = 0; i < settings_.size(); ++i)
        add_values(settings_[i], value_at(settings_[i].domain, shares_[number * settings_.size() + i]),
                   values);
    return values;
}

// The last setting changes fastest.
std::vector<SettingValue> Design::grid_variant(std::uint64_t number) const {
    std::vector<std::size_t> value_indices(settings_.size());
    for (std::size_t i = settings_.size(); i-- > 0;) {
        const std::size_t count = value_count(settings_[i]);
        value_indices[i] = number % count;
        number /= count;
    }
    std::vector<SettingValue> values;
    for (std::size_t i = 0; i < settings_.size(); ++i)
        add_values(settings_[i], std::get<Choices>(settings_[i].domain).values[value_indices[i]], values);
    return values;
}

}  // namespace gsim::batch
