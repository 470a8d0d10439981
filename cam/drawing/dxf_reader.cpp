#include "cam/drawing/dxf_reader.h"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "base/units.h"
#include "cam/drawing/dxf_groups.h"
#include "cam/drawing/dxf_shapes.h"
#include "cam/drawing/dxf_units.h"

namespace gsim::drawing {

using geometry::Point;

namespace {

constexpr int kMaxBlockDepth = 16;                       // of blocks in blocks
constexpr std::size_t kMaxInsertedEntities = 1'000'000;  // entities, in all

struct Block {
    Point base;
    GroupReader content;
};

// The position of the entities of a block or of the drawing.
struct Placement {
    Affine map;
    std::string_view layer;  // of what is on layer 0 of a block; empty in the drawing itself
    int depth = 0;
};

class DxfReader {
  public:
    DxfReader(std::string_view text, const ReadOptions& options)
        : text_(text), options_(options), pen_(drawing_.drawn_contours, options.tolerance_mm) {}

    Drawing run() {
        if (text_.starts_with("AutoCAD Binary DXF")) {
            throw error_at(1, "the file is a binary DXF file; save it as text (ASCII)");
        }
        GroupReader reader(text_);
        bool ended = false;
        while (const auto group = reader.next()) {
            ended = group->code == 0 && group->value == "EOF";
            if (ended) break;
            if (group->code == 0 && group->value == "SECTION") read_section(reader);
        }
        if (!ended)
            throw error_at(reader.line(), "the file ends without EOF: it is truncated, or not a DXF file");
        if (!entities_) throw error_at(reader.line(), "the section ENTITIES is missing");
        // Units, layers and blocks may be anywhere in the file, so the entities are drawn last.
        const double unit_mm = options_.unit_mm > 0 ? options_.unit_mm : dxf_unit_mm(unit_code_);
        read_entities(*entities_, {scaled(unit_mm, unit_mm), "", 0});
        for (const auto& [kind, count] : skipped_) {
            drawing_.notes.push_back(fmt::format("not cut: {} {}", count, kind));
        }
        return std::move(drawing_);
    }

  private:
    void read_section(GroupReader& reader) {
        const auto name = reader.next();
        if (!name || name->code != 2) throw error_at(reader.line(), "a section has no name");
        if (name->value == "ENTITIES") entities_ = reader;
        const bool has_tables = name->value == "TABLES";
        const bool has_blocks = name->value == "BLOCKS";
        const bool is_header = name->value == "HEADER";
        GroupList list;
        while (const auto group = reader.next()) {
            if (group->code == 0 && group->value == "ENDSEC") return;
            if (is_header && group->code == 9 && group->value == "$INSUNITS") read_unit(reader);
            if (group->code != 0) continue;
            if (has_tables && group->value == "LAYER") {
                list.read(*group, reader);
                read_layer(list);
            }
            if (has_blocks && group->value == "BLOCK") {
                list.read(*group, reader);
                const Point base{list.number(10, 0), list.number(20, 0)};
                blocks_.insert_or_assign(std::string(list.text(2).value_or("")), Block{base, reader});
            }
        }
        throw error_at(reader.line(),
                       fmt::format("section {} does not end: the file is truncated", name->value));
    }

    void read_unit(GroupReader& reader) {
        if (const auto value = reader.next(); value && value->code == 70) {
            unit_code_ = static_cast<int>(std::clamp(parse_number(*value), -1.0, 1000.0));
        }
    }

    void read_layer(const GroupList& layer) {
        const bool is_frozen = (layer.integer_or(70, 0) & 1) != 0;
        const bool is_off = layer.integer_or(62, 7) < 0;
        if (is_frozen || is_off) hidden_layers_.emplace(layer.text(2).value_or(""));
    }

    // Reads until the end of the section or block.
    void read_entities(GroupReader reader, const Placement& placement) {
        GroupList entity;
        while (const auto group = reader.next()) {
            if (group->code != 0) continue;
            if (group->value == "ENDSEC" || group->value == "ENDBLK") return;
            entity.read(*group, reader);
            std::vector<GroupList> vertices;
            if (entity.kind() == "POLYLINE") vertices = read_vertices(reader);
            if (++entity_count_ > kMaxInsertedEntities) {
                throw error_at(entity.line(),
                               fmt::format("more than {} entities, including each insertion of a block",
                                           kMaxInsertedEntities));
            }
            if (is_selected(entity, placement)) read_entity(entity, vertices, placement);
        }
    }

