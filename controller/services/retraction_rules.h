#pragma once

namespace gsim::rrs {

/// Retraction of the filament by G10 and G11 of the dialect `klipper`.
struct RetractionRules {
    double length_mm = 0;  ///< Distance by which G10 retracts; 0: the controller does not.
    double speed_mm_s = 20;
    /// Additional distance by which G11 pushes the filament farther than G10 retracted it.
    double unretract_extra_length_mm = 0;
    double unretract_speed_mm_s = 10;

    bool operator==(const RetractionRules&) const = default;
};

}  // namespace gsim::rrs
