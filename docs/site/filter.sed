# Doxygen takes # and \ in comments for its own.
s/namespace CAROM_PUBLIC /namespace /
s|docs/\([a-z]*\)\.md#[a-z-]*|<a href="../\1/">docs/\1.md</a>|g
/\/\/\//s/\\/\\\\/g
