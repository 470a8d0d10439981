#pragma once

#include <httplib.h>

#include "base/os/rooted_directory.h"
#include "studio/server/folder_changes.h"

namespace gsim::studio {

/// Handler of a page's requests for the served folder: list of files, their bytes, changes by other programs,
/// and saving (docs/studio.md). Calls may come from several threads.
class FolderRequestHandler {
  public:
    explicit FolderRequestHandler(const os::RootedDirectory& folder) : folder_(folder), changes_(folder) {}

    void list(httplib::Response& response) const;
    void read(const std::string& name, httplib::Response& response) const;
    void write(const std::string& name, const httplib::Request& request, httplib::Response& response,
               const httplib::ContentReader& content) const;
    void changes(const httplib::Request& request, httplib::Response& response);

  private:
    os::RootedDirectory folder_;
    FolderChanges changes_;
};

}  // namespace gsim::studio
