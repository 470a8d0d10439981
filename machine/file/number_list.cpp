#include "machine/file/number_list.h"

#include "base/text/format.h"
#include "base/toml/toml_writer.h"

namespace gsim::machine {

std::optional<std::vector<double>> read_numbers(base::TomlSection& section, const toml::table& table,
                                                std::string_view key, std::string_view meaning,
                                                std::initializer_list<std::size_t> counts) {
    if (!section.has(key)) return std::nullopt;
    const toml::array* array = table.get_as<toml::array>(key);
    bool read = array != nullptr && (counts.size() == 0 ||
                                     std::find(counts.begin(), counts.end(), array->size()) != counts.end());
    std::vector<double> numbers;
    for (std::size_t i = 0; read && i < array->size(); ++i) {
        const toml::node* node = array->get(i);
        const auto value = node->is_number() ? node->value<double>() : std::nullopt;
        read = value && std::abs(*value) <= kMaxFileValue;
        numbers.push_back(value.value_or(0));
    }
    if (read) return numbers;
    section.fail(key, fmt::format("'{}' must be {}, numbers between -1e9 and 1e9", key, meaning));
    return std::nullopt;
}

std::string number_list(std::span<const double> numbers) {
    std::vector<std::string> texts;
    texts.reserve(numbers.size());
    for (const double number : numbers) texts.push_back(base::toml_number(number));
    return fmt::format("[{}]", text::joined(texts, ", "));
}

}  // namespace gsim::machine
