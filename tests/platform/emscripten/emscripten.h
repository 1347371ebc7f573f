#pragma once

// Stands in for Emscripten's header where the browser's code is compiled natively: a test defines
// the functions that the page has in JavaScript.
#define EM_JS(result, name, parameters, ...) result name parameters;
