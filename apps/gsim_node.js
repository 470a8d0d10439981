// Before the program begins, in node: newer ones have fetch(), by which emscripten 3.1.6 would load files, which fetch() does not.
Module["wasmBinary"] = require("fs").readFileSync(__dirname + "/gsim.wasm");
