#pragma once

/// Marks the public symbols of a shared library, whatever visibility it is compiled with.
#define CAROM_PUBLIC [[gnu::visibility("default")]]
