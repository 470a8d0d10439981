#include "engine/src/machine/key_order.h"

#include <algorithm>
#include <utility>

#include "collision/cell/cell_guide.h"
#include "machine/schema/key_guide.h"

namespace gsim::engine {

namespace {

using machine::GuideKey;
using machine::GuideTable;
using nlohmann::ordered_json;
using KeyPlace = std::vector<std::string>;

std::vector<GuideTable> all_tables() {
    std::vector<GuideTable> tables = machine::machine_guide();
    for (GuideTable& table : cell::cell_guide()) tables.push_back(std::move(table));
    return tables;
}

class KeyOrder {
  public:
    ordered_json ordered(const ordered_json& value, const KeyPlace& at) const {
        if (!value.is_structured()) return value;
        if (value.is_array()) {
            auto list = ordered_json::array();
            for (const ordered_json& each : value) list.push_back(ordered(each, at));
            return list;
        }
        auto object = ordered_json::object();
        if (const GuideTable* table = table_of(value, at)) {
            for (const GuideKey& key : table->keys) take(value, key.name, at, object);
        }
        for (const auto& [key, inner] : value.items()) take(value, key, at, object);
        return object;
    }

  private:
    void take(const ordered_json& from, const std::string& key, KeyPlace at, ordered_json& to) const {
        const auto found = from.find(key);
        if (found == from.end() || to.contains(key)) return;
        at.push_back(key);
        to[key] = ordered(*found, at);
    }

    /// Returns, of all tables with one name, the one that has most of an object's keys.
    const GuideTable* table_of(const ordered_json& object, const KeyPlace& at) const {
        const GuideTable* best = nullptr;
        std::ptrdiff_t most = 0;
        for (const GuideTable& table : tables_) {
            const auto has = [&](const GuideKey& key) { return object.contains(key.name); };
            const auto known = std::count_if(table.keys.begin(), table.keys.end(), has);
            if (table.at != at || known <= most) continue;
            best = &table;
            most = known;
        }
        return best;
    }

    std::vector<GuideTable> tables_ = all_tables();
};

}  // namespace

ordered_json in_key_order(const ordered_json& value, const KeyPlace& at) {
    return value.is_structured() ? KeyOrder().ordered(value, at) : value;
}

}  // namespace gsim::engine
