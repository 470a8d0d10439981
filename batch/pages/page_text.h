#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "batch/pages/nightly_report.h"

namespace gsim::batch {

// Building blocks of pages. All of it is XML, so that a strict reader accepts it.

/// Escapes untrusted text for use between tags or in quotation marks: it contains no tag, and characters that
/// change its direction or move a cursor are written out.
std::string escape_html(std::string_view text);

std::string link(std::string_view address, std::string_view text);

/// Returns a database time as markup.
std::string time_markup(std::string_view utc);
/// Returns a time without its unit.
std::string seconds(double time_s);
/// Returns the time of a run that has one, else a dash.
std::string time_text(const RunSummary& run);
/// Returns a difference with its sign, in seconds and as a share of the first time.
std::string difference(double before_s, double now_s);
/// Returns a count with its noun: "3 runs", "1 run".
std::string count_text(std::size_t count, std::string_view one, std::string_view many);
/// Returns "batch 12 (2026-11-27 03:00 UTC)", as plain text for use in titles.
std::string batch_label(const BatchSummary& batch);
std::string plain_batch_label(const BatchSummary& batch);

/// Returns status and cause.
std::string outcome(const RunSummary& run);
/// Returns the message and source location of the first error; empty if the run has none.
std::string first_error(const RunSummary& run);

/// Returns the machine by the name used in the call.
std::string machine_label(std::string_view machine);
/// Returns "key = value, ..." for settings in JSON; empty if the list is empty.
std::string settings_text(const std::string& settings);
/// Returns the address of a case's details.
std::string case_address(const Case& of, std::string_view page);

/// Table with a heading for each column; the first cell of a row is its heading. Cells are markup.
class HtmlTable {
  public:
    HtmlTable(std::string_view label, const std::vector<std::string_view>& columns);
    void add(const std::vector<std::string>& cells);
    std::string text() const { return text_ + "</tbody></table></div>\n"; }

  private:
    std::string text_;
};

/// Returns names and values as markup.
std::string definition_list(const std::vector<std::pair<std::string_view, std::string>>& entries);

/// Returns the mark that identifies a page as one of ours: it is at the top of the page, with the name of its
/// file.
std::string page_marker(std::string_view name);
/// Returns a complete page. The title is text; trail and body are markup, the trail (links above the title)
/// may be empty.
std::string full_page(std::string_view name, std::string_view title, std::string_view breadcrumbs,
                      std::string_view body);

}  // namespace gsim::batch
