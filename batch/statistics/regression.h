#pragma once

#include <string>
#include <vector>

namespace gsim::batch {

/// How much of a figure's spread goes with a setting: regression on all settings at once, each in units of
/// its own deviation (Saltelli and others 2008, 1.2.5). It tells what a straight line can; `explained` says
/// how much that is.
struct Sensitivity {
    struct Part {
        std::string setting;
        double slope = 0;        ///< Of the figure, by the setting's own unit.
        double coefficient = 0;  ///< In deviations of the figure by one deviation of the setting: -1 to 1.
    };
    std::vector<Part> parts = {};
    double explained = 0;  ///< Share of the variance, 0 to 1.
};

/// `settings`: a list for each, as long as `figures`. Those that do not differ are left out; nothing where
/// there are no more runs than settings, or the figure is the same in all.
Sensitivity regress(const std::vector<std::string>& names, const std::vector<std::vector<double>>& settings,
                    const std::vector<double>& figures);

}  // namespace gsim::batch
