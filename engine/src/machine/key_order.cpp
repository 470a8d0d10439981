#include "engine/src/machine/key_order.h"

#include <algorithm>
#include <utility>

#include "collision/cell/cell_schema.h"
#include "machine/schema/key_schema.h"

namespace gsim::engine {

namespace {

using machine::KeySchema;
using machine::TableSchema;
using nlohmann::ordered_json;
using KeyPath = std::vector<std::string>;

std::vector<TableSchema> all_tables() {
    std::vector<TableSchema> tables = machine::machine_schema();
    for (TableSchema& table : cell::cell_schema()) tables.push_back(std::move(table));
    return tables;
}

class KeyOrder {
  public:
    ordered_json reorder_keys(const ordered_json& value, const KeyPath& at) const {
        if (!value.is_structured()) return value;
        if (value.is_array()) {
            auto list = ordered_json::array();
            for (const ordered_json& each : value) list.push_back(reorder_keys(each, at));
            return list;
        }
        auto object = ordered_json::object();
        if (const TableSchema* table = find_guide_table(value, at)) {
            for (const KeySchema& key : table->keys) move_key(value, key.name, at, object);
        }
        for (const auto& [key, child] : value.items()) move_key(value, key, at, object);
        return object;
    }

  private:
    void move_key(const ordered_json& from, const std::string& key, KeyPath at, ordered_json& to) const {
        const auto found = from.find(key);
        if (found == from.end() || to.contains(key)) return;
        at.push_back(key);
        to[key] = reorder_keys(*found, at);
    }

    /// Returns, of all tables with one name, the one that has most of an object's keys.
    const TableSchema* find_guide_table(const ordered_json& object, const KeyPath& at) const {
        const TableSchema* best = nullptr;
        std::ptrdiff_t max = 0;
        for (const TableSchema& table : tables_) {
            const auto has = [&](const KeySchema& key) { return object.contains(key.name); };
            const auto known = std::count_if(table.keys.begin(), table.keys.end(), has);
            if (table.at != at || known <= max) continue;
            best = &table;
            max = known;
        }
        return best;
    }

    std::vector<TableSchema> tables_ = all_tables();
};

}  // namespace

ordered_json sort_keys(const ordered_json& value, const KeyPath& at) {
    return value.is_structured() ? KeyOrder().reorder_keys(value, at) : value;
}

}  // namespace gsim::engine
