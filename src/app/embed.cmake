# Turns files into a C++ source that defines app::SYMBOL, their names and bytes (embedded.hpp):
#   cmake "-DINPUTS=a.ttf;b.ttf" -DOUTPUT=fonts.cpp -DSYMBOL=fonts -P embed.cmake
set(arrays "")
set(entries "")
set(number 0)
foreach(input IN LISTS INPUTS)
  file(READ "${input}" bytes HEX)
  string(REGEX REPLACE "(................................)" "\\1\n" bytes "${bytes}")
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
  get_filename_component(name "${input}" NAME)
  string(APPEND arrays "constexpr unsigned char bytes_${number}[] = {\n${bytes}\n};\n")
  string(APPEND entries "  {\"${name}\", bytes_${number}},\n")
  math(EXPR number "${number} + 1")
endforeach()
file(WRITE "${OUTPUT}" "#include \"app/base/embedded.hpp\"\n
namespace {
${arrays}
constexpr app::Embedded files[] = {
${entries}};
}\n
constinit const std::span<const app::Embedded> app::${SYMBOL}{files};
")
