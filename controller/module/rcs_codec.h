#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include "controller/module/rcs_host.h"
#include "controller/module/rcs_module.h"
#include "controller/module/rcs_values.h"

// Inputs and outputs of services, as the structures of rcs_module.h and as methods of Shell have them. A
// structure is described here by its fields, in the order of the values that they represent.
namespace gsim::rrs {

/// Represents the missing input or output of a service.
struct gsim_rcs_none {};

/// Reason why a value does not fit in its field.
struct Misfit {
    std::string_view subject;  ///< "The name of the frame"; empty: the service.
    std::string_view fault;    ///< Remainder of the message: "is too long".
};

namespace codec {

/// A text, and its name in messages.
template <typename Place>
struct Text {
    Place& place;
    std::string_view what;
};

/// A list and its count; Value is const if it is read.
template <typename Value, typename Count>
struct List {
    Value* values;
    Count& count;
};

template <typename Place>
Text<Place> text(Place& place, std::string_view what) {
    return {place, what};
}

template <typename Value, std::size_t size, typename Count>
List<Value, Count> list(Value (&values)[size], Count& count) {
    static_assert(size == GSIM_RCS_MAX_JOINTS);
    return {values, count};
}

// Fields of each structure; `s` is const if they are read.
#define GSIM_RCS_FIELDS(structure, ...)                            \
    template <typename Place>                                      \
    requires std::is_same_v<std::remove_const_t<Place>, structure> \
    auto fields(Place& s) {                                        \
        return std::tuple_cat(__VA_ARGS__);                        \
    }
template <typename Place>
requires std::is_same_v<std::remove_const_t<Place>, gsim_rcs_none> std::tuple<> fields(Place& /*s*/) {
    return {};
}
GSIM_RCS_FIELDS(gsim_rcs_number, std::tie(s.value))
GSIM_RCS_FIELDS(gsim_rcs_integer, std::tie(s.value))
GSIM_RCS_FIELDS(gsim_rcs_joints, std::tie(s))
GSIM_RCS_FIELDS(gsim_rcs_pose, std::tie(s))
GSIM_RCS_FIELDS(gsim_rcs_pose_and_joints, std::tie(s.pose, s.joints))
GSIM_RCS_FIELDS(gsim_rcs_frame, std::tuple(text(s.name, "The name of the frame")), std::tie(s.pose))
GSIM_RCS_FIELDS(gsim_rcs_work_frames,
                std::tuple(text(s.tool, "The name of the frame"), text(s.object, "The name of the frame")))
GSIM_RCS_FIELDS(gsim_rcs_position, std::tie(s.pose, s.joints),
                std::tuple(text(s.configuration, "The configuration")))
GSIM_RCS_FIELDS(gsim_rcs_target, std::tie(s.id, s.param), fields(s.position), std::tie(s.param_value),
                std::tuple(text(s.name, "The name of the target")))
GSIM_RCS_FIELDS(gsim_rcs_arc_target, std::tie(s.id, s.center_mm, s.axis, s.sweep_rad), fields(s.end))
GSIM_RCS_FIELDS(gsim_rcs_rest, std::tie(s.id, s.rest_s))
GSIM_RCS_FIELDS(gsim_rcs_joint_values,
                std::tuple(list(s.joints, s.joint_count), list(s.values, s.value_count)))
GSIM_RCS_FIELDS(gsim_rcs_ramp_limits, std::tie(s.limit), fields(s.values))
GSIM_RCS_FIELDS(gsim_rcs_parameter_value, std::tie(s.number, s.joint, s.value))
GSIM_RCS_FIELDS(gsim_rcs_event_definition, std::tie(s.event, s.target, s.offset_s))
GSIM_RCS_FIELDS(gsim_rcs_path_event_definition, std::tie(s.event, s.target, s.offset_mm))
GSIM_RCS_FIELDS(gsim_rcs_tracking, std::tie(s.conveyor, s.on))
GSIM_RCS_FIELDS(gsim_rcs_conveyor, std::tie(s.conveyor, s.direction, s.speed_mm_s))
GSIM_RCS_FIELDS(gsim_rcs_object_target, std::tie(s.id, s.pose))
GSIM_RCS_FIELDS(gsim_rcs_path_mode, std::tie(s.mode, s.tolerance_mm, s.merge_tolerance_mm))
GSIM_RCS_FIELDS(gsim_rcs_tip_control, std::tie(s.on, s.tip_mm))
GSIM_RCS_FIELDS(gsim_rcs_message, std::tuple(text(s.text, "The message")))
GSIM_RCS_FIELDS(gsim_rcs_step, std::tie(s.joints, s.pose, s.elapsed_s))
GSIM_RCS_FIELDS(gsim_rcs_object_step, std::tie(s.pose, s.elapsed_s))
GSIM_RCS_FIELDS(gsim_rcs_event, std::tie(s.event, s.time_s))
GSIM_RCS_FIELDS(gsim_rcs_target_id, std::tie(s.id))
#undef GSIM_RCS_FIELDS

// put_in() fills a field, taken_from() reads it.

template <typename Field, typename Value>
requires std::is_arithmetic_v<Field> std::optional<Misfit> put_in(
    Field& field, const Value& value) {  // also switches, enumerations
    field = static_cast<Field>(value);
    return std::nullopt;
}

inline std::optional<Misfit> put_in(gsim_rcs_pose& field, const CartPos& pose) {
    field = to_rcs(pose);
    return std::nullopt;
}

inline std::optional<Misfit> put_in(gsim_rcs_joints& field, const JointPos& joints) {
    field = to_rcs(joints);
    return std::nullopt;
}

inline std::optional<Misfit> put_in(double (&field)[3], const Eigen::Vector3d& vector) {
    std::copy(vector.begin(), vector.end(), field);
    return std::nullopt;
}

template <typename Place>
std::optional<Misfit> put_in(const Text<Place>& field, std::string_view value) {
    if (put_text(value, field.place)) return std::nullopt;
    return Misfit{field.what, "is too long"};
}

template <typename Value, typename Count>
std::optional<Misfit> put_in(const List<Value, Count>& field, std::span<const Value> values) {
    static_assert(GSIM_RCS_MAX_JOINTS == 16);
    if (values.size() > GSIM_RCS_MAX_JOINTS) return Misfit{{}, "takes at most 16 values"};
    field.count = static_cast<Count>(values.size());
    std::copy(values.begin(), values.end(), field.values);
    return std::nullopt;
}

template <typename Field>
requires std::is_arithmetic_v<Field> Field taken_from(const Field& field) {
    return field;
}

inline CartPos taken_from(const gsim_rcs_pose& field) {
    return from_rcs(field);
}

inline JointPos taken_from(const gsim_rcs_joints& field) {
    return from_rcs(field);
}

inline Eigen::Vector3d taken_from(const double (&field)[3]) {
    return Eigen::Vector3d(field);
}

template <typename Place>
std::string taken_from(const Text<Place>& field) {
    return rcs_text(field.place, sizeof field.place);
}

template <typename Value, typename Count>
std::span<Value> taken_from(const List<Value, Count>& field) {
    return std::span<Value>(field.values, static_cast<std::size_t>(field.count));
}

template <typename Field>
bool is_sound(const Field& /*field*/) {
    return true;
}

template <typename Value, typename Count>
bool is_sound(const List<Value, Count>& field) {
    return field.count >= 0 && field.count <= GSIM_RCS_MAX_JOINTS;
}

/// True for a parameter's value without a joint, which the C structure still contains.
template <typename Place, std::size_t count>
inline constexpr bool kWithoutJoint = std::is_same_v<Place, gsim_rcs_parameter_value>&& count == 2;

}  // namespace codec

/// Fills a structure from values, in their order. Further fields stay as they are, because services may share
/// a structure. Returns an error for a value that does not fit.
template <typename Place, typename... Values>
std::optional<Misfit> put(Place& place, const Values&... values) {
    if constexpr (codec::kWithoutJoint<Place, sizeof...(values)>) {
        return [&](int number, double value) { return put(place, number, 0, value); }(values...);
    } else {
        auto fields = codec::fields(place);
        static_assert(sizeof...(values) <= std::tuple_size_v<decltype(fields)>);
        std::optional<Misfit> misfit;
        [&]<std::size_t... at>(std::index_sequence<at...>) {
            ((misfit = misfit ? misfit : codec::put_in(std::get<at>(fields), values)), ...);
        }
        (std::index_sequence_for<Values...>());
        return misfit;
    }
}

/// Returns the first `count` values of a structure; none if it has a count out of range.
template <std::size_t count, typename Place>
auto take(const Place& place) {
    const auto fields = codec::fields(place);
    const auto values = [&]<std::size_t... at>(std::index_sequence<at...>) {
        using Taken = std::tuple<decltype(codec::taken_from(std::get<at>(fields)))...>;
        const bool sound = (codec::is_sound(std::get<at>(fields)) && ...);
        return sound ? std::optional<Taken>(Taken(codec::taken_from(std::get<at>(fields))...)) : std::nullopt;
    };
    if constexpr (codec::kWithoutJoint<Place, count>) {
        return values(std::index_sequence<0, 2>());
    } else {
        return values(std::make_index_sequence<count>());
    }
}

}  // namespace gsim::rrs
