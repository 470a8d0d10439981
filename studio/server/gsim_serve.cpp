// gsim-serve: serves the page of the studio; gsim studio starts it.
//
//     gsim-serve '{"folder": ..., "port": 0, "page": FILE, "page_data": {...}, "engine": [COMMAND...],
//     "browser": true}'
//
// The address of the page is the first line on standard output; a signal ends it.

#include "studio/server/serve.h"

int main(int count, char** values) {
    return gsim::studio::serve_page(count == 2 ? values[1] : "");
}
