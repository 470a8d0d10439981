#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "batch/pages/night.h"

namespace gsim::batch {

// What pages are written with. All of it is XML, so that a strict reader takes it.

/// A text of others between tags, or in quotation marks: nothing in it is a tag, and what would turn its
/// direction or move a cursor is written out.
std::string shown(std::string_view text);

std::string link(std::string_view address, std::string_view text);

/// A moment as the database has it, as markup.
std::string moment(std::string_view utc);
/// A time without its unit.
std::string seconds(double time_s);
/// The time of a run that has one, else a dash.
std::string time_of(const RunFacts& run);
/// A difference with its sign, in seconds and as a share of the first time.
std::string difference(double before_s, double now_s);
/// "3 runs", "1 run".
std::string counted(std::size_t count, std::string_view one, std::string_view many);
/// "batch 12 (2026-11-27 03:00 UTC)"; as plain text it goes into titles.
std::string named(const BatchFacts& batch);
std::string plainly_named(const BatchFacts& batch);

/// Status and cause.
std::string outcome(const RunFacts& run);
/// The sentence of the first fault and its place; nothing where there is none.
std::string first_fault(const RunFacts& run);

/// A machine by the name that it was called by.
std::string machine_named(std::string_view machine);
/// "key = value, ..." of settings as JSON; nothing where there are none.
std::string settings_in(const std::string& settings);
/// Where a case is told of.
std::string address_of(const Case& of, std::string_view page);

/// A table with a heading for each column; the first cell of a row is its heading. Cells are markup.
class TableText {
  public:
    TableText(std::string_view label, const std::vector<std::string_view>& columns);
    void add(const std::vector<std::string>& cells);
    std::string text() const { return text_ + "</tbody></table></div>\n"; }

  private:
    std::string text_;
};

/// Names and values, as markup.
std::string list_of(const std::vector<std::pair<std::string_view, std::string>>& entries);

/// By what a page is known as one of ours: it stands at its head, with the name of its file.
std::string mark_of_page(std::string_view name);
/// A whole page. The title is text; trail and body are markup, the trail (links above the title) may be
/// empty.
std::string whole_page(std::string_view name, std::string_view title, std::string_view trail,
                       std::string_view body);

}  // namespace gsim::batch
