#pragma once

namespace carom {

/// The vector instructions that steps are computed with on this machine: "AVX2", "SSE2", or
/// "portable" for what the compiler makes of the others'. The bits are the same with all.
const char* vector_instructions();

}  // namespace carom