    static std::vector<GroupList> read_vertices(GroupReader& reader) {
        std::vector<GroupList> vertices;
        while (const auto group = reader.peek()) {
            if (group->code != 0 || group->value != "VERTEX") break;
            reader.next();
            vertices.emplace_back().read(*group, reader);
        }
        return vertices;
    }

    std::string_view entity_layer(const GroupList& entity, const Placement& placement) const {
        const std::string_view layer = entity.text(8).value_or("0");
        return layer == "0" && !placement.layer.empty() ? placement.layer : layer;
    }

    bool is_selected(const GroupList& entity, const Placement& placement) const {
        const bool in_paper_space = entity.integer_or(67, 0) == 1;
        const bool is_invisible = entity.integer_or(60, 0) == 1;
        if (in_paper_space || is_invisible) return false;
        const std::string_view layer = entity_layer(entity, placement);
        if (hidden_layers_.contains(layer) || layer == "DEFPOINTS" || layer == "Defpoints") return false;
        // The contents of an inserted block have their own layers.
        return options_.layers.empty() || entity.kind() == "INSERT" ||
               std::find(options_.layers.begin(), options_.layers.end(), layer) != options_.layers.end();
    }

    void read_entity(const GroupList& entity, const std::vector<GroupList>& vertices,
                     const Placement& placement) {
        if (entity.kind() == "INSERT") {
            insert(entity, placement);
        } else if (entity.kind() == "POLYLINE") {
            draw_polyline(entity, vertices, placement.map, add_source(entity), pen_);
        } else if (is_shape(entity.kind())) {
            draw_shape(entity, placement.map, add_source(entity), pen_);
        } else if (entity.kind() != "SEQEND" && entity.kind() != "ATTRIB" && entity.kind() != "VIEWPORT") {
            ++skipped_[std::string(entity.kind())];
        }
    }

    std::uint32_t add_source(const GroupList& entity) {
        drawing_.entities.push_back(
            {std::string(entity.kind()), std::string(entity.text(5).value_or("")), entity.line()});
        return static_cast<std::uint32_t>(drawing_.entities.size() - 1);
    }

    void insert(const GroupList& entity, const Placement& placement) {
        const std::string name(entity.text(2).value_or(""));
        const auto block = blocks_.find(name);
        if (block == blocks_.end()) {
            throw error_at(entity.line(),
                           fmt::format("INSERT of block '{}', which is not defined in the file", name));
        }
        if (placement.depth >= kMaxBlockDepth) {
            throw error_at(
                entity.line(),
                fmt::format("INSERT of block '{}' is nested deeper than {} blocks; does one contain itself?",
                            name, kMaxBlockDepth));
        }
        const int columns = std::max(1, entity.integer_or(70, 1));
        const int rows = std::max(1, entity.integer_or(71, 1));
        if (static_cast<double>(columns) * rows > static_cast<double>(kMaxInsertedEntities)) {
            throw error_at(entity.line(), fmt::format("INSERT of block '{}' has {} rows of {}: too many",
                                                      name, rows, columns));
        }
        const Point step{entity.number(44, 0), entity.number(45, 0)};
        const Affine block_transform = placement.map * ocs_to_wcs(entity) * moved(entity.point(10)) *
                                       turned(entity.number(50, 0) * kRadPerDeg);
        const Affine shape =
            scaled(entity.number(41, 1), entity.number(42, 1)) * moved(-1.0 * block->second.base);
        for (int row = 0; row < rows; ++row) {
            for (int column = 0; column < columns; ++column) {
                read_entities(block->second.content,
                              {block_transform * moved({column * step.x, row * step.y}) * shape,
                               entity_layer(entity, placement), placement.depth + 1});
                ++entity_count_;  // so that arrays of empty blocks end
                if (entity_count_ > kMaxInsertedEntities) return;
            }
        }
    }

    std::string_view text_;
    const ReadOptions& options_;
    Drawing drawing_;
    Pen pen_;
    int unit_code_ = 0;
    std::set<std::string, std::less<>> hidden_layers_;  // layers
    std::map<std::string, Block, std::less<>> blocks_;
    std::optional<GroupReader> entities_;
    std::map<std::string, std::size_t> skipped_;
    std::size_t entity_count_ = 0;
};

}  // namespace

Result<Drawing> read_dxf(std::string_view text, const ReadOptions& options) {
    try {
        return DxfReader(text, options).run();
    } catch (const Error& error) {
        const auto line = std::max(1U, error.line);  // an empty file ends in its first
        return Unexpected(fmt::format("line {}: {}", line, error.message));
    }
}

}  // namespace gsim::drawing
