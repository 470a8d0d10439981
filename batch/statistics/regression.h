#pragma once

#include <string>
#include <vector>

namespace gsim::batch {

/// Share of a metric's spread that follows a setting: regression on all settings at once, each in units of
/// its deviation (Saltelli and others 2008, 1.2.5). It covers only linear effects; `explained` is their
/// share.
struct Sensitivity {
    struct SettingEffect {
        std::string setting;
        double slope = 0;        ///< Slope of the metric per unit of the setting.
        double coefficient = 0;  ///< In deviations of the figure by one deviation of the setting: -1 to 1.
    };
    std::vector<SettingEffect> effects = {};
    double explained = 0;  ///< Share of the variance, 0 to 1.
};

/// Computes the sensitivity. `settings`: a list for each, as long as `samples`. Constant settings are left
/// out. The result is empty if the runs do not outnumber the settings, or the metric is constant.
Sensitivity regress(const std::vector<std::string>& names, const std::vector<std::vector<double>>& settings,
                    const std::vector<double>& samples);

}  // namespace gsim::batch
