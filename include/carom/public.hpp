#pragma once

/// What a shared library shows, whatever the visibility that it is compiled with.
#define CAROM_PUBLIC [[gnu::visibility("default")]]
