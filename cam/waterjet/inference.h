#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gsim::waterjet {

enum class Origin {
    given,      ///< By whoever asked for the plan.
    from_file,  ///< It stands in the materials file.
    inferred,   ///< From other values, by a rule.
};

/// "given", "file", "inferred".
std::string_view origin_name(Origin origin);

/// A value of a plan and where it comes from.
struct SettledValue {
    std::string_view name;  ///< As the option or key is called.
    std::string_view unit;  ///< Empty where there is none.
    double value = 0;
    Origin origin = Origin::given;
    std::string basis;  ///< From what it was inferred, or the file's own source; may be empty.
};

/// What a rule makes of other values, and the words for that.
struct Inferred {
    double value = 0;
    std::string basis;
};

/// Settles values one by one, from the best source that there is, and keeps the list.
class Settlement {
  public:
    double given(std::string_view name, std::string_view unit, double value);
    double from_file(std::string_view name, std::string_view unit, double value, std::string basis);
    double inferred(std::string_view name, std::string_view unit, Inferred value);

    /// What was given; else what the file has; else what the rule `infer()` makes of others.
    template <typename Rule>
    double settle(std::string_view name, std::string_view unit, const std::optional<double>& asked,
                  const std::optional<double>& file_value, Rule infer) {
        if (asked) return given(name, unit, *asked);
        if (file_value) return from_file(name, unit, *file_value, {});
        return inferred(name, unit, infer());
    }

    std::vector<SettledValue> take() { return std::move(values_); }

  private:
    std::vector<SettledValue> values_;
};

}  // namespace gsim::waterjet
