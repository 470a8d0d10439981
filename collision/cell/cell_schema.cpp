#include "collision/cell/cell_schema.h"

#include <string>
#include <utility>

namespace gsim::cell {

namespace {

using machine::choice_key;
using machine::KeyKind;
using machine::KeySchema;
using machine::list_key;
using machine::number_key;
using machine::required;
using machine::table_key;
using machine::TableSchema;
using machine::text_key;

TableSchema cell_file_table() {
    return {
        .at = {},
        .meaning = "the cell file",
        .keys = {required(table_key("cell", "name of the cell, and its machine")),
                 list_key("frame", KeyKind::table, 0, "named frames"),
                 list_key("object", KeyKind::table, 0, "cell file: the surroundings of the machine"),
                 list_key("shape", KeyKind::table, 0, "bodies on parts of the machine"),
                 list_key("ignore", KeyKind::list, 0, "pairs of objects or shapes that may touch"),
                 list_key("robot", KeyKind::table, 0, "robots, if this file is also a robots file"),
                 list_key("conveyor", KeyKind::table, 0, "conveyors, if this file is also a robots file")}};
}

KeySchema name() {
    return required(text_key("name", "", "a unique name"));
}

KeySchema attached_to() {
    return text_key("attached_to", "\"world\"",
                    "\"world\", a frame or an object above, a conveyor, \"base\", the letter of an axis, "
                    "\"tool\" or \"work\"");
}

KeySchema form() {
    return required(table_key("shape", "one of box_mm, cylinder_mm, capsule_mm, sphere_mm and mesh"));
}

KeySchema position_keys() {
    return table_key("frame", "its pose relative to the frame to which it is attached");
}

TableSchema table_schema(std::string kind, std::string meaning, std::vector<KeySchema> keys) {
    return {.at = {std::move(kind)}, .many = true, .meaning = std::move(meaning), .keys = std::move(keys)};
}

TableSchema within(std::string kind, std::string key, std::string meaning, std::vector<KeySchema> keys) {
    TableSchema table = table_schema(std::move(kind), std::move(meaning), std::move(keys));
    table.at.push_back(std::move(key));
    return table;
}

}  // namespace

std::vector<TableSchema> cell_schema() {
    return {
        cell_file_table(),
        {.at = {"cell"},
         .meaning = "the cell",
         .keys = {required(text_key("name", "", "for reports")),
                  text_key("machine", "",
                           "machine file, relative to the folder of this file; used if no other is given"),
                  text_key("machine_data", "",
                           "machine data, relative to the folder of this file; used if no other are given"),
                  number_key("clearance_mm", machine::kNotNegative, "0.0",
                             "report bodies that come closer; 0: only contacts")}},
        table_schema("frame", "a named frame", {name(), attached_to(), position_keys()}),
        table_schema("object", "a body around the machine, or on it",
                     {name(),
                      choice_key("role", "\"fixture\"", {"workpiece", "fixture"},
                                 "kind of body; a jet may cut a workpiece"),
                      attached_to(), form(), position_keys()}),
        table_schema(
            "shape", "a body on a part of the machine",
            {name(),
             required(text_key("on", "", "\"base\", the letter of an axis, \"tool\", \"work\" or \"jet\"")),
             form(), position_keys()}),
        within("frame", "frame", "position of the frame", machine::frame_schema()),
        within("object", "shape", "shape of the body", machine::shape_schema()),
        within("object", "frame", "position of the body", machine::frame_schema()),
        within("shape", "shape", "shape of the body", machine::shape_schema()),
        within("shape", "frame", "position of the body", machine::frame_schema()),
    };
}

}  // namespace gsim::cell
