#pragma once

#include <deque>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "controller/services/types.h"

namespace gsim::rrs {

/// Values of any kind of parameter.
class ServiceValues {
  public:
    explicit ServiceValues(unsigned seed) : random_(seed) {}

    template <typename Parameter>
    auto next() {
        using Value = std::remove_cvref_t<Parameter>;
        if constexpr (std::is_enum_v<Value> || std::is_same_v<Value, bool>) {
            return static_cast<Value>(random_() % 2);
        } else if constexpr (std::is_integral_v<Value>) {
            return static_cast<Value>(random_() % 10);
        } else {
            return make(std::type_identity<Value>());
        }
    }

  private:
    double number() { return std::uniform_real_distribution<>(-100, 100)(random_); }

    double make(std::type_identity<double>) { return number(); }
    std::string_view make(std::type_identity<std::string_view>) {
        texts_.push_back("text " + std::to_string(random_()));
        return texts_.back();
    }
    CartPos make(std::type_identity<CartPos>) {
        CartPos pose = CartPos::Identity();
        pose.translation() = make(std::type_identity<Eigen::Vector3d>());
        pose.rotate(Eigen::AngleAxisd(number(), Eigen::Vector3d::UnitY()));
        return pose;
    }
    JointPos make(std::type_identity<JointPos>) {
        JointPos joints = JointPos::Zero(5);
        for (double& joint : joints) joint = number();
        return joints;
    }
    Eigen::Vector3d make(std::type_identity<Eigen::Vector3d>) {
        Eigen::Vector3d vector;
        for (double& value : vector) value = number();
        return vector;
    }
    std::span<const int> make(std::type_identity<std::span<const int>>) { return joints_; }
    std::span<const double> make(std::type_identity<std::span<const double>>) { return speeds_; }

    std::mt19937 random_;
    std::deque<std::string> texts_;
    std::vector<int> joints_{3, 0};
    std::vector<double> speeds_{1.5, 2.5};
};

}  // namespace gsim::rrs
